// Masking by sheared V-cavities: the identity of visible area, energy, reciprocity, sampling.
#include <gtest/gtest.h>

#include "statistics/chi2.h"
#include "water/slope_cases.h"

GP_SHADING_BEGIN
#include "shading/microfacet/masking.glsl"
#include "shading/slope/mean_slope.glsl"
#include "shading/slope/sheared_cavity.glsl"
#include "shading/slope/smith_slopes.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;

vec2 uniform2(Random& random) {
    const float x = random.uniform();
    return vec2(x, random.uniform());
}

// The reflectance with respect to the mesosurface, F = 1.
double reflectance(const Slopes& d, vec3 wo, vec3 wi, bool smith) {
    const vec3 h = normalize(wo + wi);
    if (h.z <= 0.0f || slope_facing(d.mean, wo) <= 0.0f) return 0.0;
    const vec2 s = slope_of(h);
    const float g2 = smith ? slopes_smith_g2(d, wo, wi) : sheared_cavity_g2(d.mean, s, wo, wi);
    return double(slopes_p22(d, s)) * double(g2)
         / (4.0 * std::pow(double(h.z), 4.0) * double(slope_facing(d.mean, wo))
            * double(slope_facing(d.mean, wi)));
}

TEST(ShearedCavity, VisibleAreaIsThatOfTheMesosurface) {
    for (const SlopeCase& c : slopeCases()) {
        const double visible = meanOverSlopes(c.slopes, [&](vec2 s) {
            return sheared_cavity_g1(c.slopes.mean, s, c.wo)
                 * std::max(slope_facing(s, c.wo), 0.0f);
        });
        // The masking of float functions, and the step of the grid at the kinks.
        EXPECT_NEAR(visible / double(slope_facing(c.slopes.mean, c.wo)), 1.0, 1e-5) << c.name;
    }
}

TEST(ShearedCavity, SmithKeepsTheSameArea) {
    for (const SlopeCase& c : slopeCases()) {
        const double facing = meanOverSlopes(c.slopes, [&](vec2 s) {
            return std::max(slope_facing(s, c.wo), 0.0f);
        });
        const double visible = facing * double(slopes_smith_g1(c.slopes, c.wo));
        EXPECT_NEAR(visible / double(slope_facing(c.slopes.mean, c.wo)), 1.0, 2e-5) << c.name;
    }
}

TEST(ShearedCavity, NothingIsSeenOfAMesosurfaceFromBehind) {
    const Slopes d = slopesOf(0.5f, 0.0f, 0.3f, 0.3f, 0.0f);
    const vec3 behind = directionAt(85, 0);
    ASSERT_LT(slope_facing(d.mean, behind), 0.0f);
    EXPECT_LT(slopes_smith_g1(d, behind), 1e-29f);
    EXPECT_EQ(meanOverSlopes(d, [&](vec2 s) { return sheared_cavity_g1(d.mean, s, behind); },
                             {100, 7.0}), 0.0);
}

// Of a mirror that is white everywhere no more than all light comes back.
TEST(ShearedCavity, AlbedoIsAtMostOne) {
    double least[2] = {1.0, 1.0};
    for (const SlopeCase& c : slopeCases()) {
        for (const bool smith : {false, true}) {
            const double albedo = meanOverSlopes(c.slopes, [&](vec2 s) {
                const float facing = std::max(slope_facing(s, c.wo), 0.0f);
                const vec3 wi = reflect(-c.wo, facet_of(s));
                return facing * (smith ? slopes_smith_g2(c.slopes, c.wo, wi)
                                       : sheared_cavity_g2(c.slopes.mean, s, c.wo, wi));
            }, {250, 7.0}) / double(slope_facing(c.slopes.mean, c.wo));
            EXPECT_LE(albedo, 1.0 + 2e-5) << c.name << (smith ? " smith" : "");
            least[smith ? 1 : 0] = std::min(least[smith ? 1 : 0], albedo);
        }
    }
    // What is lost is light that bounces twice: most where facets are steep.
    EXPECT_GT(least[0], 0.2);
    EXPECT_GT(least[1], 0.2);
}

