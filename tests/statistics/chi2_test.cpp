// The harness itself: it must pass what is right and catch what is slightly wrong.
#include "statistics/chi2.h"

#include <gtest/gtest.h>

#include "shading/shading.h"

namespace gp::test {
namespace {

using namespace gp::shading;

vec2 uniform2(Random& random) {
    const float x = random.uniform();
    return vec2(x, random.uniform());
}

TEST(Chi2, IncompleteGammaHasKnownValues) {
    EXPECT_NEAR(gammaQ(0.5, 0.5), std::erfc(std::sqrt(0.5)), 1e-14);
    EXPECT_NEAR(gammaQ(1.0, 3.0), std::exp(-3.0), 1e-14);
    // The 1 % point of chi-square with 10 degrees of freedom, from the usual tables.
    EXPECT_NEAR(gammaQ(5.0, 0.5 * 23.209251), 0.01, 1e-8);
    EXPECT_NEAR(gammaQ(450.0, 450.0), 0.4937, 1e-3);
}

TEST(Chi2, QuadratureHandlesKinksAndPeaks) {
    const double arc = integrate([](double x) { return std::sqrt(x); }, 0.0, 1.0, {1e-9, 0.0}, 40);
    EXPECT_NEAR(arc, 2.0 / 3.0, 1e-9);
    const double peak = integrate([](double x) { return 1e-3 / (x * x + 1e-6); }, -1.0, 1.0,
                                  {1e-9, 0.0}, 40);
    EXPECT_NEAR(peak, 2.0 * std::atan(1000.0), 1e-7);
    const double step = integratePieces([](double x) { return x < 0.3 ? 1.0 : 2.0; }, 0.0, 1.0,
                                        {0.3}, {1e-9, 0.0});
    EXPECT_NEAR(step, 1.7, 1e-12);
}

TEST(Chi2, PassesCosineHemisphere) {
    Chi2Options options;
    options.name = "harness cosine";
    const Chi2Result result = chi2Sphere(options, {}, [](Random& random) {
        return square_to_cosine_hemisphere(uniform2(random));
    }, [](vec3 w) { return cosine_hemisphere_pdf(w); });
    EXPECT_TRUE(result.passed) << result.message;
    EXPECT_GT(result.degrees, 400u);
    EXPECT_NEAR(result.pdfIntegral, 1.0, 1e-4);
    EXPECT_EQ(result.acceptedFraction, 1.0);
}

TEST(Chi2, ResolvesLobesOfATenThousandthRadian) {
    Chi2Options options;
    options.name = "harness narrow lobe";
    const double size = 5e-9;  // the mean of 1 - cos; the angle is 1e-4 rad
    const Frame frame = frame_from_normal(normalize(vec3(0.6f, 0.3f, 0.5f)));
    const auto sample = [&](Random& random) {
        const double s = -size * std::log1p(-static_cast<double>(random.uniform()));
        const float r = static_cast<float>(std::sqrt(s * (2.0 - s)));
        const float phi = TWO_PI * random.uniform();
        return world_from_local(frame, vec3(r * std::cos(phi), r * std::sin(phi),
                                            static_cast<float>(1.0 - s)));
    };
    const auto pdfOfSize = [&](double mean) {
        return [&, mean](vec3 w) {
            const dvec3 d = dvec3(w) - dvec3(frame.n);
            return std::exp(-0.5 * dot(d, d) / mean) / (2.0 * M_PI * mean);
        };
    };
    const Chi2Result right = chi2Sphere(options, {}, sample, pdfOfSize(size));
    EXPECT_TRUE(right.passed) << right.message;
    EXPECT_GT(right.degrees, 400u);
    EXPECT_NEAR(right.pdfIntegral, 1.0, 2e-3);
    options.name = "harness narrow lobe, wrong on purpose";
    EXPECT_FALSE(chi2Sphere(options, {}, sample, pdfOfSize(1.02 * size)).passed);
}

TEST(Chi2, CatchesAWrongDensity) {
    Chi2Options options;
    options.name = "harness, wrong on purpose";
    const Chi2Result result = chi2Sphere(options, {}, [](Random& random) {
        return square_to_cosine_hemisphere(uniform2(random));
    }, [](vec3 w) { return w.z > 0.0f ? std::pow(w.z, 1.05f) * (2.05f / 6.28318530f) : 0.0f; });
    EXPECT_FALSE(result.passed);
    EXPECT_NEAR(result.pdfIntegral, 1.0, 1e-3);
}

TEST(Chi2, CatchesALossOfSamples) {
    Chi2Options options;
    options.name = "harness, loses samples on purpose";
    const Chi2Result result = chi2Sphere(options, {}, [](Random& random) {
        const vec3 w = square_to_uniform_sphere(uniform2(random));
        return random.uniform() < 0.002f ? vec3(0.0f) : w;
    }, [](vec3) { return uniform_sphere_pdf(); });
    EXPECT_FALSE(result.passed);
    EXPECT_NEAR(result.acceptedFraction, 0.998, 3e-4);
}

TEST(Chi2, RectangleWithACurvedEdge) {
    Chi2Options options;
    options.name = "harness disk";
    const auto sample = [](Random& random) { return square_to_concentric_disk(uniform2(random)); };
    const auto pdf = [](vec2 p) { return dot(p, p) <= 1.0f ? concentric_disk_pdf() : 0.0f; };
    const auto edge = [](double x) {
        const double y = std::sqrt(std::max(0.0, 1.0 - x * x));
        return std::vector<double>{-y, y};
    };
    const Chi2Result right = chi2Rectangle(options, dvec2(-1), dvec2(1), sample, pdf, edge);
    EXPECT_TRUE(right.passed) << right.message;
    EXPECT_NEAR(right.pdfIntegral, 1.0, 1e-3);
    options.name = "harness disk, wrong on purpose";
    const auto radial = [](Random& random) {
        const vec2 u = uniform2(random);
        return vec2(u.x * std::cos(6.28318f * u.y), u.x * std::sin(6.28318f * u.y));
    };
    EXPECT_FALSE(chi2Rectangle(options, dvec2(-1), dvec2(1), radial, pdf, edge).passed);
}

}  // namespace
}  // namespace gp::test
