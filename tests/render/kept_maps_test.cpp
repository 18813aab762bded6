// gpReplaceMaterialModel: another model in a material's place, with the maps of the old one.
#include <array>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

struct Words {
    const char* model;
    std::vector<GpBsdfParameter> parameters;
};

GpBsdf newBsdf(const Stage& stage, const Words& words) {
    GpBsdfDesc desc{};
    desc.model = words.model;
    desc.parameters = words.parameters.data();
    desc.parameterCount = uint32_t(words.parameters.size());
    const GpBsdf bsdf = gpNewBsdf(stage.device, &desc);
    if (!bsdf) stage.check(GP_ERROR_UNKNOWN);
    return bsdf;
}

GpTexture onePixel(Stage& stage, std::array<uint8_t, 4> rgba, GpColorSpace space) {
    GpTextureDesc d{};
    d.width = d.height = 1;
    d.pixels = rgba.data();
    d.colorSpace = space;
    return stage.texture(d);
}

constexpr float texelRoughness = 128 / 255.0f, factor = 0.8f;
constexpr float bothRoughness = texelRoughness * factor;

// A square under a lamp, in light that has no noise, whose glTF material has maps of all kinds.
struct Mapped {
    Stage stage;
    GpMaterialDesc desc{};
    GpTexture color, roughness, normal;

    Mapped() : stage(localVariants().back()) {
        color = onePixel(stage, {255, 188, 99, 255}, GP_COLOR_SRGB);
        roughness = onePixel(stage, {0, 128, 255, 255}, GP_COLOR_LINEAR);
        normal = onePixel(stage, {160, 128, 250, 255}, GP_COLOR_LINEAR);
        desc.name = "thing";
        put(desc.baseColor, {0.9f, 0.8f, 1});
        desc.baseColor[3] = 1;
        desc.baseColorTexture.texture = color;
        desc.metallic = 0.5f;
        desc.roughness = factor;
        desc.metallicRoughnessTexture.texture = roughness;
        desc.normalTexture.texture = normal;
        desc.given = GP_GIVEN_NORMAL_SCALE;
        desc.normalScale = 1.5f;
    }
    // As the replacing material is to have them.
    void giveColorAndNormals(GpMaterialDesc& d) const {
        put(d.baseColor, {0.9f, 0.8f, 1});
        d.baseColor[3] = 1;
        d.baseColorTexture.texture = color;
        d.normalTexture.texture = normal;
        d.given |= GP_GIVEN_NORMAL_SCALE;
        d.normalScale = 1.5f;
    }
    void add(const GpMaterialDesc& d) {
        Triangles t;
        t.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        stage.add(t, stage.material(d));
        GpLightDesc lamp{};
        lamp.kind = GP_LIGHT_SPHERE;
        lamp.intensity = 4;
        put(lamp.position, {0.6f, 0.2f, 1});
        stage.light(lamp);
    }
    Picture picture() {
        return stage.render(16, 16, lookFrom({0, 0, 0}, {0, 0, 1}, 3, 1.5f), stage.options(4));
    }
    GpReplacedMaterials replace(const GpMaterialDesc& d, uint32_t keep = GP_MAP_ALL) {
        GpReplacedMaterials replaced{};
        stage.check(
            gpReplaceMaterialModel(stage.scene, "thing", stage.material(d), keep, &replaced));
        EXPECT_EQ(replaced.instances, 1u);
        return replaced;
    }
};

GpMaterialDesc materialOf(GpBsdf bsdf) {
    GpMaterialDesc d{};
    d.bsdf = bsdf;
    return d;
}

void expectSame(const Picture& a, const Picture& b, float tolerance) {
    for (size_t i = 0; i < a.color.size(); ++i)
        for (int c = 0; c < 4; ++c)
            ASSERT_NEAR(a.color[i][c], b.color[i][c], tolerance * (0.01f + b.color[i][c])) << i;
    EXPECT_GT(b.mean().x, 0.001);
}

// Roughness as it is, or its square, by a mask: the same as if the parameter had been set.
TEST(KeptMaps, RoughnessOfTheFileIsThatOfTheModel) {
    const std::string rough = std::to_string(bothRoughness);
    const std::string width = std::to_string(bothRoughness * bothRoughness);
    const std::pair<Words, Words> cases[] = {
        {{"disney", {{"specular", "0.9"}}},
         {"disney",
          {{"specular", "0.9"}, {"base_color", "1"}, {"roughness", rough.c_str()}}}},
        {{"ggx_conductor", {{"base_color", "0.3,0.1,0.2"}}},
         {"ggx_conductor", {{"alpha_x", width.c_str()}, {"alpha_y", width.c_str()}}}},
        {{"microfacet", {{"distribution", "beckmann"}}},
         {"microfacet",
          {{"distribution", "beckmann"}, {"alpha_x", width.c_str()}, {"alpha_y", width.c_str()}}}},
    };
    for (const auto& [word, meant] : cases) {
        SCOPED_TRACE(word.model);
        Mapped replaced, expected;
        replaced.add(replaced.desc);
        const auto maps = replaced.replace(materialOf(newBsdf(replaced.stage, word)));
        EXPECT_EQ(maps.kept, uint32_t(GP_MAP_BASE_COLOR | GP_MAP_NORMAL | GP_MAP_ROUGHNESS));
        EXPECT_EQ(maps.left, uint32_t(GP_MAP_METALLIC));
        GpMaterialDesc d = materialOf(newBsdf(expected.stage, meant));
        expected.giveColorAndNormals(d);
        expected.add(d);
        const Picture p = replaced.picture();
        // Where roughness is 0 the width is the smallest there is, 1e-4: half a thousandth of what
        // comes out here, which the brightest pixel has twice, and Beckmann's tail ten times.
        expectSame(p, expected.picture(), 1e-2f);
        // The same again has what it had, by the name that it kept.
        const auto again = replaced.replace(materialOf(newBsdf(replaced.stage, word)));
        EXPECT_EQ(again.kept, uint32_t(GP_MAP_BASE_COLOR | GP_MAP_NORMAL));
        EXPECT_EQ(again.left, uint32_t(GP_MAP_OTHERS)) << "roughness is a mask now";
    }
}

