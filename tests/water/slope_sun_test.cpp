// Suns over surfaces of slopes: a disc as what widens the pixel's kernel, and what of the light is
// the matte base's.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/glint_dictionary.h"
#include "shading/shading.h"
#include "statistics/random.h"

GP_SHADING_BEGIN
#include "shading/bsdf/glint_sun.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;
using namespace glm;

#include "backend/cpu/isa/glint_block.h"

DirectionalLight sunAt(vec3 direction, float radius) {
    DirectionalLight sun;
    sun.direction = direction;
    sun.irradiance = vec3(1.0f);
    const float s = std::sin(0.5f * radius);
    sun.one_minus_cos_max = 2.0f * s * s;
    return sun;
}

// Metal, or a dielectric over a matte base. Facets are counted in unit squares of uv.
BsdfParams facets(float alpha, float metallic, uint32_t method, float density = 1e6f) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    m.base_color = vec3(0.9f, 0.6f, 0.3f);
    m.metallic = metallic;
    m.alpha_x = alpha, m.alpha_y = 0.6f * alpha;
    m.slot_a = vec4(0.1f, -0.05f, 0.3f, density);  // mean slope, correlation
    m.slot_b.x = float(method);
    m.slot_d = vec4(0.01f, 0, 0, 0.007f);
    m.table = glintDictionary();
    return bsdf_prepared(m);
}

constexpr vec3 up(0, 0, 1);

TEST(SlopeSun, TheKernelTakesTheDisc) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        BsdfParams m = facets(0.05f, 1, GLINT_SMOOTH);
        const auto number = [&] { return 0.02f * (random.uniform() - 0.5f); };
        m.slot_e = vec4(number(), number(), number(), number());
        const vec3 more = sun_slope_covariance(normalize(vec3(number(), 0.01f, 0.01f)), up,
                                               0.02f * random.uniform());
        const Slopes before = glint_of(m).slopes;
        BsdfParams wider = m;
        wider.slot_e = glint_kernel_with(m.slot_e, more);
        const Slopes after = glint_of(wider).slopes;
        EXPECT_NEAR(after.var_x, before.var_x + more.x, 1e-5f * after.var_x);
        EXPECT_NEAR(after.var_y, before.var_y + more.y, 1e-5f * after.var_y);
        EXPECT_NEAR(after.cov, before.cov + more.z, 1e-5f * sqrt(after.var_x * after.var_y));
        EXPECT_EQ(wider.alpha_x, m.alpha_x);
    }
}

// A sun that is a direction, and one that no facet reflects to the viewer, change nothing.
TEST(SlopeSun, WithoutADiscNothingChanges) {
    const BsdfParams m = facets(0.2f, 1, GLINT_DICTIONARY);
    const vec3 wo = normalize(vec3(0.3f, 0.2f, 1)), wi = normalize(vec3(-0.4f, 0, 1));
    EXPECT_EQ(sun_f_cos(m, wo, wi, sunAt(wi, 0)), bsdf_eval(m, wo, wi).f_cos);
    EXPECT_NE(sun_f_cos(m, wo, wi, sunAt(wi, 0.02f)), bsdf_eval(m, wo, wi).f_cos);
    const vec3 below(0, 0, -1);
    EXPECT_EQ(sun_f_cos(m, wo, below, sunAt(below, 0.02f)), vec3(0.0f));
}

