// Light from all sides by a few slopes, against integrals over all of them.
#include <gtest/gtest.h>

#include "chi2/quadrature.h"
#include "water/slope_cases.h"

GP_SHADING_BEGIN
#include "shading/slope/slope_environment.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;

constexpr uint maskings[] = {SLOPE_MASKING_V_CAVITY, SLOPE_MASKING_SMITH};

// A sky that is brighter at the horizon, with the glow around a sun, over dark ground.
double radiance(vec3 w) {
    const double sky = 1.0 + 0.8 * (1.0 - double(w.z)) * (1.0 - double(w.z));
    const double glow = 3.0 * std::exp(4.0 * (double(dot(w, directionAt(60, 40))) - 1.0));
    return (sky + glow) / (1.0 + std::exp(-12.0 * double(w.z)));
}

double bySlopes(const Slopes& d, vec3 wo, uint n, uint masking, bool white) {
    double sum = 0.0;
    for (uint i = 0; i < n * n; ++i) {
        const SlopeLight light = slope_light(d, wo, n, i, masking);
        sum += double(light.weight) * (white ? 1.0 : radiance(light.wi));
    }
    return sum;
}

double byIntegral(const Slopes& d, vec3 wo, uint masking, bool white) {
    return meanOverSlopes(d, [&](vec2 s) {
        const vec3 wi = reflect(-wo, facet_of(s));
        const float g2 = masking == SLOPE_MASKING_SMITH
            ? slopes_smith_g2(d, wo, wi) : sheared_cavity_g2(d.mean, s, wo, wi);
        return double(std::max(slope_facing(s, wo), 0.0f) * g2) * (white ? 1.0 : radiance(wi));
    }, {250, 7.0}) / double(slope_facing(d.mean, wo));
}

TEST(SlopeEnvironment, NodesAreTheMeansOfEqualParts) {
    for (uint n = 3; n <= 5; ++n) {
        double total = 0.0;
        for (uint i = 0; i < n; ++i) {
            const NormalNode node = normal_node(n, i);
            const auto edge = [&](uint k) {
                return k == 0 ? -8.0 : k == n ? 8.0
                     : M_SQRT2 * double(erf_inverse(2.0f * float(k) / float(n) - 1.0f));
            };
            const auto density = [](double x) {
                return std::exp(-0.5 * x * x) / std::sqrt(2.0 * M_PI);
            };
            const double mean = integrate([&](double x) { return x * density(x); }, edge(i),
                                          edge(i + 1), {1e-9, 1e-9});
            EXPECT_NEAR(double(node.x), mean * n, 2e-6) << n << " " << i;
            EXPECT_NEAR(double(node.width) * density(double(node.x)), double(node.weight), 1e-6);
            total += double(node.weight);
        }
        EXPECT_NEAR(total, 1.0, 1e-6);
    }
}

// Where the direction goes when the slope moves, by differences.
TEST(SlopeEnvironment, SolidAnglesAreThoseOfTheReflections) {
    for (const SlopeCase& c : slopeCases(true)) {
        for (uint i = 0; i < 9; ++i) {
            const SlopeLight light = slope_light(c.slopes, c.wo, 3, i, SLOPE_MASKING_V_CAVITY);
            if (light.solid_angle <= 0.0f) continue;
            const dvec2 s(slope_of(light.wm));
            const auto wi = [&](dvec2 at) {
                const dvec3 m = normalize(dvec3(-at.x, -at.y, 1.0));
                return m * (2.0 * dot(m, dvec3(c.wo))) - dvec3(c.wo);
            };
            EXPECT_NEAR(length(wi(s) - dvec3(light.wi)), 0.0, 1e-5);
            const double e = 1e-4;
            const dvec3 dx = wi(s + dvec2(e, 0)) - wi(s - dvec2(e, 0));
            const dvec3 dy = wi(s + dvec2(0, e)) - wi(s - dvec2(0, e));
            const double per_area = length(cross(dx, dy)) / (4 * e * e);
            const NormalNode a = normal_node(3, i / 3), b = normal_node(3, i % 3);
            const double det = std::sqrt(double(c.slopes.var_x) * double(c.slopes.var_y) -
                                         double(c.slopes.cov) * double(c.slopes.cov));
            const double area = det * double(a.width) * double(b.width);
            EXPECT_NEAR(double(light.solid_angle), per_area * area, 2e-3 * per_area * area)
                << c.name;
        }
    }
}

// Errors of the sum against the integral, of light and of the white furnace: means over all cases,
// and the worst of those that water has (deviations up to 0.3). What was measured, plus a tenth.
TEST(SlopeEnvironment, IsTheIntegral) {
    const double mean_allowed[] = {0.049, 0.035, 0.0245};
    const double worst_allowed[] = {0.185, 0.116, 0.09};
    for (const uint masking : maskings) {
        double sum[3] = {}, worst[3] = {};
        int count = 0;
        for (const SlopeCase& c : slopeCases()) {
            for (const bool white : {false, true}) {
                const double exact = byIntegral(c.slopes, c.wo, masking, white);
                const bool water = std::max(c.slopes.var_x, c.slopes.var_y) < 0.1f;
                ++count;
                for (uint n = 3; n <= 5; ++n) {
                    const double error =
                        std::abs(bySlopes(c.slopes, c.wo, n, masking, white) / exact - 1.0);
                    sum[n - 3] += error;
                    if (water) worst[n - 3] = std::max(worst[n - 3], error);
                }
            }
        }
        for (uint n = 3; n <= 5; ++n) {
            EXPECT_LT(sum[n - 3] / count, mean_allowed[n - 3]) << n << " masking " << masking;
            EXPECT_LT(worst[n - 3], worst_allowed[n - 3]) << n << " masking " << masking;
        }
    }
}

TEST(SlopeEnvironment, LevelsAreThoseOfTheSolidAngle) {
    const float texel = 4.0f * 3.14159265f / (6.0f * 256.0f * 256.0f);
    EXPECT_EQ(slope_light_lod(0.5f * texel, texel), 0.0f);
    EXPECT_NEAR(slope_light_lod(texel * 64.0f, texel), 3.0f, 1e-5f);  // 8 by 8 texels
}

// A facet that nobody sees has no weight, whatever the numbers.
TEST(SlopeEnvironment, IsFiniteEverywhere) {
    const Slopes all[] = {slopesOf(0, 0, 1e-9f, 1e-9f, 0), slopesOf(0.3f, 0, 10, 1e-5f, 0),
                          slopesOf(-3, 2, 2, 2, 0.9999f)};
    for (const Slopes& d : all) {
        for (const double theta : {0.0, 60.0, 89.99}) {
            const vec3 wo = directionAt(theta, 170);
            if (slope_facing(d.mean, wo) <= 0.0f) continue;
            for (uint i = 0; i < 16; ++i) {
                for (const uint masking : maskings) {
                    const SlopeLight light = slope_light(d, wo, 4, i, masking);
                    EXPECT_TRUE(light.weight >= 0.0f && std::isfinite(light.weight));
                    EXPECT_TRUE(light.solid_angle >= 0.0f && std::isfinite(light.solid_angle));
                    EXPECT_NEAR(length(light.wi), 1.0f, 1e-4f);
                }
            }
        }
    }
}

}  // namespace
}  // namespace gp::test
