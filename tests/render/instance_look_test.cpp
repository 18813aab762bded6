// What instances bring of their own (colour, visibility by name), and texture layers.
#include <cmath>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

class InstanceLook : public ::testing::TestWithParam<Variant> {
protected:
    static Triangles square(float z) {
        Triangles t;
        t.quad({-0.5f, -0.5f, z}, {1, 0, 0}, {0, 1, 0});
        return t;
    }
    static GpInstance add(Stage& stage, const Triangles& t, GpMaterial material,
                          glm::vec4 color = glm::vec4(0),
                          GpVisibility visibility = GP_VISIBILITY_WORLD) {
        const GpMeshDesc mesh = meshDesc(t, material);
        GpInstanceDesc desc{};
        desc.mesh = gpNewMesh(stage.device, &mesh);
        desc.visibility = visibility;
        for (int c = 0; c < 4; ++c) desc.color[c] = color[c];
        const GpInstance instance = gpNewInstance(stage.scene, &desc);
        if (!instance) stage.check(gpGetError(stage.device, nullptr));
        return instance;
    }
    // Unlit surfaces show their base colour as it is.
    static GpMaterialDesc plain(glm::vec3 color) {
        GpMaterialDesc d = lambertDesc(color);
        d.unlit = 1;
        return d;
    }
    static glm::vec3 seen(Stage& stage, uint32_t samples = 1) {
        const Picture p = stage.render(4, 4, lookFrom({0, 0, 0}, {0, 0, 1}, 5, 0.5f),
                                       stage.options(samples));
        return p.mean();
    }
    static void expectNear(glm::vec3 got, glm::vec3 wanted, const char* what) {
        EXPECT_LT(glm::length(got - wanted), 1e-5f)
            << what << ": " << got.x << ", " << got.y << ", " << got.z;
    }
};

TEST_P(InstanceLook, ColourMultipliesBaseColour) {
    Stage stage(GetParam());
    Triangles t = square(0);
    t.colors.assign(6, {1, 0.2f, 1, 1});
    const GpInstance instance =
        add(stage, t, stage.material(plain({0.5f, 1, 0.25f})), {0.5f, 0.5f, 1, 1});
    expectNear(seen(stage), {0.25f, 0.1f, 0.25f}, "base, vertices and instance");
    const float black[4] = {0, 0, 0, 1};
    stage.check(gpSetInstanceColor(instance, black));
    expectNear(seen(stage), glm::vec3(0), "black");
    stage.check(gpSetInstanceColor(instance, nullptr));
    expectNear(seen(stage), {0.5f, 0.2f, 0.25f}, "white again");
}

TEST_P(InstanceLook, InstancesOfOneMeshHaveTheirOwn) {
    Stage stage(GetParam());
    GpMeshDesc mesh = meshDesc(square(0), nullptr);
    const Triangles t = square(0);
    mesh = meshDesc(t, stage.material(plain(glm::vec3(1))));
    GpInstanceDesc desc{};
    desc.mesh = gpNewMesh(stage.device, &mesh);
    const float side[3] = {-0.5f, 0, 0.5f};
    for (int i = 0; i < 3; ++i) {
        const float at[12] = {0.4f, 0, 0, side[i], 0, 1, 0, 0, 0, 0, 1, 0};
        std::copy_n(at, 12, desc.worldFromObject);
        for (int c = 0; c < 4; ++c) desc.color[c] = c == i || c == 3 ? 1.0f : 0.0f;
        ASSERT_NE(gpNewInstance(stage.scene, &desc), nullptr);
    }
    GpRenderOptions o = stage.options(1);
    o.pixelFilter = GP_PIXEL_BOX, o.pixelFilterRadius = 0.01f;
    GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 5, 0.5f);
    const Picture p = stage.render(3, 1, camera, o);  // 1.5 m wide
    for (uint32_t i = 0; i < 3; ++i) {
        glm::vec3 wanted(0);
        wanted[int(i)] = 1;
        expectNear(p.at(i, 0), wanted, "one of three");
    }
}

