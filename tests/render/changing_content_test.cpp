// Textures, materials and coordinates that change: the scene is then, to the bit, the one that was
// made so from the start.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class ChangingContent : public ::testing::TestWithParam<Variant> {};

// A ground of 2 m with its texture 4 times across, seen at an angle, so that many levels are read;
// beside it a lamp, if it has any light.
struct Room {
    Stage stage{GetVariant()};
    Triangles ground, lamp;

    static Variant GetVariant() { return bestFullVariant().front(); }
    Room() {
        ground.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
        for (glm::vec2& uv : ground.uv0) uv *= 4.0f;
        lamp.quad({-0.8f, 0.9f, -0.9f}, {1.6f, 0, 0}, {0, -0.5f, 0.1f});
        stage.surround(glm::vec3(0.3f));
    }
    std::vector<glm::vec4> look() {
        const GpCameraDesc camera = lookFrom({0, 0.2f, 0}, {0, 0.4472136f, 0.8944272f}, 3, 2.2f);
        return stage.render(32, 24, camera, stage.options(8)).color;
    }
    GpInstance add(const Triangles& triangles, GpMaterial material) {
        return stage.add(triangles, material);
    }
};

std::vector<uint8_t> noise(uint32_t width, uint32_t height, uint32_t seed) {
    std::vector<uint8_t> bytes(size_t(width) * height * 4);
    for (uint8_t& b : bytes) b = uint8_t((seed = seed * 1664525u + 1013904223u) >> 24);
    return bytes;
}

GpTextureDesc descOf(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height) {
    GpTextureDesc d{};
    d.width = width, d.height = height, d.pixels = pixels.data();
    return d;
}

GpMaterialDesc textured(GpTexture texture) {
    GpMaterialDesc d = lambertDesc(glm::vec3(1));
    d.baseColorTexture.texture = texture;
    return d;
}

TEST_P(ChangingContent, APictureWithNewPixels) {
    const uint32_t width = 23, height = 16;  // odd: each smaller level shares texels
    std::vector<uint8_t> pixels = noise(width, height, 1);
    Room changed;
    const GpTextureDesc first = descOf(pixels, width, height);
    const GpTexture texture = changed.stage.texture(first);
    changed.add(changed.ground, changed.stage.material(textured(texture)));
    const auto before = changed.look();

    // A rectangle out of a picture that is wider than it.
    const std::vector<uint8_t> patch = noise(40, 9, 7);
    GpTextureUpdate update{};
    update.x = 11, update.y = 5, update.width = 12, update.height = 9;
    update.pixels = patch.data(), update.rowBytes = 40 * 4;
    changed.stage.check(gpUpdateTexture(texture, &update));
    for (size_t y = 0; y < 9; ++y)
        std::copy_n(&patch[y * 160], 12 * 4, &pixels[((y + 5) * width + 11) * 4]);

    Room fresh;
    fresh.add(fresh.ground,
              fresh.stage.material(textured(fresh.stage.texture(descOf(pixels, width, height)))));
    EXPECT_EQ(changed.look(), fresh.look());
    EXPECT_NE(changed.look(), before);
}

TEST_P(ChangingContent, ALampWithNewPixelsLightsAnew) {
    const std::vector<uint8_t> dark(16, 0), bright(16, 255);
    const auto glowing = [](Room& room, const std::vector<uint8_t>& pixels) {
        const GpTexture texture = room.stage.texture(descOf(pixels, 2, 2));
        GpMaterialDesc d = lambertDesc(glm::vec3(0));
        put(d.emission, glm::vec3(6));
        d.emissionTexture.texture = texture;
        room.add(room.lamp, room.stage.material(d));
        room.add(room.ground, room.stage.lambert(glm::vec3(0.5f)));
        return texture;
    };
    Room changed, fresh;
    const GpTexture texture = glowing(changed, dark);
    glowing(fresh, bright);
    const auto before = changed.look();
    GpTextureUpdate update{};
    update.width = update.height = 2, update.pixels = bright.data();
    changed.stage.check(gpUpdateTexture(texture, &update));
    EXPECT_EQ(changed.look(), fresh.look());
    EXPECT_NE(changed.look(), before);
}

