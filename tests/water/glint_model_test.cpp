// The glint model where its answer is known: limits in which it is another model, and furnaces.
#include <cmath>

#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

BsdfParams glintMetal(float alphaX, float alphaY) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    m.base_color = vec3(0.9f, 0.6f, 0.3f);
    m.metallic = 1.0f;
    m.alpha_x = alphaX;
    m.alpha_y = alphaY;
    return bsdf_prepared(m);
}

// One sample.
BsdfSample drawn(const BsdfParams& m, vec3 wo, Random& random) {
    const float lobe = random.uniform();
    const float x = random.uniform();
    return bsdf_sample(m, wo, lobe, vec2(x, random.uniform()));
}

// Share of the energy that leaves again; light that crossed the boundary is brought back from
// radiance to power.
double furnace(const BsdfParams& m, vec3 wo, double eta, int samples = 60'000) {
    Random random(31);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const BsdfSample s = drawn(m, wo, random);
        const bool crosses = (s.lobe & LOBE_TRANSMISSION) != 0u && m.thin == 0u;
        sum += double(s.weight.y) * (crosses ? eta * eta : 1.0);
    }
    return sum / samples;
}

vec3 viewAt(float z) {
    return vec3(std::sqrt(1.0f - z * z), 0.0f, z);
}

TEST(GlintModel, SmoothCentredMetalIsBeckmannWithCavities) {
    Random random(7);
    for (const float alpha : {0.05f, 0.3f, 1.0f}) {
        const BsdfParams glint = glintMetal(alpha, 0.5f * alpha);
        BsdfParams m = bsdf_params_of(MODEL_MICROFACET);
        m.base_color = glint.base_color;
        m.alpha_x = glint.alpha_x;
        m.alpha_y = glint.alpha_y;
        m.slot_a.x = float(DISTRIBUTION_BECKMANN);
        m.slot_a.y = float(MASKING_V_CAVITY);
        m = bsdf_prepared(m);
        int compared = 0;
        for (int i = 0; i < 20'000; ++i) {
            const float x = random.uniform();
            const vec3 wo = square_to_uniform_hemisphere(vec2(x, random.uniform()));
            const vec3 wi = drawn(m, wo, random).wi;
            const BsdfValue a = bsdf_eval(glint, wo, wi);
            const BsdfValue b = bsdf_eval(m, wo, wi);
            if (!(b.pdf > 1e-6f) || wi.z < 1e-3f || wo.z < 1e-3f) continue;
            ++compared;
            // The exponent of the distribution is large in its tail.
            ASSERT_NEAR(a.f_cos.x, b.f_cos.x, 2e-3f * b.f_cos.x) << alpha;
            ASSERT_NEAR(a.pdf, b.pdf, 2e-3f * b.pdf) << alpha;
        }
        EXPECT_GT(compared, 10'000);
    }
}

// The matte base gets what the facets leave, however rough they are; noise is below 0.004.
TEST(GlintModel, WhitePaintReturnsEverything) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    for (const float alpha : {0.001f, 0.1f, 0.4f, 1.0f}) {
        m.alpha_x = m.alpha_y = alpha;
        const BsdfParams prepared = bsdf_prepared(m);
        for (const float z : {1.0f, 0.5f, 0.2f, 0.05f}) {
            EXPECT_NEAR(furnace(prepared, viewAt(z), 1.0), 1.0, 0.006) << alpha << " " << z;
        }
    }
}

// What V-cavities do not hide of a calm sea: nothing is lost at the normal, little at an angle.
TEST(GlintModel, ClearWaterLosesNothing) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    m.ior = 1.33f;
    m.alpha_x = m.alpha_y = 0.01f;
    m.transmission = 1.0f;
    m.thin = 0u;
    m = bsdf_prepared(m);
    for (const float z : {1.0f, 0.5f, 0.2f, -0.2f, -0.5f, -1.0f}) {
        const double eta = double(relative_ior(m.ior, z));
        EXPECT_NEAR(furnace(m, viewAt(z), eta), 1.0, 3e-3) << z;
    }
}

// Which side a direction is on is the mesosurface's to say: light from below the horizon of the
// geometry meets a wave that faces it.
TEST(GlintModel, WavesSeeBelowTheHorizonOfTheGeometry) {
    BsdfParams m = glintMetal(0.2f, 0.2f);
    m.slot_a.x = -1.0f;  // falls towards +x: its normal leans there
    const vec3 below = normalize(vec3(1.0f, 0.0f, -0.2f));
    ASSERT_GT(slope_facing(glint_mean(m), below), 0.0f);
    Random random(3);
    double sum = 0.0;
    for (int i = 0; i < 20'000; ++i) sum += double(drawn(m, below, random).weight.x);
    EXPECT_GT(sum / 20'000, 0.7);
    const vec3 behind = normalize(vec3(-1.0f, 0.0f, 0.2f));
    ASSERT_LT(slope_facing(glint_mean(m), behind), 0.0f);
    EXPECT_EQ(bsdf_eval(m, behind, vec3(0, 0, 1)).f_cos, vec3(0.0f));
    EXPECT_EQ(bsdf_sample(m, behind, 0.5f, vec2(0.5f)).weight, vec3(0.0f));
}

}  // namespace
}  // namespace gp::test
