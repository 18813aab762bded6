// Materials made of the library's models: every model in a uniform surrounding against its own
// albedo, layers against the parameters in between, masks against the materials on both sides.
#include "shading/shading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"
#include "scene/bsdf_settings.h"

namespace gp::test {
namespace {

using Words = std::vector<GpBsdfParameter>;

GpBsdf newBsdf(Stage& stage, const char* model, const Words& words = {}) {
    GpBsdfDesc desc{};
    desc.model = model, desc.parameters = words.data();
    desc.parameterCount = uint32_t(words.size());
    const GpBsdf bsdf = gpNewBsdf(stage.device, &desc);
    EXPECT_NE(bsdf, nullptr) << model;
    return bsdf;
}

GpMaterialDesc materialOf(GpBsdf bsdf) {
    GpMaterialDesc desc{};
    desc.bsdf = bsdf;
    return desc;
}

// Half black, half white, one pixel each.
GpTexture halves(Stage& stage) {
    static constexpr uint8_t pixels[8] = {0, 0, 0, 255, 255, 255, 255, 255};
    GpTextureDesc desc{};
    desc.width = 2, desc.height = 1, desc.pixels = pixels, desc.colorSpace = GP_COLOR_LINEAR;
    desc.magFilter = desc.minFilter = GP_FILTER_NEAREST;
    desc.wrapU = desc.wrapV = GP_WRAP_CLAMP;
    return stage.texture(desc);
}

GpTexture grey(Stage& stage, uint8_t value) {
    const uint8_t pixels[4] = {value, 0, 0, 255};
    GpTextureDesc desc{};
    desc.width = desc.height = 1, desc.pixels = pixels, desc.colorSpace = GP_COLOR_LINEAR;
    return stage.texture(desc);
}

// A square that fills the picture, seen at a slant, in a surrounding of radiance 1.
Picture squareOf(Stage& stage, const GpMaterialDesc& desc, uint32_t samples) {
    Triangles t;
    t.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    stage.add(t, stage.material(desc));
    stage.surround(glm::vec3(1));
    GpRenderOptions o = stage.options(samples);
    o.maxBounces = GP_NO_BOUNCES;
    return stage.render(16, 8, lookFrom({0, 0, 0}, glm::normalize(glm::vec3(0, -0.5f, 1)), 3, 0.9f),
                        o);
}

class LibraryMaterial : public ::testing::TestWithParam<Variant> {};

// By the model's own sampler, which tests/statistics holds to its values.
glm::dvec3 albedoOf(const shading::BsdfParams& m, glm::vec3 wo) {
    constexpr uint32_t count = 200000;
    glm::dvec3 sum(0);
    for (uint32_t i = 0; i < count; ++i) {
        const auto u = [&](uint32_t k) {
            return float(shading::hash_u32(i * 4 + k) >> 8u) * EXP2_MINUS_24;
        };
        sum += glm::dvec3(shading::bsdf_sample(m, wo, u(0), {u(1), u(2)}).weight);
    }
    return sum / double(count);
}

TEST_P(LibraryMaterial, EveryModelShowsItsAlbedo) {
    const glm::vec3 wo = glm::normalize(glm::vec3(0, -0.5f, 1));
    for (const BsdfModelInfo& info : bsdfModels()) {
        if (info.fromFile) continue;  // measured_material_test.cpp
        SCOPED_TRACE(info.name);
        Stage stage(GetParam());
        const GpBsdf bsdf = newBsdf(stage, info.name.c_str());
        const Picture p = squareOf(stage, materialOf(bsdf), effort(256));
        const glm::dvec3 expected = albedoOf(bsdfParamsFrom(BsdfSettings(info)), wo);
        // The camera sees the square under slightly different angles; 256 samples of 128 pixels.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(p.mean()[c], expected[c], 0.02 * expected[c] + 4 * p.sigma()[c] + 1e-4);
    }
}

TEST_P(LibraryMaterial, BaseColorMultiplies) {
    Stage stage(GetParam());
    GpMaterialDesc desc = materialOf(newBsdf(stage, "lambert", {{"base_color", "0.8,0.4,0.2"}}));
    put(desc.baseColor, {0.5f, 1, 0.25f});
    desc.baseColor[3] = 1;
    desc.baseColorTexture.texture = halves(stage);
    const Picture p = squareOf(stage, desc, effort(64));
    EXPECT_NEAR(p.at(1, 4).x, 0, 1e-6);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(p.at(14, 4)[c], (glm::vec3(0.4f, 0.4f, 0.05f))[c], 1e-3);
}

TEST_P(LibraryMaterial, LayersAreTheParametersInBetween) {
    const Words red{{"base_color", "0.8,0.1,0.1"}, {"roughness", "0.2"}, {"metallic", "1"}};
    const Words blue{{"base_color", "0.1,0.1,0.8"}, {"roughness", "0.6"}, {"metallic", "0"}};
    const Words between{
        {"base_color", "0.625,0.1,0.275"}, {"roughness", "0.3"}, {"metallic", "0.75"}};
    Stage a(GetParam()), b(GetParam()), c(GetParam());
    const auto stack = [&](Stage& s, GpMaterialLayer& layer) {
        GpMaterialDesc desc = materialOf(newBsdf(s, "disney", red));
        layer.bsdf = newBsdf(s, "disney", blue);
        desc.layers = &layer, desc.layerCount = 1;
        return squareOf(s, desc, 16);
    };
    GpMaterialLayer weighted{}, masked{};
    weighted.weight = 0.25f;
    masked.weight = 0.5f, masked.mask.texture = grey(b, 128);
    const glm::dvec3 expected =
        squareOf(c, materialOf(newBsdf(c, "disney", between)), 16).mean();
    const glm::dvec3 byWeight = stack(a, weighted).mean(), byMask = stack(b, masked).mean();
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(byWeight[k], expected[k], 1e-4 * expected[k]);
        EXPECT_NEAR(byMask[k], expected[k], 0.01 * expected[k]);  // 128 / 255 is not quite a half
    }
}

// On either side of the mask's edge the picture is that of the material which is there; microfacet
// with a distribution whose masking is prepared for its width, so at each point here.
TEST_P(LibraryMaterial, MasksChooseTheMaterial) {
    const Words narrow{{"distribution", "gtr"}, {"shape", "1.5"}, {"alpha_x", "0.1"},
                       {"alpha_y", "0.1"}};
    const Words wide{{"distribution", "gtr"}, {"shape", "1.5"}, {"alpha_x", "0.6"},
                     {"alpha_y", "0.6"}};
    Stage a(GetParam()), b(GetParam()), both(GetParam());
    const Picture left = squareOf(a, materialOf(newBsdf(a, "microfacet", narrow)), 16);
    const Picture right = squareOf(b, materialOf(newBsdf(b, "microfacet", wide)), 16);
    GpMaterialLayer layer{};
    layer.bsdf = newBsdf(both, "microfacet", wide);
    layer.mask.texture = halves(both), layer.maskChannel = 1;
    GpMaterialDesc desc = materialOf(newBsdf(both, "microfacet", narrow));
    desc.layers = &layer, desc.layerCount = 1;
    const Picture masked = squareOf(both, desc, 16);
    for (uint32_t y = 0; y < 8; ++y) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(masked.at(2, y)[c], left.at(2, y)[c], 1e-4);
            EXPECT_NEAR(masked.at(13, y)[c], right.at(13, y)[c], 1e-4);
        }
    }
    EXPECT_GT(std::abs(left.mean().x - right.mean().x), 0.01);
}