TEST(KeptMaps, GltfKeepsAllOfGltf) {
    Mapped replaced, expected;
    replaced.add(replaced.desc);
    GpMaterialDesc coated{};
    coated.coat = 0.7f;
    const auto maps = replaced.replace(coated);
    EXPECT_EQ(maps.kept, uint32_t(GP_MAP_BASE_COLOR | GP_MAP_NORMAL | GP_MAP_ROUGHNESS |
                                  GP_MAP_METALLIC));
    EXPECT_EQ(maps.left, 0u);
    expected.desc.coat = 0.7f;
    expected.add(expected.desc);
    expectSame(replaced.picture(), expected.picture(), 1e-5f);
}

TEST(KeptMaps, NothingIsKeptThatWasNotAskedFor) {
    Mapped replaced, expected;
    replaced.add(replaced.desc);
    const auto maps =
        replaced.replace(materialOf(newBsdf(replaced.stage, {"ggx_conductor", {}})), 0);
    EXPECT_EQ(maps.kept, 0u);
    EXPECT_EQ(maps.left, uint32_t(GP_MAP_BASE_COLOR | GP_MAP_NORMAL | GP_MAP_ROUGHNESS |
                                  GP_MAP_METALLIC));
    expected.add(materialOf(newBsdf(expected.stage, {"ggx_conductor", {}})));
    expectSame(replaced.picture(), expected.picture(), 0);
}

// A model that reads no colour; a light that stays on; slope maps; a texture nobody else has.
TEST(KeptMaps, WhatBelongsToTheThing) {
    Mapped m;
    GpSlopeMap bumps{};
    bumps.texture.texture = m.normal;
    m.desc.slopeMaps = &bumps;
    m.desc.slopeMapCount = 1;
    m.desc.coat = 1;
    m.desc.coatTexture.texture = m.color;
    put(m.desc.emission, {0.25f, 0.5f, 1});
    m.add(m.desc);
    const auto maps = m.replace(materialOf(newBsdf(m.stage, {"iridescent_mirror", {}})));
    EXPECT_EQ(maps.kept,
              uint32_t(GP_MAP_NORMAL | GP_MAP_SLOPES | GP_MAP_EMISSION | GP_MAP_ROUGHNESS));
    EXPECT_EQ(maps.left, uint32_t(GP_MAP_BASE_COLOR | GP_MAP_METALLIC | GP_MAP_OTHERS));
    const Picture p = m.picture();
    for (const glm::vec4& c : p.color) EXPECT_GE(c.z, 1.0f) << "it shines by itself";
}

// A colour without a texture is one too; `material` has another tint of its own.
TEST(KeptMaps, ColoursWithoutTextures) {
    Mapped replaced, expected;
    replaced.desc = {};
    replaced.desc.name = "thing";
    put(replaced.desc.baseColor, {0.5f, 0.25f, 1});
    replaced.add(replaced.desc);
    GpMaterialDesc tinted = materialOf(newBsdf(replaced.stage, {"disney", {}}));
    put(tinted.baseColor, {0.5f, 1, 1});
    tinted.baseColor[3] = 1;
    EXPECT_EQ(replaced.replace(tinted).kept, uint32_t(GP_MAP_BASE_COLOR));
    expected.add(
        materialOf(newBsdf(expected.stage, {"disney", {{"base_color", "0.25,0.25,1"}}})));
    expectSame(replaced.picture(), expected.picture(), 1e-4f);
}

// Leaves cut out by the alpha of a red texture, which has to stay although its colour goes.
TEST(KeptMaps, AlphaWithoutItsColour) {
    Mapped m;
    const uint8_t half[] = {255, 0, 0, 255, 255, 0, 0, 0};
    GpTextureDesc leaf{};
    leaf.width = 2, leaf.height = 1;
    leaf.pixels = half;
    leaf.magFilter = leaf.minFilter = GP_FILTER_NEAREST;
    m.desc = {};
    m.desc.name = "thing";
    m.desc.baseColorTexture.texture = m.stage.texture(leaf);
    m.desc.alphaMode = GP_ALPHA_MASK;
    m.add(m.desc);
    const GpBsdf blue = newBsdf(m.stage, {"lambert", {{"base_color", "0.1,0.2,0.8"}}});
    const auto maps = m.replace(materialOf(blue), GP_MAP_ALL & ~uint32_t(GP_MAP_BASE_COLOR));
    EXPECT_EQ(maps.kept, uint32_t(GP_MAP_ALPHA));
    EXPECT_EQ(maps.left, uint32_t(GP_MAP_BASE_COLOR));
    const Picture p = m.picture();
    uint32_t there = 0;
    for (uint32_t i = 0; i < 256; ++i) {
        const glm::vec4 c = p.color[i];
        if (i % 16 < 7) { EXPECT_EQ(c.w, 1.0f) << i; }
        if (i % 16 > 8) { EXPECT_EQ(c, glm::vec4(0)) << i; }
        if (c.w < 1) continue;
        ++there;
        EXPECT_NEAR(c.x / c.z, 0.125f, 1e-3f) << i;
        EXPECT_NEAR(c.y / c.z, 0.25f, 1e-3f) << i;
    }
    EXPECT_GE(there, 7u * 16);
}

}  // namespace
}  // namespace gp::test
