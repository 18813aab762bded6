// Roughness as small as the wavelength: the share of its spectrum that is seen, polarisation, and
// the energy of the diffracted lobe.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/golden.h"
#include "chi2/quadrature.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

float cosineOf(float sine) { return std::sqrt((1.0f - sine) * (1.0f + sine)); }

TEST(NanoRoughness, VisibleShareMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_hp2017.csv");
    GP_SKIP_WITHOUT(rows, "golden_hp2017.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        if (!row.at("quantity").starts_with("sigma_rel2/sigma_s2")) continue;
        const float golden = number(row, "value");
        const float share = nano_visible_share(cosineOf(number(row, "arg1")), number(row, "arg2"),
                                               number(row, "arg3"));
        EXPECT_NEAR(share, golden, 1e-3f * golden + 1e-5f)
            << row.at("arg1") << " " << row.at("arg2") << " " << row.at("arg3");
        ++compared;
    }
    EXPECT_GE(compared, 123);
}

TEST(NanoRoughness, MicroDistributionMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_hp2017.csv");
    GP_SKIP_WITHOUT(rows, "golden_hp2017.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        if (!row.at("quantity").starts_with("EPD")) continue;
        const float cosM = number(row, "arg1");
        const float beta = number(row, "arg2");
        // Some are 0 in float, and too small for a float's text.
        const double golden = std::strtod(row.at("value").c_str(), nullptr);
        const double d = double(exponential_power_d(vec3(cosineOf(cosM), 0.0f, cosM), beta,
                                                    number(row, "arg3")));
        // In the tail an error of the slope counts p (tan^2 / beta^2)^p fold: with cosines given to
        // float's digits, some 1e-5 of the exponent.
        const double tan2 = 1.0 / (double(cosM) * double(cosM)) - 1.0;
        const double exponent = std::pow(tan2 / (double(beta) * double(beta)),
                                         double(number(row, "arg3")));
        EXPECT_NEAR(d, golden, (1e-3 + 1e-4 * exponent) * golden + 1e-5)
            << row.at("arg1") << " " << row.at("arg2") << " " << row.at("arg3");
        ++compared;
    }
    EXPECT_GE(compared, 50);
}

// The integral of the spectrum over the directions above the horizon, in double, as it is written:
// over the unit circle of projected directions, not around the spectrum's centre as we have it.
double shareByBruteForce(double sinO, double b, double c) {
    // Between the centre's place in the circle and the rim, where the spectrum may be narrow.
    const QuadratureTolerance tolerance{1e-7, 1e-10};
    return integratePieces([&](double x) {
        const double edge = std::sqrt(std::max(1.0 - x * x, 0.0));
        return 2.0 * integratePieces([&](double y) {
            const double f2 = (x + sinO) * (x + sinO) + y * y;
            return (c - 1.0) * b * b / (2.0 * M_PI) * std::pow(1.0 + b * b * f2, -0.5 * (c + 1.0));
        }, 0.0, edge, {0.3 / b, 3.0 / b}, tolerance, 10);
    }, -1.0, 1.0, {-sinO, -sinO - 1.0 / b, -sinO + 1.0 / b, -sinO + 5.0 / b}, tolerance, 10);
}

TEST(NanoRoughness, VisibleShareIsItsIntegral) {
    Random random(51);
    double worst = 0.0;
    for (int i = 0; i < 60; ++i) {
        const double sinO = std::sqrt(double(random.uniform()));
        const double b = 0.1 * std::pow(200.0, double(random.uniform()));
        const double c = 1.1 + 3.9 * double(random.uniform());
        const double exact = shareByBruteForce(sinO, b, c);
        const double share = double(nano_visible_share(cosineOf(float(sinO)), float(b), float(c)));
        EXPECT_NEAR(share, exact, 1e-3 * exact) << sinO << " " << b << " " << c;
        worst = std::max(worst, std::abs(share / exact - 1.0));
    }
    fmt::print("visible share: largest relative error {:.1e}\n", worst);
}

// Models take the largest share of several angles as that of the smallest.
TEST(NanoRoughness, VisibleShareFallsWithTheAngle) {
    for (const float b : {0.1f, 1.0f, 5.0f, 20.0f}) {
        for (const float c : {1.1f, 2.0f, 5.0f}) {
            for (float cosine = 0.0f; cosine < 0.95f; cosine += 0.05f) {
                EXPECT_LE(nano_visible_share(cosine, b, c),
                          nano_visible_share(cosine + 0.05f, b, c) + 2e-6f) << b << " " << c;
            }
        }
    }
}

TEST(NanoRoughness, LobeReturnsWhatTheMirrorLoses) {
    // The lobe over its visible share is normalised over directions for every angle.
    for (const float cosO : {1.0f, 0.6f, 0.1f}) {
        for (const float b : {0.5f, 2.0f, 8.0f}) {
            const float c = 2.0f;
            const double sinO = double(cosineOf(cosO));
            const double lobe = shareByBruteForce(sinO, double(b), double(c))
                              / double(nano_visible_share(cosO, b, c));
            EXPECT_NEAR(lobe, 1.0, 1e-3) << cosO << " " << b;
        }
    }
    // A smooth surface keeps everything in the mirror, a rough one nothing.
    EXPECT_EQ(nano_specular_share(0.0f, 1.0f, 1.0f), 1.0f);
    EXPECT_NEAR(nano_specular_share(0.01f, 1.0f, 1.0f), std::exp(-0.0157914f), 1e-5f);
    EXPECT_LT(nano_specular_share(0.5f, 1.0f, 1.0f), 1e-15f);
}