// Clear glass vanishes in a furnace (light that only refraction loses is none); coloured by its
// inside it does not.
TEST_P(LibraryMaterial, GlassIsABody) {
    for (const bool tinted : {false, true}) {
        Stage stage(GetParam());
        Triangles t;
        t.sphere({0, 0, 0}, 1, 24, false, true);
        GpMaterialDesc desc = materialOf(
            newBsdf(stage, "ggx_dielectric", {{"alpha_x", "0.01"}, {"alpha_y", "0.01"}}));
        if (tinted) put(desc.attenuationColor, {0.5f, 0.5f, 0.5f}), desc.attenuationDistance = 1;
        stage.add(t, stage.material(desc));
        stage.surround(glm::vec3(1));
        const Picture p = stage.render(16, 16, lookFrom({0, 0, 0}, {0, 0, 1}, 3, 1),
                                       stage.options(effort(64)));
        if (tinted) EXPECT_LT(p.mean().x, 0.5);
        else EXPECT_NEAR(p.mean().x, 1, 0.01);
    }
}

TEST_P(LibraryMaterial, ReplacedByName) {
    Stage stage(GetParam());
    Triangles t;
    t.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    GpMaterialDesc paint = lambertDesc(glm::vec3(0.2f));
    paint.name = "paint";
    stage.add(t, stage.material(paint));
    stage.surround(glm::vec3(1));
    const GpMaterial gold = stage.material(
        materialOf(newBsdf(stage, "lambert", {{"base_color", "0.9,0.6,0.1"}})));
    uint32_t replaced = 7;
    stage.check(gpReplaceMaterial(stage.scene, "pain", gold, &replaced));
    EXPECT_EQ(replaced, 0u);
    stage.check(gpReplaceMaterial(stage.scene, "paint", gold, &replaced));
    EXPECT_EQ(replaced, 1u);
    const Picture p = stage.render(8, 8, lookFrom({0, 0, 0}, {0, 0, 1}, 3, 1), stage.options(64));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(p.mean()[c], (glm::vec3(0.9f, 0.6f, 0.1f))[c], 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, LibraryMaterial, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
