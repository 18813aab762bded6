// What clear water scatters towards the viewer: as deep water where it is deep, and its closed form
// where it is not; no light is gained.
#include <cmath>

#include <gtest/gtest.h>

#include "render/calm_sea.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 24, height = 16;
constexpr float fov = 0.25f;
const glm::vec3 absorption(0.3f, 0.1f, 0.03f), scattering(0.1f, 0.15f, 0.2f);

// Two suns of different heights and colours under a sky that is bright at the zenith and dark in
// the east.
void addTwoSunsAndASky(Stage& stage) {
    addSun(stage, 0.6, 3, 0.00465f);
    GpLightDesc sun{};
    sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = 2, sun.angularRadius = 0.01f;
    put(sun.color, {1, 0.6f, 0.3f}), put(sun.direction, {-0.5f, -0.4f, 0.5f});
    stage.light(sun);
    constexpr uint32_t w = 32, h = 16;
    std::vector<float> image(w * h * 4, 1.0f);
    for (uint32_t y = 0; y < h; ++y)
        for (uint32_t x = 0; x < w; ++x) {
            float* p = &image[(y * w + x) * 4];
            const float light = (y < h / 2 ? 1.5f - float(y) / 8 : 0.2f) * (x < w / 2 ? 1 : 0.3f);
            p[0] = 0.3f * light, p[1] = 0.5f * light, p[2] = light;
        }
    GpEnvironmentDesc sky{};
    sky.pixels = image.data(), sky.width = w, sky.height = h, sky.rotation = 1;
    stage.check(gpSetEnvironment(stage.scene, &sky));
}

Picture seaUnderTwoSuns(GpOceanDesc desc, double pitch, bool transparent, glm::vec3 scatters) {
    Stage stage(bestFullVariant().front());
    addTwoSunsAndASky(stage);
    put(desc.absorption, absorption), put(desc.scattering, scatters);
    desc.transparent = transparent;
    stage.check(gpSetOcean(stage.scene, &desc));
    stage.check(gpSetOceanTime(stage.scene, 12));
    return stage.render(width, height, looking(pitch, 30), stage.options(effort(256)));
}

// Waves turn light and view; the frame's constants are those of flat water.
TEST(SeaColour, VeryDeepClearWaterIsDeepWater) {
    for (const float wind : {0.0f, 4.0f, 10.0f})
        for (const double pitch : {-0.5, -1.2}) {
            const GpOceanDesc desc = windy(wind);
            const Picture clear = seaUnderTwoSuns(desc, pitch, true, scattering);
            const Picture deep = seaUnderTwoSuns(desc, pitch, false, scattering);
            const Picture black = seaUnderTwoSuns(desc, pitch, false, glm::vec3(0));
            for (int c = 0; c < 3; ++c) {
                const double water = deep.mean()[c] - black.mean()[c];
                const double noise = 4 * std::hypot(clear.sigma()[c], deep.sigma()[c]);
                EXPECT_NEAR(clear.mean()[c], deep.mean()[c], 0.03 * water + noise)
                    << wind << ' ' << pitch << ' ' << c;
            }
        }
}

// Above a black floor all light is the water's: Lee's column.
TEST(SeaColour, OverABlackFloor) {
    const double zenith = 0.5, pitch = -1.2;
    for (const float depth : {0.5f, 3.0f, 100.0f}) {
        Stage stage(bestFullVariant().front());
        const GpOceanDesc desc = clear(calm(), absorption, scattering);
        stage.check(gpSetOcean(stage.scene, &desc));
        addFloor(stage, depth, 0);
        addSun(stage, zenith, 5, 0.00465f);
        const Picture picture =
            stage.render(width, height, looking(pitch), stage.options(effort(256)));
        for (int c = 0; c < 3; ++c) {
            const WaterColumn water =
                underSun(double(absorption[c]), double(scattering[c]), zenith, 5);
            const double expected = meanOverPicture(width, height, fov, pitch, [&](glm::dvec3 w) {
                const double below = refractedCosine(-w.y);
                return (1 - fresnel(-w.y)) / (eta * eta) *
                       water.gathered(0, below, double(depth) / below);
            });
            EXPECT_NEAR(picture.mean()[c], expected, 4 * picture.sigma()[c] + 0.003 * expected)
                << depth << ' ' << c;
            EXPECT_LT(picture.sigma()[c], 0.01 * expected) << depth << ' ' << c;
        }
    }
}

