// Tables of what one scattering loses, and the lobe that gives it back.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/albedo_quadrature.h"
#include "statistics/golden.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

uint surfaceOf(const GoldenRow& row) {
    const uint correlated = row.at("g2") == "heightcorr" ? 1u : 0u;
    return (row.at("ndf") == "beckmann" ? ROUGH_MIRROR_BECKMANN_SEPARABLE
                                        : ROUGH_MIRROR_GGX_SEPARABLE) + correlated;
}

TEST(MultipleScattering, AlbedoMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_albedo.csv");
    GP_SKIP_WITHOUT(rows, "golden_albedo.csv");
    double worst = 0.0;
    for (const GoldenRow& row : rows) {
        const float golden = number(row, "E");
        const float e = 1.0f - single_scattering_loss(surfaceOf(row), number(row, "mu"),
                                                      number(row, "alpha"));
        EXPECT_NEAR(e, golden, 1e-3f * golden + 1e-5f)
            << row.at("ndf") << " " << row.at("g2") << " " << row.at("alpha") << " "
            << row.at("mu");
        worst = std::max(worst, double(std::abs(e - golden)));
    }
    fmt::print("directional albedo: largest difference to golden values {:.1e}\n", worst);
    EXPECT_NEAR(1.0f - single_scattering_loss(ROUGH_MIRROR_GGX_CORRELATED, 1.0f, 1.0f),
                1.0f - std::log(2.0f), 1e-5f);
}

TEST(MultipleScattering, AverageMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_eavg.csv");
    GP_SKIP_WITHOUT(rows, "golden_eavg.csv");
    for (const GoldenRow& row : rows) {
        const float e = 1.0f - single_scattering_loss_average(surfaceOf(row), number(row, "alpha"));
        EXPECT_NEAR(e, number(row, "Eavg"), 2e-4f) << row.at("ndf") << " " << row.at("alpha");
    }
}

// Between the nodes, where the golden rows are not.
TEST(MultipleScattering, TablesKeepTheirErrors) {
    Random random(41);
    double worst = 0.0;
    for (int i = 0; i < (longTests() ? 2000 : 160); ++i) {
        const uint surface = static_cast<uint>(i % 4);
        const float alpha = std::max(1e-3f, random.uniform() * random.uniform());
        // Half of the cosines where albedo drops, half anywhere.
        const float narrow = 4.0f * alpha * random.uniform();
        const float cosO = i % 8 < 4 ? std::min(narrow, 1.0f) : random.uniform();
        if (cosO < 1e-3f * alpha) continue;
        const double exact = singleScatteringLoss(roughMirrors[surface], double(alpha),
                                                  double(cosO), 600, 300);
        const double table = double(single_scattering_loss(surface, cosO, alpha));
        EXPECT_NEAR(table, exact, 3e-4) << roughMirrors[surface].name << " " << alpha << " "
                                        << cosO;
        worst = std::max(worst, std::abs(table - exact));
    }
    fmt::print("directional albedo: largest difference to quadrature {:.1e}\n", worst);
}

// E + integral of f_ms cos = 1 for every distribution and masking, at every width and angle, by the
// tables and by the coefficients that a material has of them.
TEST(MultipleScattering, GivesBackWhatWasLost) {
    double worst = 0.0, toTable = 0.0;
    for (uint surface = 0; surface < 4; ++surface) {
        for (const float alpha : {0.001f, 0.01f, 0.03f, 0.07f, 0.2f, 0.33f, 0.5f, 0.77f, 1.0f}) {
            const ScatteringLoss losses = scattering_loss_of(surface, alpha);
            for (const float cosO : {0.005f, 0.05f, 0.3f, 0.7f, 1.0f}) {
                const float lost = single_scattering_loss(surface, cosO, alpha);
                const double back = M_PI * hemisphereAverage([&](double cosI) {
                    const float lossI = single_scattering_loss(surface, float(cosI), alpha);
                    return double(multiple_scattering(lost, lossI, losses.average));
                }, double(alpha));
                EXPECT_NEAR(1.0 - double(lost) + back, 1.0, 5e-4)
                    << roughMirrors[surface].name << " " << alpha << " " << cosO;
                worst = std::max(worst, std::abs(back - double(lost)));
                toTable = std::max(toTable, std::abs(double(scattering_loss(losses, cosO) - lost)));
            }
        }
    }
    fmt::print("white furnace: largest error {:.1e}; coefficients against tables {:.1e}\n", worst,
               toTable);
    EXPECT_LT(toTable, 3e-4);
}

