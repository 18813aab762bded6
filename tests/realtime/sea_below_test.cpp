// Real-time frames of what lies under water: shadow rays that are bent at the surface.
#include <cmath>

#include <gtest/gtest.h>

#include "render/calm_sea.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 24, height = 16;

Variant realtime() {
    Variant v = bestFullVariant().front();
    v.mode = GP_MODE_REALTIME;
    return v;
}

// The mean of independent frames, and the deviation of that.
struct Frames {
    glm::dvec3 mean{0}, sigma{0};
};

Frames frames(Stage& stage, const GpCameraDesc& camera, uint32_t count,
              GpLightReuse indirectReuse) {
    const GpFrame frame = stage.frame(width, height);
    glm::dvec3 sum(0), squares(0);
    for (uint32_t i = 0; i < count; ++i) {
        GpRenderOptions options = stage.options(0);
        options.seed = i, options.maxBounces = 8;
        options.realtime.antiAliasing = GP_AA_JITTER;
        options.realtime.denoiser = GP_DENOISER_NONE;
        options.realtime.indirectReuse = indirectReuse;
        options.realtime.resetHistory = 1;
        stage.check(gpRender(frame, stage.scene, &camera, &options));
        glm::dvec3 mean(0);
        for (const glm::vec4& c : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, width * height))
            mean += glm::dvec3(c) / double(width * height);
        sum += mean, squares += mean * mean;
    }
    Frames f;
    f.mean = sum / double(count);
    f.sigma = glm::sqrt((squares / double(count) - f.mean * f.mean) / double(count - 1));
    return f;
}

// Through a pane of calm water, where a pixel is narrow, and through one that the pixel's cone
// makes rough. Handing on ways of light must not bend what others have found.
TEST(SeaBelow, TheSunOnTheFloorOfCalmWater) {
    struct Case {
        float fov;
        GpLightReuse reuse;
    };
    for (const Case c : {Case{0.25f, GP_REUSE_NONE}, {0.02f, GP_REUSE_NONE},
                         {0.02f, GP_REUSE_UNBIASED}}) {
        const CalmFloor floor{2, 0.6, 0.5, 5};
        const glm::vec3 absorption(0.3f, 0.1f, 0.02f);
        Stage stage(realtime());
        const GpOceanDesc desc = clear(calm(), absorption, glm::vec3(0));
        stage.check(gpSetOcean(stage.scene, &desc));
        addFloor(stage, float(floor.depth), float(floor.albedo));
        addSun(stage, floor.zenith, float(floor.irradiance), 0.00465f);
        const double pitch = -1.2;
        const Frames found = frames(stage, looking(pitch, 3, c.fov), effort(32), c.reuse);
        for (int i = 0; i < 3; ++i) {
            const double expected =
                meanOverPicture(width, height, double(c.fov), pitch, [&](glm::dvec3 w) {
                    return floor.radiance(-w.y, double(absorption[i]));
                });
            // A pane's share is kept in 8 bits.
            EXPECT_NEAR(found.mean[i], expected, 4 * found.sigma[i] + 0.004 * expected)
                << c.fov << ' ' << int(c.reuse) << ' ' << i << ", sigma " << found.sigma[i];
            EXPECT_LT(4 * found.sigma[i], 0.05 * expected);
        }
    }
}

// The same from under water, where the floor is what the camera sees first.
TEST(SeaBelow, TheSunOnTheFloorSeenFromBelow) {
    const CalmFloor floor{5, 0.6, 0.5, 5};
    const double loss = 0.1;
    Stage stage(realtime());
    const GpOceanDesc desc = clear(calm(), glm::vec3(float(loss)), glm::vec3(0));
    stage.check(gpSetOcean(stage.scene, &desc));
    addFloor(stage, float(floor.depth), float(floor.albedo));
    addSun(stage, floor.zenith, float(floor.irradiance), 0.00465f);
    const Frames found = frames(stage, looking(-1.2, -2), effort(32), GP_REUSE_UNBIASED);
    const double arrives = floor.arrives(loss);
    const double expected = meanOverPicture(width, height, 0.25, -1.2, [&](glm::dvec3 w) {
        return floor.albedo / pi * arrives * std::exp(-loss * 3 / -w.y);
    });
    EXPECT_NEAR(found.mean.y, expected, 4 * found.sigma.y + 0.004 * expected);
    EXPECT_LT(4 * found.sigma.y, 0.05 * expected);
}

// What the water scatters over a black floor: as a pane, where the ray of the pixel gathers it, and
// as a rough surface, where the ray that it sends down does.
TEST(SeaBelow, TheColourOfTheWater) {
    const glm::vec3 absorption(0.3f, 0.1f, 0.03f), scattering(0.1f, 0.15f, 0.2f);
    const double depth = 2, zenith = 0.5, pitch = -1.2;
    for (const float fov : {0.25f, 0.02f}) {
        Stage stage(realtime());
        const GpOceanDesc desc = clear(calm(), absorption, scattering);
        stage.check(gpSetOcean(stage.scene, &desc));
        addFloor(stage, float(depth), 0);
        addSun(stage, zenith, 5, 0.00465f);
        const Frames found = frames(stage, looking(pitch, 3, fov), effort(32), GP_REUSE_NONE);
        for (int i = 0; i < 3; ++i) {
            const WaterColumn water =
                underSun(double(absorption[i]), double(scattering[i]), zenith, 5);
            const double expected =
                meanOverPicture(width, height, double(fov), pitch, [&](glm::dvec3 w) {
                    const double below = refractedCosine(-w.y);
                    return (1 - fresnel(-w.y)) / (eta * eta) *
                           water.gathered(0, below, depth / below);
                });
            EXPECT_NEAR(found.mean[i], expected, 4 * found.sigma[i] + 0.004 * expected)
                << fov << ' ' << i;
            EXPECT_LT(4 * found.sigma[i], 0.05 * expected) << fov << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace gp::test