TEST_P(InstanceLook, AlphaCoversAsMuch) {
    Stage stage(GetParam());
    stage.surround(glm::vec3(1));
    GpMaterialDesc d = plain(glm::vec3(0));
    d.alphaMode = GP_ALPHA_BLEND, d.baseColor[3] = 0.8f;
    add(stage, square(0), stage.material(d), {1, 1, 1, 0.5f});
    const Picture p = stage.render(16, 16, lookFrom({0, 0, 0}, {0, 0, 1}, 5, 0.5f),
                                   stage.options(effort(1024)));
    expectMean(p, 1 - 0.4);
}

GpTexture texel(Stage& stage, glm::vec4 rgba) {
    GpTextureDesc d{};
    d.width = d.height = 1, d.format = GP_FORMAT_RGBA32F, d.pixels = &rgba.x;
    return stage.texture(d);
}

TEST_P(InstanceLook, TextureLayersBlendInTheirOrder) {
    const glm::vec3 base(0.5f, 0.25f, 0.125f), a(0.5f, 0.4f, 0.8f);
    const float alpha = 0.25f;
    const glm::vec3 expected[] = {a, glm::mix(base, a, alpha), glm::min(base + a, glm::vec3(1)),
                                  glm::min(2.0f * base * a, glm::vec3(1))};
    const GpLayerBlend blends[] = {GP_LAYER_OPAQUE, GP_LAYER_ALPHA, GP_LAYER_ADD, GP_LAYER_SHADE};
    const glm::vec4 tint(0.5f, 1, 0.75f, 1);
    for (int i = 0; i < 4; ++i) {
        Stage stage(GetParam());
        GpTextureLayer layers[2] = {};
        layers[0].texture.texture = texel(stage, {2.0f * a, 0.5f});
        layers[0].blend = blends[i];
        const float half[4] = {0.5f, 0.5f, 0.5f, 0.5f};
        std::copy_n(half, 4, layers[0].color);
        layers[1].blend = GP_LAYER_ADD;  // a colour without a texture
        layers[1].color[1] = 0.125f;
        GpMaterialDesc d = plain(2.0f * base);
        d.baseColorTexture.texture = texel(stage, glm::vec4(0.5f));
        d.textureLayers = layers;
        for (const uint32_t count : {1u, 2u}) {
            d.textureLayerCount = count;
            const GpInstance instance = add(stage, square(0), stage.material(d), tint);
            const glm::vec3 over = expected[i] + glm::vec3(0, count == 2 ? 0.125f : 0, 0);
            expectNear(seen(stage), over * glm::vec3(tint), "layers");
            stage.check(gpRemoveInstance(instance));
        }
    }
}

// A layer alone makes the material read coordinates; the second set, moved.
TEST_P(InstanceLook, LayersHaveCoordinatesOfTheirOwn) {
    Stage stage(GetParam());
    const uint8_t pixels[8] = {0, 0, 0, 255, 255, 255, 255, 255};
    GpTextureDesc texture{};
    texture.width = 2, texture.height = 1, texture.pixels = pixels;
    texture.magFilter = texture.minFilter = GP_FILTER_NEAREST;
    GpTextureLayer layer{};
    layer.texture.texture = stage.texture(texture);
    layer.texture.texCoord = 1;
    const float moved[6] = {1, 0, 0.5f, 0, 1, 0};  // the halves change places
    std::copy_n(moved, 6, layer.texture.transform);
    GpMaterialDesc d = plain({0.5f, 0, 0});
    d.textureLayers = &layer, d.textureLayerCount = 1;
    Triangles t = square(0);
    t.uv1 = t.uv0;
    t.uv0.clear();
    add(stage, t, stage.material(d));
    const Picture p =
        stage.render(4, 2, lookFrom({0, 0, 0}, {0, 0, 1}, 5, 0.4f), stage.options(1));
    expectNear(p.at(0, 0), glm::vec3(1), "left");
    expectNear(p.at(3, 0), glm::vec3(0), "right");
}

// ------------------------------------------------------------------------ visibility by name

