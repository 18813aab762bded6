// gpSetCubemap in pictures: each face in its place, light from it, its factors.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class Cubemaps : public ::testing::TestWithParam<Variant> {};

// 8 x 8 pixels of 8 bits: a colour for each face, and a bright quarter where s and t are below 0.5.
struct Faces {
    std::array<GpTexture, 6> textures{};
    Faces(Stage& stage, GpColorSpace space) {
        for (uint32_t face = 0; face < 6; ++face) {
            std::vector<uint8_t> pixels;
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) {
                    const uint8_t v = uint8_t(20 * (face + 1)), q = x < 4 && y < 4 ? 255 : 0;
                    pixels.insert(pixels.end(), {v, q, 128, 0});  // alpha is not read
                }
            GpTextureDesc d{};
            d.width = d.height = 8, d.pixels = pixels.data(), d.colorSpace = space;
            textures[face] = stage.texture(d);
        }
    }
    GpCubemapDesc desc() const {
        GpCubemapDesc d{};
        for (size_t i = 0; i < 6; ++i) d.faces[i] = textures[i];
        return d;
    }
};

glm::vec3 look(Stage& stage, glm::vec3 direction) {
    GpCameraDesc camera = lookFrom(glm::vec3(0), -glm::normalize(direction), 1, 0.02f);
    return stage.render(2, 2, camera, stage.options(1)).at(0, 0);
}

TEST_P(Cubemaps, FacesAreSeenWhereTheyBelong) {
    Stage stage(GetParam());
    Faces faces(stage, GP_COLOR_LINEAR);
    GpCubemapDesc d = faces.desc();
    stage.check(gpSetCubemap(stage.scene, &d));
    // Towards the middle of the quarter with small s and t, by OpenGL's table.
    const glm::vec3 quarters[6] = {{1, 0.5f, 0.5f},   {-1, 0.5f, -0.5f}, {-0.5f, 1, -0.5f},
                                   {-0.5f, -1, 0.5f}, {-0.5f, 0.5f, 1},  {0.5f, 0.5f, -1}};
    for (uint32_t face = 0; face < 6; ++face) {
        const glm::vec3 bright = look(stage, quarters[face]);
        EXPECT_NEAR(bright.x, 20.0 * (face + 1) / 255, 2e-3) << face;
        EXPECT_NEAR(bright.y, 1, 2e-3) << face;
        EXPECT_NEAR(bright.z, 128.0 / 255, 2e-3) << face;
        // The other side of the face's middle.
        glm::vec3 across = -quarters[face];
        for (int c = 0; c < 3; ++c)
            if (std::abs(across[c]) == 1) across[c] = -across[c];
        const glm::vec3 dark = look(stage, across);
        EXPECT_NEAR(dark.x, 20.0 * (face + 1) / 255, 2e-3) << face;
        EXPECT_NEAR(dark.y, 0, 2e-3) << face;
    }
}

TEST_P(Cubemaps, ColourTurnAndEncodingCount) {
    Stage stage(GetParam());
    Faces faces(stage, GP_COLOR_SRGB);
    GpCubemapDesc d = faces.desc();
    d.color[0] = 100, d.color[1] = 1, d.color[2] = 2;
    // The cube's +X is the world's +Y, its +Y the world's +X: mirrored.
    const float swapped[9] = {0, 1, 0, 1, 0, 0, 0, 0, 1};
    std::copy(swapped, swapped + 9, d.worldFromCube);
    stage.check(gpSetCubemap(stage.scene, &d));
    const auto decoded = [](double v) { return std::pow((v / 255 + 0.055) / 1.055, 2.4); };
    const glm::vec3 up = look(stage, {0.5f, 1, -0.5f}), right = look(stage, {1, -0.5f, 0.5f});
    // Beside the full green of that quarter its red is rounded to a part in 1,000 of it.
    EXPECT_NEAR(up.x, 100 * decoded(20), 0.1);
    EXPECT_NEAR(up.z, 2 * decoded(128), 2e-3);
    EXPECT_NEAR(right.x, 100 * decoded(60), 0.01 * right.x);
}

TEST_P(Cubemaps, LightsAsWhatItShows) {
    Stage stage(GetParam());
    std::array<GpTexture, 6> faces{};
    for (size_t i = 0; i < 6; ++i) {
        const float v = i == 2 ? 3.0f : 1.0f;  // from above
        const float pixel[4] = {v, 0.5f, 0.25f, 1};
        GpTextureDesc d{};
        d.width = d.height = 1, d.format = GP_FORMAT_RGBA32F, d.pixels = pixel;
        faces[i] = stage.texture(d);
    }
    GpCubemapDesc d{};
    std::copy(faces.begin(), faces.end(), d.faces);
    stage.check(gpSetCubemap(stage.scene, &d));
    Triangles plane;
    plane.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    stage.add(plane, stage.lambert(glm::vec3(0.5f)));
    GpRenderOptions o = stage.options(effort(512));
    const Picture p = stage.render(8, 8, lookFrom({0, 0, 0}, {0, 1, 0}, 1, 0.5f), o);
    EXPECT_NEAR(p.mean().y, 0.25, 4 * p.sigma().y + 1e-3);
    EXPECT_NEAR(p.mean().z, 0.125, 4 * p.sigma().z + 1e-3);
    // More from above than the mean of the sky says, less than from that face alone.
    EXPECT_GT(p.mean().x, 0.5 * (1 + 2 / 6.0));
    EXPECT_LT(p.mean().x, 0.5 * 3);
}

TEST_P(Cubemaps, TakesThePlaceOfASkyAndItsSun) {
    Stage stage(GetParam());
    stage.check(gpSetSky(stage.scene, 0, 1, 0));
    Faces faces(stage, GP_COLOR_LINEAR);
    GpCubemapDesc d = faces.desc();
    stage.check(gpSetCubemap(stage.scene, &d));
    GpSceneInfo info{};
    stage.check(gpGetSceneInfo(stage.scene, &info));
    EXPECT_EQ(info.lights, 0u);
    EXPECT_NE(info.hasEnvironment, 0);
    // What failed changes nothing.
    d.faces[3] = nullptr;
    EXPECT_NE(gpSetCubemap(stage.scene, &d), GP_SUCCESS);
    EXPECT_NEAR(look(stage, {1, 0.5f, 0.5f}).y, 1, 2e-3);
    gpGetError(stage.device, nullptr);
}

INSTANTIATE_TEST_SUITE_P(, Cubemaps, ::testing::ValuesIn(bestVariants()),
                         [](const auto& p) { return variantName(p.param); });

}  // namespace
}  // namespace gp::test
