// Seeing into water and out of it: a floor that the sun lights through calm water, against its
// closed form; through waves, against a lamp far away that no guide knows; views from below.
#include <cmath>

#include <gtest/gtest.h>

#include "render/calm_sea.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 24, height = 16;
constexpr float fov = 0.25f;

TEST(ClearSea, TheSunOnTheFloorOfCalmWater) {
    const glm::vec3 absorption(0.3f, 0.1f, 0);
    for (const CalmFloor& floor : {CalmFloor{2, 0.8, 0.5, 5}, CalmFloor{0.5, 0.3, 1.2, 5}}) {
        Stage stage(bestFullVariant().front());
        const GpOceanDesc desc = clear(calm(), absorption, glm::vec3(0));
        stage.check(gpSetOcean(stage.scene, &desc));
        addFloor(stage, float(floor.depth), float(floor.albedo));
        addSun(stage, floor.zenith, float(floor.irradiance), 0.00465f);
        const double pitch = -1.2;
        const Picture picture =
            stage.render(width, height, looking(pitch), stage.options(effort(192)));
        glm::dvec3 expected;
        for (int c = 0; c < 3; ++c)
            expected[c] = meanOverPicture(width, height, fov, pitch, [&](glm::dvec3 w) {
                return floor.radiance(-w.y, double(absorption[c]));
            });
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(picture.mean()[c], expected[c], 4 * picture.sigma()[c])
                << floor.depth << ' ' << c;
            EXPECT_LT(picture.sigma()[c], 0.015 * expected[c]) << floor.depth << ' ' << c;
        }
    }
}

Picture floorUnderWaves(float wind, bool guided, uint32_t samples) {
    constexpr double zenith = 0.6, radius = 0.01, distance = 1e5;
    constexpr float irradiance = 5;
    Stage stage(bestFullVariant().front());
    const GpOceanDesc desc = clear(windy(wind), {0.3f, 0.1f, 0.02f}, glm::vec3(0));
    stage.check(gpSetOcean(stage.scene, &desc));
    stage.check(gpSetOceanTime(stage.scene, 12));
    addFloor(stage, 3, 0.5f);
    if (guided) {
        addSun(stage, zenith, irradiance, float(radius));
    } else {
        // The same light as a lamp: by a sphere's cosine, E = intensity / distance^2.
        GpLightDesc lamp{};
        lamp.kind = GP_LIGHT_SPHERE, lamp.radius = float(std::sin(radius) * distance);
        lamp.intensity = float(irradiance * distance * distance);
        put(lamp.position, {float(-std::sin(zenith) * distance),
                            float(std::cos(zenith) * distance), 0});
        stage.light(lamp);
    }
    GpRenderOptions options = stage.options(samples);
    options.seed = guided ? 1 : 2;
    return stage.render(width, height, looking(-1.0, 6), options);
}

// The guide only chooses directions: without it there is more noise, and nothing else.
TEST(ClearSea, TheSunThroughWavesIsThatOfAnUnguidedLamp) {
    for (const float wind : {3.0f, 9.0f}) {
        const uint32_t samples = effort(256);
        const Picture sun = floorUnderWaves(wind, true, samples);
        const Picture lamp = floorUnderWaves(wind, false, 4 * samples);
        constexpr uint32_t block = 8;
        double sumOfSquares = 0;
        for (uint32_t by = 0; by < height / block; ++by)
            for (uint32_t bx = 0; bx < width / block; ++bx)
                for (int c = 0; c < 3; ++c) {
                    double difference = 0, variance = 0;
                    for (uint32_t i = 0; i < block * block; ++i) {
                        const size_t p = (by * block + i / block) * width + bx * block + i % block;
                        difference += double(sun.color[p][c] - lamp.color[p][c]);
                        variance += double(sun.variance[p][c] + lamp.variance[p][c]);
                    }
                    const double z = difference / std::sqrt(variance);
                    EXPECT_LT(std::abs(z), 4.5) << wind << ", block " << bx << ' ' << by;
                    sumOfSquares += z * z;
                }
        // 6 blocks whose channels go together: 1, with a deviation of 0.58.
        EXPECT_LT(sumOfSquares / 18, 1 + 3 * 0.58) << wind;
        const glm::dvec3 sigma = glm::sqrt(sun.sigma() * sun.sigma() + lamp.sigma() * lamp.sigma());
        EXPECT_NEAR(sun.mean().y, lamp.mean().y, 4 * sigma.y) << wind;
        const double gain = 4 * std::pow(lamp.sigma().y / sun.sigma().y, 2);
        EXPECT_GT(gain, 30) << wind;  // found: 140 and 70
    }
}