TEST(ShearedCavity, ReflectanceIsReciprocal) {
    Random random(3);
    int compared = 0;
    for (const SlopeCase& c : slopeCases()) {
        for (int i = 0; i < 50; ++i) {
            const float z = random.uniform();
            const float phi = 6.2831853f * random.uniform();
            const float r = std::sqrt(1.0f - z * z);
            const vec3 wi(r * std::cos(phi), r * std::sin(phi), z);
            if (slope_facing(c.slopes.mean, wi) <= 1e-3f) continue;
            for (const bool smith : {false, true}) {
                const double there = reflectance(c.slopes, c.wo, wi, smith);
                const double back = reflectance(c.slopes, wi, c.wo, smith);
                ASSERT_NEAR(there, back, 1e-5 * back + 1e-30) << c.name;
                compared += back > 1e-6 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

// About the mean slope 0 it is the masking that has been known for long.
TEST(ShearedCavity, CentredIsCookTorranceAndBeckmann) {
    Random random(5);
    for (int i = 0; i < 20'000; ++i) {
        const vec3 wo = directionAt(89.0 * double(random.uniform()), 360.0 * random.uniform());
        const vec3 wi = directionAt(89.0 * double(random.uniform()), 360.0 * random.uniform());
        const vec3 h = normalize(wo + wi);
        const float cook = masking_v_cavity(wo.z, wi.z, h.z, dot(wo, h));
        ASSERT_NEAR(sheared_cavity_g2(vec2(0.0f), slope_of(h), wo, wi), cook, 2e-5f * cook);
        const float ax = std::exp2(-8.0f * random.uniform());
        const float ay = std::exp2(-8.0f * random.uniform());
        const Slopes d = slopesOf(0.0f, 0.0f, ax * std::sqrt(0.5f), ay * std::sqrt(0.5f), 0.0f);
        const float lambda = beckmann_lambda(wo, ax, ay);
        ASSERT_NEAR(slopes_smith_lambda(d, wo), lambda, 1e-4f * lambda + 1e-7f);
        ASSERT_NEAR(slopes_smith_g2(d, wo, wi), beckmann_g2_correlated(wo, wi, ax, ay), 1e-5f);
    }
}

TEST(ShearedCavity, VisibleSlopesFollowTheirDensity) {
    Chi2Options options;
    const std::vector<SlopeCase> cases = slopeCases(true);
    options.testCount = cases.size();
    options.samples = longTests() ? 1'000'000 : 200'000;
    for (const SlopeCase& c : cases) {
        options.name = "visible slopes " + c.name;
        options.seed += 1;
        const dvec2 mean(c.slopes.mean);
        const dvec2 half = 4.5 * sqrt(dvec2(vec2(c.slopes.var_x, c.slopes.var_y)));
        const float area = slope_facing(c.slopes.mean, c.wo);
        const auto pdf = [&](vec2 s) {
            return slopes_p22(c.slopes, s) * sheared_cavity_g1(c.slopes.mean, s, c.wo)
                 * std::max(slope_facing(s, c.wo), 0.0f) / area;
        };
        // The density has a kink where the facet, or its pair, is seen edge on.
        const RectangleBreaks breaks = [&](double x) {
            const double wy = double(c.wo.y), by = double(c.wo.z) - x * double(c.wo.x);
            if (std::abs(wy) < 1e-6) return std::vector<double>{};
            return std::vector<double>{by / wy, (by - 2.0 * double(area)) / wy};
        };
        const Chi2Result result = chi2Rectangle(options, mean - half, mean + half,
            [&](Random& random) {
                const vec2 s = slopes_sample(c.slopes, uniform2(random));
                return sheared_cavity_visible(c.slopes.mean, s, c.wo, random.uniform());
            }, pdf, breaks);
        EXPECT_TRUE(result.passed) << result.message;
        EXPECT_NEAR(result.pdfIntegral, 1.0, 2e-3) << c.name;
    }
}

TEST(ShearedCavity, MeansThatCannotBeSeenArePulledBack) {
    Random random(9);
    for (int i = 0; i < 20'000; ++i) {
        const vec3 wo = directionAt(90.0 * double(random.uniform()), 360.0 * random.uniform());
        const vec2 mean(10.0f * random.uniform() - 5.0f, 10.0f * random.uniform() - 5.0f);
        const vec2 pulled = slope_mean_in_view(mean, wo);
        const float before = slope_facing(mean, wo), after = slope_facing(pulled, wo);
        if (before > 1.1e-3f) {
            ASSERT_EQ(pulled, mean);
            continue;
        }
        ASSERT_GT(after, 0.0f) << wo.z << " " << mean.x << " " << mean.y;
        ASSERT_LT(after, 1.2e-3f);
        // Along the azimuth of the view only.
        ASSERT_NEAR((pulled.x - mean.x) * wo.y - (pulled.y - mean.y) * wo.x, 0.0f, 2e-5f);
    }
}

// Hostile numbers give numbers.
TEST(ShearedCavity, IsFiniteEverywhere) {
    const vec3 directions[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0.6f, 0, -0.8f},
                               directionAt(89.9999, 10), directionAt(1e-4, 200)};
    const Slopes all[] = {slopesOf(0, 0, 1e-10f, 1e-10f, 0), slopesOf(0, 0, 1e3f, 1e-6f, 0),
                          slopesOf(1e6f, -1e6f, 0.1f, 0.1f, 0.99999f), slopesOf(1, 0, 0, 0, 0)};
    for (const Slopes& d : all) {
        for (const vec3 wo : directions) {
            EXPECT_TRUE(std::isfinite(slope_mean_in_view(d.mean, wo).x));
            EXPECT_TRUE(std::isfinite(slopes_smith_lambda(d, wo)));
            for (const vec3 wi : directions) {
                EXPECT_TRUE(std::isfinite(slopes_smith_g2(d, wo, wi)));
                for (const vec2 s : {d.mean, vec2(0.0f), vec2(1e5f, 0.0f)}) {
                    const float g2 = sheared_cavity_g2(d.mean, s, wo, wi);
                    EXPECT_TRUE(g2 >= 0.0f && g2 <= 1.0f);
                    const vec2 seen = sheared_cavity_visible(d.mean, s, wo, 0.5f);
                    EXPECT_TRUE(std::isfinite(seen.x) && std::isfinite(seen.y));
                }
            }
        }
    }
}

// A sun in the zenith, seen from there, adds r^2 / 16; anywhere, what its points really spread.
TEST(Sun, WidensSlopesByItsDisc) {
    const float r = 4.65e-3f;
    const vec3 up(0, 0, 1);
    EXPECT_NEAR(sun_slope_covariance(up, up, r).x, r * r / 16.0f, 1e-5f * r * r);
    EXPECT_NEAR(sun_slope_covariance(up, up, r).y, r * r / 16.0f, 1e-5f * r * r);
    const vec3 pairs[][2] = {{directionAt(80, 0), directionAt(75, 170)},
                             {directionAt(30, 40), directionAt(60, 100)},
                             {directionAt(85, 10), directionAt(2, 0)}};
    for (const auto& pair : pairs) {
        const dvec3 wi(pair[1]), t = normalize(cross(dvec3(0.3, 0.2, 0.9), wi)), b = cross(wi, t);
        double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
        for (int i = 0; i < 40'000; ++i) {
            const double radius = double(r) * std::sqrt((i + 0.5) / 40'000), turn = 2.399963 * i;
            const dvec3 v = dvec3(pair[0])
                + normalize(wi + (t * std::cos(turn) + b * std::sin(turn)) * radius);
            const double sx = -v.x / v.z, sy = -v.y / v.z;
            n += 1, x += sx, y += sy, xx += sx * sx, yy += sy * sy, xy += sx * sy;
        }
        const vec3 c = sun_slope_covariance(pair[0], pair[1], r);
        const double scale = double(c.x) + double(c.y);
        EXPECT_NEAR(double(c.x), xx / n - x * x / n / n, 2e-3 * scale);
        EXPECT_NEAR(double(c.y), yy / n - y * y / n / n, 2e-3 * scale);
        EXPECT_NEAR(double(c.z), xy / n - x * y / n / n, 2e-3 * scale);
    }
}

}  // namespace
}  // namespace gp::test