// Of each pixel's facets, not only on average: what cells show of a disc is the mean of what they
// show of its points. Half a dozen cells of some 40 facets, lobes half as wide as the disc.
TEST(SlopeSun, GlintsAreBlurredByTheDisc) {
    Random random(3);
    const vec3 wo = normalize(vec3(0.2f, 0.1f, 1)), wi = normalize(vec3(-0.2f, 0.05f, 1));
    const DirectionalLight sun = sunAt(wi, 0.03f);
    double sharp = 0, blurred = 0, squares = 0;
    for (int i = 0; i < 200; ++i) {
        BsdfParams m = facets(0.1f, 1, GLINT_DICTIONARY, 4e6f);
        m.slot_c.x = 10 * random.uniform(), m.slot_c.y = 10 * random.uniform();
        constexpr int n = 400;
        double mean = 0;
        for (int j = 0; j < n; ++j) {
            const float x = random.uniform();
            const LightSample s = directional_light_sample(sun, vec2(x, random.uniform()));
            mean += double(bsdf_eval(m, wo, s.wi).f_cos.y) / n;
        }
        const double one = double(sun_f_cos(m, wo, wi, sun).y);
        const double point = double(bsdf_eval(m, wo, wi).f_cos.y);
        sharp += (point - mean) * (point - mean), blurred += (one - mean) * (one - mean);
        squares += mean * mean;
    }
    EXPECT_LT(std::sqrt(blurred / squares), 0.2);
    EXPECT_LT(blurred, 0.2 * sharp);
}

TEST(SlopeSun, WhatIsNotTheBaseIsTheFacets) {
    const BsdfParams paint = facets(0.1f, 0, GLINT_SMOOTH), metal = facets(0.1f, 1, GLINT_SMOOTH);
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const float x = random.uniform(), z = random.uniform();
        const vec3 wo = square_to_uniform_hemisphere(vec2(x, random.uniform()));
        const vec3 wi = square_to_uniform_hemisphere(vec2(z, random.uniform()));
        const vec3 all = bsdf_eval(paint, wo, wi).f_cos;
        const vec3 matte = slopes_matte_part(paint, wo, wi);
        EXPECT_EQ(slopes_matte_part(metal, wo, wi), vec3(0.0f));
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(matte[c], all[c] * 1.00001f);
            // 20 deviations from the mirror direction no facet is left.
            const vec3 h = normalize(wo + wi);
            const vec2 off = slope_of(h) - glint_mean(paint);
            if (length(off) < 20 * 0.1f) continue;
            EXPECT_NEAR(matte[c], all[c], 1e-4f * all[c]);
        }
    }
    EXPECT_GT(slopes_matte_part(paint, up, up).x, 0.1f);
}

TEST(SlopeSun, OnlyWideSlopesHideTheDisc) {
    const auto hides = [](float alpha, float radius) {
        BsdfParams m = facets(alpha, 1, GLINT_SMOOTH);
        m.alpha_y = alpha;
        return slopes_hide_disc(m, sunAt(up, radius));
    };
    EXPECT_FALSE(hides(0.003f, 0.00465f));  // 1.02 to 1.05 too bright in the middle
    EXPECT_TRUE(hides(0.01f, 0.00465f));    // 0.996 to 1.000: docs/water.md
    EXPECT_FALSE(hides(0.01f, 0.02f));
    EXPECT_TRUE(hides(0.05f, 0.02f));
    EXPECT_TRUE(hides(0.002f, 0));
}

// Of any kind: paint, metal and clear bodies, some under a coat, a sheen or a film.
BsdfParams anyFacets(Random& random) {
    const auto number = [&](float most) { return most * (2 * random.uniform() - 1); };
    const auto seldom = [&] { return random.uniform() < 0.1f ? random.uniform() : 0.0f; };
    BsdfParams m = facets(0.02f + 0.3f * random.uniform(), 1, GLINT_DICTIONARY,
                          std::exp(2 + 14 * random.uniform()));
    m.metallic = random.uniform() < 0.5f ? 0.0f : random.uniform();
    m.transmission = random.uniform() < 0.5f ? 0.0f : random.uniform();
    m.thin = random.uniform() < 0.5f ? 0 : 1;
    m.specular = random.uniform(), m.ior = 1 + random.uniform();
    m.specular_color = vec3(random.uniform(), 1, random.uniform());
    m.coat = seldom(), m.sheen_color = vec3(seldom()), m.iridescence = seldom();
    m.slot_a.x = number(0.3f), m.slot_a.y = number(0.3f), m.slot_a.z = number(0.8f);
    if (random.uniform() < 0.5f) m.slot_b.x = std::floor(4 * random.uniform());  // the method
    m.slot_b.y = random.uniform() < 0.5f ? 1.0f : random.uniform();
    m.slot_b.z = random.uniform();
    m.slot_c = vec4(number(100), number(100), std::floor(10 * random.uniform()), random.uniform());
    m.slot_d = vec4(number(0.02f), number(0.02f), number(0.02f), number(0.02f));
    m.slot_e = vec4(number(0.02f), number(0.02f), number(0.02f), number(0.02f));
    return bsdf_prepared(m);
}