// ------------------------------------------------------------------------------- from below

// Total reflection begins where the sine is one over the index; inside of that circle all of the
// sky is seen, brighter by the index' square. Before both is what the water scatters, and what it
// sends up from the deep is mirrored.
TEST(ClearSea, SnellsWindow) {
    constexpr uint32_t size = 96;
    constexpr float wide = 2.1f;
    // Some loss in each, or the sky below would be seen through the water.
    const glm::vec3 absorption(0.01f, 0.1f, 0.3f), scattering(0, 0.05f, 0);
    for (const int transparent : {1, 0}) {
        Stage stage(bestFullVariant().front());
        stage.surround(glm::vec3(1));
        GpOceanDesc desc = clear(calm(), absorption, scattering);
        desc.transparent = transparent;
        stage.check(gpSetOcean(stage.scene, &desc));
        constexpr double up = pi / 2, depth = 2;
        const GpCameraDesc camera = looking(up, -float(depth), wide);
        GpRenderOptions options = stage.options(effort(64));
        options.pixelFilter = GP_PIXEL_BOX;
        const Picture picture = stage.render(size, size, camera, options);
        uint32_t bright = 0;
        for (const glm::vec4& c : picture.color) bright += c.x > 0.1 * eta * eta;
        const double pixel = 2 * std::tan(double(wide) / 2) / size;
        const double radius = std::atan(std::sqrt(bright / pi) * pixel);
        EXPECT_NEAR(radius, std::asin(1 / eta), 0.01) << transparent;
        glm::dvec3 expected;
        for (int c = 0; c < 3; ++c) {
            const double loss = double(absorption[c] + scattering[c]);
            const WaterColumn water = underWhiteSky(double(absorption[c]), double(scattering[c]));
            expected[c] = meanOverPicture(size, size, double(wide), up, [&](glm::dvec3 w) {
                // From outside the sky is bright to the very horizon: 1 - F there is all below.
                const double f = fresnelFromBelow(w.y), s = depth / w.y;
                return water.gathered(depth, -w.y, s) +
                       ((1 - f) * eta * eta + f * water.radiance) * std::exp(-loss * s);
            });
            // Facets of 4 milliradians, the cone of a pixel, soften the circle's edge.
            EXPECT_NEAR(picture.mean()[c], expected[c],
                        0.005 * expected[c] + 4 * picture.sigma()[c]) << transparent << ' ' << c;
        }
    }
}

TEST(ClearSea, WaterBeforeTheCameraAbsorbs) {
    const glm::vec3 absorption(0.3f, 0.1f, 0), scattering(0.05f, 0, 0);
    for (const GpFrameMode mode : {GP_MODE_REFERENCE, GP_MODE_REALTIME}) {
        Variant variant = bestFullVariant().front();
        variant.mode = mode;
        Stage stage(variant);
        const GpOceanDesc desc = clear(windy(5), absorption, scattering);
        stage.check(gpSetOcean(stage.scene, &desc));
        constexpr double distance = 4;
        Triangles wall;
        wall.quad({-9, -30, -float(distance)}, {18, 0, 0}, {0, 20, 0});
        stage.add(wall, stage.lambert(glm::vec3(0), glm::vec3(2)));
        GpRenderOptions options = stage.options(1);
        if (mode == GP_MODE_REALTIME) options.realtime.antiAliasing = GP_AA_NONE;
        const GpFrame frame = stage.frame(width, height);
        const GpCameraDesc camera = looking(0, -20);
        stage.check(gpRender(frame, stage.scene, &camera, &options));
        const auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, width * height);
        glm::dvec3 mean(0);
        for (const glm::vec4& c : color) mean += glm::dvec3(c) / double(width * height);
        for (int c = 0; c < 3; ++c) {
            const double expected = meanOverPicture(
                width, height, fov, 0, [&](glm::dvec3 w) {
                    return 2 * std::exp(-double(absorption[c] + scattering[c]) * distance / -w.z);
                });
            EXPECT_NEAR(mean[c], expected, 0.002 * expected) << int(mode) << ' ' << c;
        }
    }
}

}  // namespace
}  // namespace gp::test