// The mean of the spectrum over the slopes of facets, by quadrature over u = P(slope), in double;
// the slopes are those of exponential_power_sample_tan2, paraxial.
double blurredSpectrum(double f, double b, double c, double beta, double p) {
    double sum = 0.0;
    const int n = 4000, turns = 48;
    for (int i = 0; i < n; ++i) {
        const double slope = 2.0 * std::sqrt(double(exponential_power_sample_tan2(
            float(beta), float(p), (float(i) + 0.5f) / float(n))));
        for (int j = 0; j < turns; ++j) {
            const double phi = M_PI * (j + 0.5) / turns;
            const double f2 = f * f + slope * slope - 2.0 * f * slope * std::cos(phi);
            sum += (c - 1.0) * b * b / (2.0 * M_PI) * std::pow(1.0 + b * b * f2, -0.5 * (c + 1.0));
        }
    }
    return sum / (double(n) * turns);
}

// Its stand-in has the peak of the convolution, and a shape that is near.
TEST(NanoRoughness, BlurIsAConvolution) {
    double peak = 0.0, half = 0.0;
    for (const double c : {1.5, 2.0, 3.0}) {
        for (const double p : {0.5, 1.0, 2.0}) {
            for (const double ratio : {0.1, 0.5, 1.0, 3.0}) {
                const double b = 2.0, beta = 0.5 * ratio / b;
                const double blurred = double(nano_blurred_length(float(b), float(c), float(beta),
                                                                  float(p)));
                const auto ours = [&](double f) {
                    return double(nano_spectrum(float(f * f), float(blurred), float(c)));
                };
                peak = std::max(peak, std::abs(ours(0.0) / blurredSpectrum(0.0, b, c, beta, p)
                                               - 1.0));
                // Where ours is at half of its peak.
                const double at = std::sqrt(std::pow(2.0, 2.0 / (c + 1.0)) - 1.0) / blurred;
                half = std::max(half, std::abs(ours(at) / blurredSpectrum(at, b, c, beta, p)
                                               - 1.0));
            }
        }
    }
    fmt::print("blurred lobe against the convolution: {:.3f} at the peak, {:.2f} at its half\n",
               peak, half);
    EXPECT_LT(peak, 0.02);
    EXPECT_LT(half, 0.36);
}

// Samples of the spectrum fall within a distance as often as it says.
TEST(NanoRoughness, SamplesFollowTheSpectrum) {
    Random random(53);
    for (const float c : {1.3f, 2.0f, 4.0f}) {
        int within = 0;
        const int n = 100'000;
        for (int i = 0; i < n; ++i) {
            const float x = random.uniform();
            const vec2 f = nano_spectrum_sample(1.5f, c, vec2(x, random.uniform()));
            within += dot(f, f) < 0.64f ? 1 : 0;
        }
        const double expected = 1.0 - double(nano_spectrum_beyond(0.64f, 1.5f, c));
        EXPECT_NEAR(double(within) / n, expected, 0.007) << c;
    }
}

// Half the sum of |Q|^2 is F in the mirror direction. The authors' whole sum would be 2 F: a lobe
// that is normalised and as bright as 2 (1 - A) F returns more than the mirror lost, which we show
// with the numbers of a metal.
TEST(NanoRoughness, PolarisationIsFresnelInTheMirrorDirection) {
    for (const vec2 ior : {vec2(1.5f, 0.0f), vec2(0.2f, 3.4f), vec2(2.9f, 3.1f)}) {
        for (const float cosO : {1.0f, 0.7f, 0.3f, 0.05f}) {
            const float f = fresnel_conductor(cosO, vec3(ior.x), vec3(ior.y)).x;
            const float q = nano_polarisation(ior, cosO, cosO, 1.0f);
            EXPECT_NEAR(q, f, 2e-4f * f + 1e-6f) << ior.x << " " << cosO;
        }
    }
    // A = 0.2: what must be in the lobe for silver at normal incidence is 0.8 F.
    const float f = fresnel_conductor(1.0f, vec3(0.05f), vec3(3.9f)).x;
    const float q = nano_polarisation(vec2(0.05f, 3.9f), 1.0f, 1.0f, 1.0f);
    EXPECT_NEAR(0.2f * f + 0.8f * q, f, 1e-3f);
    EXPECT_GT(0.2f * f + 0.8f * 2.0f * q, 1.7f);
}

TEST(NanoRoughness, PolarisationIsReciprocal) {
    Random random(52);
    for (int i = 0; i < 20'000; ++i) {
        const vec2 ior(0.1f + 3.0f * random.uniform(), 4.0f * random.uniform());
        const float a = random.uniform(), b = random.uniform();
        const float phi = 2.0f * random.uniform() - 1.0f;
        const float there = nano_polarisation(ior, a, b, phi);
        const float back = nano_polarisation(ior, b, a, phi);
        ASSERT_NEAR(there, back, 1e-4f * there + 1e-7f);
        ASSERT_TRUE(std::isfinite(there) && there >= 0.0f);
    }
}

}  // namespace
}  // namespace gp::test
