// Directions that are drawn to where facets refract a light to have the density that they say, and
// are where Snell's law sends it.
#include <gtest/gtest.h>

#include "shading/lang.h"
#include "statistics/chi2.h"

GP_SHADING_BEGIN
#include "shading/slope/refracted_light.glsl"
GP_SHADING_END

namespace {

using namespace gp::shading;
using gp::test::Random;

Slopes slopesOf(float x, float y, float correlation, vec2 mean) {
    Slopes d;
    d.mean = mean;
    d.var_x = x * x, d.var_y = y * y, d.cov = correlation * x * y;
    return d;
}

vec3 fromZenith(float angle, float azimuth) {
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
            std::cos(angle)};
}

TEST(RefractedLight, HasItsDensity) {
    struct Case {
        Slopes slopes;
        vec3 light;
        float ior;
    };
    const Case cases[] = {
        {slopesOf(0.01f, 0.01f, 0, vec2(0)), fromZenith(0.5f, 1), 1.333f},
        {slopesOf(0.2f, 0.1f, 0.5f, vec2(0)), fromZenith(0, 0), 1.333f},
        {slopesOf(0.15f, 0.3f, -0.7f, vec2(0.2f, -0.1f)), fromZenith(1.2f, 2), 1.333f},
        {slopesOf(0.3f, 0.3f, 0, vec2(0)), fromZenith(1.5f, -2), 1.5f},
        {slopesOf(0.5f, 0.2f, 0, vec2(-0.3f, 0)), fromZenith(0.9f, 0.3f), 2.5f},
    };
    for (const Case& c : cases) {
        gp::test::Chi2Options options;
        options.name = fmt::format("refracted light {} {}", c.ior, c.light.z);
        options.testCount = std::size(cases);
        options.samples = gp::test::longTests() ? 4'000'000 : 300'000;
        const gp::Chi2Result r = gp::chi2Sphere(
            options, {},
            [&](Random& random) {
                const float x = random.uniform(), y = random.uniform();
                return refracted_light_sample(c.slopes, c.light, c.ior, vec2(x, y));
            },
            [&](vec3 w) { return refracted_light_pdf(c.slopes, c.light, c.ior, w); });
        EXPECT_TRUE(r.passed) << r.message;
        EXPECT_NEAR(r.pdfIntegral, r.acceptedFraction, 4e-3) << options.name;
    }
}

// What a flat facet refracts: sines are as the indices, in the plane of incidence, on the light's
// side of the normal.
TEST(RefractedLight, FollowsSnellsLaw) {
    const Slopes flat = slopesOf(1e-6f, 1e-6f, 0, vec2(0));
    for (const float angle : {0.1f, 0.7f, 1.4f}) {
        const vec3 light = fromZenith(angle, 0.8f);
        const vec3 w = refracted_light_sample(flat, light, 1.333f, vec2(0.3f, 0.6f));
        EXPECT_NEAR(length(vec2(w)) * 1.333f, std::sin(angle), 1e-5f);
        EXPECT_NEAR(w.x * light.y, w.y * light.x, 1e-5f);
        EXPECT_GT(w.x * light.x, 0);
        EXPECT_GT(w.z, 0);
    }
}

TEST(RefractedLight, NothingWhereNoFacetDoesIt) {
    const Slopes waves = slopesOf(0.2f, 0.2f, 0, vec2(0));
    const vec3 light = fromZenith(0.4f, 0);
    EXPECT_EQ(refracted_light_pdf(waves, light, 1.333f, vec3(0, 0, -1)), 0);
    // The density at and beyond the horizon, and straight against the light, is a number.
    for (const vec3 w : {vec3(1, 0, 0), vec3(-1, 0, 0), light, -light})
        EXPECT_GE(refracted_light_pdf(waves, light, 1.333f, w), 0);
    // A light below the surface shines through no facet but steep ones.
    const vec3 low = refracted_light_sample(waves, vec3(0.8f, 0, -0.6f), 1.333f, vec2(0.5f, 0.5f));
    EXPECT_EQ(low, vec3(0));
}

}  // namespace