// More samples may be added to a picture only as long as what it shows stays.
TEST_P(ChangingContent, OnlyScenesThatShowATextureChangeWithIt) {
    Room room;
    std::vector<uint8_t> pixels = noise(4, 4, 3);
    const GpTexture shown = room.stage.texture(descOf(pixels, 4, 4));
    const GpTexture other = room.stage.texture(descOf(pixels, 4, 4));
    room.stage.material(textured(other));  // in a material that nothing has
    room.add(room.ground, room.stage.material(textured(shown)));
    const GpFrame frame = room.stage.frame(8, 8);
    GpRenderOptions more = room.stage.options(1);
    more.accumulate = 1;
    const auto render = [&] { return gpRender(frame, room.stage.scene, nullptr, &more); };
    EXPECT_EQ(render(), GP_SUCCESS);
    GpTextureUpdate update{};
    update.width = update.height = 4, update.pixels = pixels.data();
    EXPECT_EQ(gpUpdateTexture(other, &update), GP_SUCCESS);
    EXPECT_EQ(render(), GP_SUCCESS);
    EXPECT_EQ(gpUpdateTexture(shown, &update), GP_SUCCESS);
    EXPECT_EQ(render(), GP_ERROR_INVALID_OPERATION);
}

// Frames that differ in all that a scene keeps of a material: light, holes, texture.
std::vector<std::function<GpMaterial(Stage&)>> frames() {
    return {[](Stage& s) { return s.lambert({0.8f, 0.2f, 0.1f}); },
            [](Stage& s) { return s.lambert({0, 0, 0}, {5, 4, 3}); },
            [](Stage& s) {
                GpMaterialDesc d = lambertDesc({0.2f, 0.9f, 0.2f});
                d.alphaMode = GP_ALPHA_BLEND, d.baseColor[3] = 0.4f;
                return s.material(d);
            },
            [](Stage& s) {
                const std::vector<uint8_t> pixels = noise(8, 8, 5);
                return s.material(textured(s.texture(descOf(pixels, 8, 8))));
            }};
}

TEST_P(ChangingContent, EachFrameOfAnAnimatedMaterial) {
    const auto makers = frames();
    Room animated;
    std::vector<GpMaterial> all;
    for (const auto& make : makers) all.push_back(make(animated.stage));
    const GpMaterial material =
        gpNewAnimatedMaterial(animated.stage.device, all.data(), uint32_t(all.size()));
    ASSERT_NE(material, nullptr);
    for (const GpMaterial m : all) animated.stage.check(gpReleaseMaterial(m));
    animated.add(animated.lamp, material);
    animated.add(animated.ground, animated.stage.lambert(glm::vec3(0.6f)));
    std::vector<std::vector<glm::vec4>> pictures;
    for (const uint32_t frame : {0u, 1u, 2u, 3u, 0u}) {
        animated.stage.check(gpSetMaterialFrame(material, frame));
        Room fixed;
        fixed.add(fixed.lamp, makers[frame](fixed.stage));
        fixed.add(fixed.ground, fixed.stage.lambert(glm::vec3(0.6f)));
        pictures.push_back(animated.look());
        EXPECT_EQ(pictures.back(), fixed.look()) << "frame " << frame;
    }
    EXPECT_EQ(pictures[0], pictures[4]);
    for (size_t i = 0; i < 4; ++i)
        for (size_t k = 0; k < i; ++k) EXPECT_NE(pictures[i], pictures[k]) << i << ", " << k;
}

TEST_P(ChangingContent, AnInstanceWithAnotherMaterial) {
    Room changed, fresh;
    const GpInstance instance =
        changed.add(changed.lamp, changed.stage.lambert({0.8f, 0.2f, 0.1f}));
    changed.add(changed.ground, changed.stage.lambert(glm::vec3(0.6f)));
    const auto before = changed.look();
    changed.stage.check(
        gpSetInstanceMaterial(instance, changed.stage.lambert({0, 0, 0}, {5, 4, 3})));
    fresh.add(fresh.lamp, fresh.stage.lambert({0, 0, 0}, {5, 4, 3}));
    fresh.add(fresh.ground, fresh.stage.lambert(glm::vec3(0.6f)));
    EXPECT_EQ(changed.look(), fresh.look());
    changed.stage.check(gpSetInstanceMaterial(instance, nullptr));  // the mesh's again
    EXPECT_EQ(changed.look(), before);
}

INSTANTIATE_TEST_SUITE_P(Best, ChangingContent, ::testing::ValuesIn(bestFullVariant()),
                         [](const auto& i) { return variantName(i.param); });

}  // namespace
}  // namespace gp::test