// A furnace over a white floor: water that only scatters gains no light. It loses some, as of what
// is scattered for good only a third comes up again.
TEST(SeaColour, KeepsEnergy) {
    for (const float wind : {0.0f, 6.0f})
        for (const float scatters : {0.0f, 0.05f, 0.5f, 5.0f}) {
            Stage stage(bestFullVariant().front());
            stage.surround(glm::vec3(1));
            const GpOceanDesc desc = clear(windy(wind), glm::vec3(0), glm::vec3(scatters));
            stage.check(gpSetOcean(stage.scene, &desc));
            addFloor(stage, 2, 1);
            GpRenderOptions options = stage.options(effort(256));
            options.maxBounces = 64;
            const Picture picture = stage.render(width, height, looking(-0.8), options);
            const double all = picture.mean().y;
            EXPECT_LT(all, 1 + 4 * picture.sigma().y + 0.002) << wind << ' ' << scatters;
            EXPECT_GT(all, scatters == 0 ? 0.95 : 0.2) << wind << ' ' << scatters;
        }
}

// A clear body without absorption, across the view from 1 to 3 metres.
void addClearBody(Stage& stage) {
    GpMaterialDesc desc{};
    desc.given = GP_GIVEN_ROUGHNESS;
    desc.ior = 1, desc.transmission = 1, desc.solid = 1;
    Triangles body;
    body.box({-9, -40, -3}, {9, -0.5f, -1});
    stage.add(body, stage.material(desc));
}

struct View {
    float depth;
    bool body;
};

// A black wall in the water fades to the colour of the deep, and to darkness with depth. What is
// not water between them neither scatters nor absorbs.
TEST(SeaColour, BetweenAWallAndACameraBelow) {
    for (const GpFrameMode mode : {GP_MODE_REFERENCE, GP_MODE_REALTIME})
        for (const View& view : {View{2, false}, View{10, false}, View{2, true}}) {
            const float depth = view.depth;
            const bool body = view.body;
            Variant variant = bestFullVariant().front();
            variant.mode = mode;
            Stage stage(variant);
            const GpOceanDesc desc = clear(calm(), absorption, scattering);
            stage.check(gpSetOcean(stage.scene, &desc));
            addSun(stage, 0.5, 5, 0.00465f);
            constexpr double distance = 4;
            Triangles wall;
            wall.quad({-9, -40, -float(distance)}, {18, 0, 0}, {0, 39.5f, 0});
            stage.add(wall, stage.lambert(glm::vec3(0)));
            if (body) addClearBody(stage);
            GpRenderOptions options = stage.options(1);
            if (mode == GP_MODE_REALTIME) options.realtime.antiAliasing = GP_AA_NONE;
            const GpFrame frame = stage.frame(width, height);
            const GpCameraDesc camera = looking(0, -depth);
            stage.check(gpRender(frame, stage.scene, &camera, &options));
            const auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, width * height);
            glm::dvec3 mean(0);
            for (const glm::vec4& c : color) mean += glm::dvec3(c) / double(width * height);
            for (int c = 0; c < 3; ++c) {
                const WaterColumn water =
                    underSun(double(absorption[c]), double(scattering[c]), 0.5, 5);
                const double expected =
                    meanOverPicture(width, height, fov, 0, [&](glm::dvec3 w) {
                        const double s = 1 / -w.z, z = double(depth);  // a metre ahead
                        if (!body) return water.gathered(z, -w.y, distance * s);
                        return water.gathered(z, -w.y, s) +
                               std::exp(-water.loss * s) *
                                   water.gathered(z - 3 * s * w.y, -w.y, (distance - 3) * s);
                    });
                EXPECT_NEAR(mean[c], expected, 0.003 * expected)
                    << int(mode) << ' ' << depth << ' ' << body << ' ' << c;
            }
        }
}

}  // namespace
}  // namespace gp::test