// A plane under the sun with a square above: whether the camera sees the square, and its shadow.
TEST_P(InstanceLook, FirstPersonCastsNoShadowAndTheBodyIsNotSeen) {
    for (const GpVisibility visibility :
         {GP_VISIBILITY_WORLD, GP_VISIBILITY_FIRST_PERSON, GP_VISIBILITY_VIEWER_BODY}) {
        Stage stage(GetParam());
        Triangles ground, hand;
        ground.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10});
        hand.quad({-1, 1, 1}, {2, 0, 0}, {0, 0, -2});
        GpLightDesc sun{};
        sun.intensity = float(pi);
        stage.light(sun);
        add(stage, ground, stage.lambert(glm::vec3(0.5f)));
        const GpInstance instance =
            add(stage, hand, stage.lambert(glm::vec3(0.25f)), {}, visibility);
        const auto look = [&](float height) {
            GpRenderOptions o = stage.options(4);
            o.maxBounces = GP_NO_BOUNCES;
            return stage.render(4, 4, lookFrom({0, 0, 0}, {0, 1, 0}, height, 0.2f), o).mean().x;
        };
        const bool seen = visibility != GP_VISIBILITY_VIEWER_BODY;
        const bool shadows = visibility != GP_VISIBILITY_FIRST_PERSON;
        EXPECT_NEAR(look(3), seen ? 0.25 : shadows ? 0 : 0.5, 1e-4) << "from above";
        EXPECT_NEAR(look(0.5f), shadows ? 0 : 0.5, 1e-4) << "from below";
        stage.check(gpSetInstanceVisibility(instance, GP_VISIBILITY_WORLD, GP_VISIBLE_SHADOW));
        EXPECT_NEAR(look(3), 0.25, 1e-4) << "changed";
        EXPECT_NEAR(look(0.5f), 0.5, 1e-4) << "changed";
    }
}

// What no reflection shows lights nothing: all of its light is missing then, not a part of it.
TEST_P(InstanceLook, WhatGlowsInTheHandLightsNothing) {
    for (const GpVisibility visibility : {GP_VISIBILITY_WORLD, GP_VISIBILITY_FIRST_PERSON}) {
        Stage stage(GetParam());
        Triangles ground, lamp;
        ground.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10});
        lamp.quad({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1});
        add(stage, ground, stage.lambert(glm::vec3(0.5f)));
        add(stage, lamp, stage.lambert(glm::vec3(0), glm::vec3(2)), {}, visibility);
        GpRenderOptions o = stage.options(effort(1024));
        o.maxBounces = GP_NO_BOUNCES;
        const double form =
            polygonIrradiance(quadPolygon({-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}), {0, 1, 0});
        const bool world = visibility == GP_VISIBILITY_WORLD;
        expectMean(stage.render(8, 8, lookFrom({0, 0, 0}, {0, 1, 0}, 0.1f, 1e-3f), o),
                   world ? 0.5 * 2 * form / pi : 0, "on the ground");
        expectMean(stage.render(4, 4, lookFrom({0, 1, 0}, {0, -1, 0}, 0.5f, 0.1f), o), 2.0,
                   "seen");
    }
}

INSTANTIATE_TEST_SUITE_P(All, InstanceLook, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });

// In a mirror: the body, but not the hand.
class Mirrors : public InstanceLook {};

TEST_P(Mirrors, ShowTheBodyAndNotTheHand) {
    for (const GpVisibility visibility :
         {GP_VISIBILITY_WORLD, GP_VISIBILITY_FIRST_PERSON, GP_VISIBILITY_VIEWER_BODY}) {
        Stage stage(GetParam());
        stage.surround(glm::vec3(1));
        GpMaterialDesc mirror{};
        mirror.given = GP_GIVEN_ROUGHNESS;
        mirror.metallic = 1;
        add(stage, square(0), stage.material(mirror));
        add(stage, square(1), stage.lambert(glm::vec3(0)), {}, visibility);
        GpRenderOptions o = stage.options(16);
        const double mean =
            stage.render(4, 4, lookFrom({0, 0, 0}, {0, 0, 1}, 0.5f, 0.2f), o).mean().x;
        EXPECT_NEAR(mean, visibility == GP_VISIBILITY_FIRST_PERSON ? 1 : 0, 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Full, Mirrors, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