template <uint32_t masking>
void expectBlockIsEach() {
    Random random(7 + masking);
    const auto number = [&](float most) { return most * (2 * random.uniform() - 1); };
    const DirectionalLight sun = sunAt(up, 0.02f);
    int seen = 0, layered = 0;
    for (int round = 0; round < 500; ++round) {
        GlintBlock block;
        std::vector<BsdfParams> materials;
        const auto count = uint32_t(1 + random.uniform() * (float(GlintBlock::most) - 0.1f));
        while (block.count < count) {
            BsdfParams m = anyFacets(random);
            m.slot_b.w = float(masking);
            // Near the mirror direction of the mean slope, mostly.
            const vec3 n = normalize(mesosurface_normal(glint_mean(m)));
            const vec3 wo = normalize(vec3(number(1), number(1), 0.2f + random.uniform()));
            const vec3 off = vec3(number(0.3f), number(0.3f), number(0.3f));
            const vec3 wi = normalize(2.0f * dot(wo, n) * n - wo + off);
            if (!reflects_sun(m, wo, wi, sun)) continue;
            block.add(block.count, m, wo);
            block.setSun(block.count - 1, wi);
            materials.push_back(m);
        }
        block.pad();
        findAlbedos(block);
        findSun<masking>(block, sun);
        for (uint32_t i = 0; i < count; ++i) {
            const BsdfParams& m = materials[i];
            const SunFacets each =
                sun_facets(glint_material_slopes(m), m.slot_e, masking, block.wo(i), block.wi(i),
                           sqrt(sun_sin_squared(sun)));
            const SunFacets found = block.facets(i);
            for (int k = 0; k < 4; ++k) EXPECT_NEAR(found.kernel[k], each.kernel[k], 1e-5f);
            EXPECT_NEAR(found.facet.slope.x, each.facet.slope.x, 1e-5f);
            EXPECT_NEAR(found.facet.slope.y, each.facet.slope.y, 1e-5f);
            EXPECT_NEAR(found.facet.f_cos, each.facet.f_cos, 1e-4f * each.facet.f_cos);
            EXPECT_NEAR(found.facet.pdf, each.facet.pdf, 1e-4f * each.facet.pdf);
            EXPECT_NEAR(found.facet.cos_h, each.facet.cos_h, 1e-5f);
            const vec3 fCos = sunFCos(block, i, m, sun);
            const vec3 wanted = sun_f_cos(m, block.wo(i), block.wi(i), sun);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(fCos[c], wanted[c], 1e-6f + 2e-4f * wanted[c])
                    << "round " << round << " point " << i << " method " << glint_method(m);
            const vec3 albedo =
                bsdf_albedo(m, std::abs(mesosurface_cosine(glint_mean(m), block.wo(i))));
            if (has_sun_shares(m)) {
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(block.albedo[c][i], albedo[c], 1e-5f);
            }
            seen += wanted.x > 1e-3f, layered += !has_sun_shares(m);
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_GT(layered, 100);
}

TEST(SlopeSun, BlocksOfPointsFindWhatEachHas) {
    expectBlockIsEach<GLINT_MASKING_V_CAVITY>();
    expectBlockIsEach<GLINT_MASKING_SMITH>();
}

}  // namespace
}  // namespace gp::test
