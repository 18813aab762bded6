// What V-cavities reflect, by the table that glints are prepared by, against the quadrature.
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/microfacet/cavity_albedo.glsl"
#include "shading/microfacet/mirror_albedo.glsl"
GP_SHADING_END

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

GgxAlbedo quadrature(float alpha, float cosine) {
    Distribution d{};
    d.kind = DISTRIBUTION_BECKMANN;
    d.alpha_x = d.alpha_y = alpha;
    d.shape = 2;
    return mirror_albedo(d, MASKING_V_CAVITY, cosine);
}

TEST(CavityAlbedo, IsTheQuadraturesAtEveryWidth) {
    Random random(3);
    double worst = 0, sum = 0;
    const int n = longTests() ? 20000 : 2000;
    for (int i = 0; i < n; ++i) {
        const float alpha = 1e-3f * std::pow(2000.0f, random.uniform());
        const float root = 0.1f + 0.9f * random.uniform();
        const float f0 = 0.36f * random.uniform();  // up to an index of 4
        const double expected =
            double(ggx_albedo_fresnel(quadrature(alpha, root * root), f0, 1.0f));
        const double error =
            std::abs(double(chebyshev_value(cavity_albedo(alpha, f0), root)) - expected);
        worst = std::max(worst, error), sum += error / n;
        ASSERT_LT(error, 0.02) << alpha << ' ' << root << ' ' << f0;
    }
    fmt::print("cavities' albedo: mean error {:.4f}, largest {:.4f}\n", sum, worst);
    EXPECT_LT(sum, 0.0015);
}

// Between its widths it is what it is at them: no step, and nothing beyond the ends.
TEST(CavityAlbedo, AveragesAreTheHemispheres) {
    for (const float alpha : {1e-5f, 0.01f, 0.07f, 0.3f, 0.31f, 1.0f, 2.0f, 50.0f}) {
        const Chebyshev c = cavity_albedo(alpha, 0.04f);
        double mean = 0;
        for (int i = 0; i < 400; ++i) {
            const float x = (float(i) + 0.5f) / 400.0f;
            mean += double(x * x * x * chebyshev_value(c, x)) / 100;
        }
        EXPECT_NEAR(double(cavity_albedo_average(c)), mean, 2e-5) << alpha;
        EXPECT_GT(mean, 0.01) << alpha;
        EXPECT_LT(mean, 0.087) << alpha;
    }
    // Of smooth facets Schlick's term: f0 + (1 - f0) / 21.
    const Chebyshev smooth = cavity_albedo(1e-3f, 0.04f);
    EXPECT_NEAR(double(cavity_albedo_average(smooth)), 0.04 + 0.96 * 2 / 42, 5e-4);
}

}  // namespace
}  // namespace gp::test
