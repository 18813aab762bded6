// GpRenderOptions::rayLength: where the rays of camera, mirrors, bounces and shadows end, in the
// reference and in real time.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr uint32_t size = 40;

class RayLength : public ::testing::TestWithParam<GpFrameMode> {
protected:
    static Variant variant() {
        Variant v;
        v.mode = GetParam();
        return v;
    }
    struct Shown {
        glm::dvec3 mean{0};
        float depth = 0;  // of the middle pixel
    };
    static Shown render(Stage& stage, const GpCameraDesc& camera, float rayLength) {
        GpRenderOptions o{};
        if (GetParam() == GP_MODE_REALTIME) {
            o.realtime.denoiser = GP_DENOISER_NONE;
            o.realtime.antiAliasing = GP_AA_NONE;
        } else {
            o.samplesPerPixel = 4, o.maxBounces = 1;
        }
        o.rayLength = rayLength;
        const GpFrame frame = stage.frame(size, size);
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        Shown shown;
        for (const glm::vec4& c : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, size * size))
            shown.mean += glm::dvec3(c) / double(size * size);
        shown.depth =
            stage.read<float>(frame, GP_IMAGE_DEPTH, size * size)[size * size / 2 + size / 2];
        return shown;
    }
};

TEST_P(RayLength, WhatIsFartherAwayIsSky) {
    Stage stage(variant());
    stage.surround({0.25f, 0.5f, 1});
    Triangles wall;
    wall.quad({-50, -50, -10}, {100, 0, 0}, {0, 100, 0});
    GpMaterialDesc red = lambertDesc({1, 0, 0});
    red.unlit = 1;
    stage.add(wall, stage.material(red));
    const GpCameraDesc camera = lookFrom({0, 0, -1}, {0, 0, 1}, 1, 0.2f);
    EXPECT_NEAR(render(stage, camera, 0).mean.x, 1, 1e-3);
    const Shown near = render(stage, camera, 20), cut = render(stage, camera, 5);
    EXPECT_NEAR(near.mean.x, 1, 1e-3);
    EXPECT_NEAR(near.depth, 10, 0.1);
    EXPECT_NEAR(cut.mean.x, 0.25, 1e-3);
    EXPECT_NEAR(cut.mean.z, 1, 1e-3);
    EXPECT_EQ(cut.depth, inf);
}

// A floor under a roof 8 m above it that hides nearly all of the sky.
TEST_P(RayLength, WhatIsFartherAwayHidesNothing) {
    Stage stage(variant());
    stage.surround(glm::vec3(1));
    Triangles floor, roof;
    floor.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    roof.quad({-200, 8, -200}, {400, 0, 0}, {0, 0, 400});
    stage.add(floor, stage.lambert(glm::vec3(0.5f)));
    stage.add(roof, stage.lambert(glm::vec3(0)));
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 2, 0.5f);
    EXPECT_LT(render(stage, camera, 0).mean.x, 0.05);
    EXPECT_NEAR(render(stage, camera, 7).mean.x, 0.5, 0.03);
    // 9 m reach straight up to it, but not aslant: beyond acos(8 / 9) the sky is open.
    EXPECT_NEAR(render(stage, camera, 9).mean.x, 0.5 * 64 / 81, 0.03);
}

// Light of a sun comes from infinitely far; lamps that are farther away than rays are long give
// none, however it would be found.
TEST_P(RayLength, LampsBeyondItGiveNoLight) {
    for (int kind : {0, 1, 2}) {
        Stage stage(variant());
        Triangles floor;
        floor.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
        stage.add(floor, stage.lambert(glm::vec3(0.5f)));
        GpLightDesc lamp{};
        if (kind == 2) {
            lamp.kind = GP_LIGHT_DIRECTIONAL, lamp.intensity = 2, lamp.angularRadius = 0.1f;
        } else {
            lamp.kind = GP_LIGHT_SPHERE, lamp.intensity = 200, lamp.position[1] = 8;
            lamp.radius = kind == 0 ? 0.0f : 1.0f;
        }
        stage.light(lamp);
        const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 2, 0.5f);
        const double all = render(stage, camera, 0).mean.x;
        EXPECT_GT(all, 0.2) << kind;
        EXPECT_NEAR(render(stage, camera, 10).mean.x, all, 0.02 * all) << kind;
        EXPECT_NEAR(render(stage, camera, 5).mean.x, kind == 2 ? all : 0, 0.02 * all) << kind;
    }
}

// The way to a mirror and the way behind it are two rays.
TEST_P(RayLength, EachRayOfAReflectionEndsByItself) {
    Stage stage(variant());
    stage.surround({0.25f, 0.5f, 1});
    GpMaterialDesc glass{};
    glass.metallic = 1, glass.given = GP_GIVEN_ROUGHNESS;
    GpMaterialDesc red = lambertDesc({1, 0, 0});
    red.unlit = 1;
    Triangles mirror, wall;
    mirror.quad({-5, -5, -4}, {10, 0, 0}, {0, 10, 0});
    wall.quad({50, -50, 2}, {-100, 0, 0}, {0, 100, 0});
    stage.add(mirror, stage.material(glass));
    stage.add(wall, stage.material(red), GP_VISIBLE_CAMERA);
    const GpCameraDesc camera = lookFrom({0, 0, -1}, {0, 0, 1}, 1, 0.2f);
    EXPECT_NEAR(render(stage, camera, 7).mean.x, 1, 1e-2);
    EXPECT_NEAR(render(stage, camera, 5).mean.x, 0.25, 1e-2);
    EXPECT_NEAR(render(stage, camera, 3).mean.z, 1, 1e-2);  // the mirror itself is too far
}

INSTANTIATE_TEST_SUITE_P(, RayLength,
                         ::testing::Values(GP_MODE_REFERENCE, GP_MODE_REALTIME),
                         [](const auto& p) {
                             return p.param == GP_MODE_REALTIME ? "realtime" : "reference";
                         });

}  // namespace
}  // namespace gp::test