TEST(MultipleScattering, SmoothSurfacesLoseNothing) {
    EXPECT_EQ(multiple_scattering(0.0f, 0.0f, 0.0f), 0.0f);
    for (uint surface = 0; surface < 4; ++surface) {
        for (const float alpha : {0.0f, 1e-6f, 1e-4f}) {
            const float average = single_scattering_loss_average(surface, alpha);
            const float loss = single_scattering_loss(surface, 0.5f, alpha);
            EXPECT_LT(loss, 1e-4f);
            EXPECT_LT(average, 1e-4f);
            const float f = multiple_scattering(loss, loss, average);
            EXPECT_TRUE(std::isfinite(f) && f >= 0.0f && f < 1e-3f);
        }
    }
}

// Light of this lobe was reflected twice or more: with constant reflectance F no more than F^2 of
// what F = 1 gives back may leave. The slides' factor, F E / (1 - F (1 - E)), breaks that.
TEST(MultipleScattering, ColourCountsTwoReflections) {
    for (const float f : {0.04f, 0.5f, 0.95f}) {
        for (const float loss : {0.01f, 0.1f, 0.6f}) {
            double sum = 0.0;
            double bounces = double(f) * double(f) * (1.0 - double(loss));
            for (int bounce = 2; bounce < 400; ++bounce) {
                sum += bounces;
                bounces *= double(f) * double(loss);
            }
            const float ours = multiple_scattering_color(vec3(f), loss).x;
            EXPECT_NEAR(double(ours), sum, 1e-5);
            EXPECT_LE(ours, f * f);
            const float slides = f * (1.0f - loss) / (1.0f - f * loss);
            if (f <= 0.5f) {
                EXPECT_GT(slides, f * f);
            }
            EXPECT_NEAR(double(slides) * double(f), sum, 1e-5);
        }
    }
    EXPECT_NEAR(multiple_scattering_color(vec3(1.0f), 0.3f).x, 1.0f, 1e-6f);
}

TEST(MultipleScattering, FresnelAveragesKeepTheirErrors) {
    double outside = 0.0, inside = 0.0;
    for (float eta = 1.0f; eta <= 3.0f; eta += 0.05f) {
        const auto averageOf = [](float ratio) {
            return hemisphereAverage([&](double mu) {
                return double(fresnel_dielectric(float(mu), ratio));
            }, 0.1);
        };
        outside = std::max(outside, std::abs(averageOf(eta)
                                             - double(fresnel_dielectric_average(eta))));
        inside = std::max(inside, std::abs(averageOf(1.0f / eta)
                                           - double(fresnel_dielectric_average(1.0f / eta))));
    }
    fmt::print("fits of the Fresnel average: {:.4f} outside, {:.4f} inside\n", outside, inside);
    EXPECT_LT(outside, 0.007);
    EXPECT_LT(inside, 0.001);
    const double schlick = hemisphereAverage([&](double mu) {
        return double(fresnel_schlick(0.2f, 0.9f, float(mu)));
    }, 0.1);
    EXPECT_NEAR(fresnel_schlick_average(vec3(0.2f), vec3(0.9f)).x, schlick, 1e-6);
}

// White base and dielectric mirror together are white, whatever the mirror.
TEST(MultipleScattering, CoupledDiffuseIsWhite) {
    for (const float eta : {1.3f, 1.5f, 2.0f}) {
        // A smooth mirror: its albedo is its Fresnel term.
        const double average = hemisphereAverage([&](double mu) {
            return 1.0 - double(fresnel_dielectric(float(mu), eta));
        }, 0.1);
        for (const float cosO : {0.05f, 0.4f, 1.0f}) {
            const float through = 1.0f - fresnel_dielectric(cosO, eta);
            const double diffuse = M_PI * hemisphereAverage([&](double mu) {
                const float in = 1.0f - fresnel_dielectric(float(mu), eta);
                return double(coupled_diffuse(vec3(1.0f), vec3(through), vec3(in),
                                              vec3(float(average))).x);
            }, 0.1);
            EXPECT_NEAR(diffuse + 1.0 - double(through), 1.0, 1e-4);
        }
    }
}

}  // namespace
}  // namespace gp::test
