// GP_VISIBILITY_SKY: who sees sky geometry, from where, and what light comes from it.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class SkyGeometry : public ::testing::TestWithParam<GpFrameMode> {
protected:
    static Variant variant() {
        Variant v;
        v.mode = GetParam();
        return v;
    }
    static GpInstance addSky(Stage& stage, const Triangles& triangles, const GpMaterialDesc& look) {
        const GpMeshDesc mesh = meshDesc(triangles, stage.material(look));
        GpInstanceDesc d{};
        d.mesh = gpNewMesh(stage.device, &mesh);
        d.visibility = GP_VISIBILITY_SKY;
        const GpInstance instance = gpNewInstance(stage.scene, &d);
        EXPECT_NE(instance, nullptr);
        return instance;
    }
    static GpMaterialDesc unlit(glm::vec3 color) {
        GpMaterialDesc d = lambertDesc(color);
        d.unlit = 1;
        return d;
    }
    static GpRenderOptions options() {
        GpRenderOptions o{};
        if (GetParam() == GP_MODE_REALTIME)
            o.realtime.denoiser = GP_DENOISER_NONE, o.realtime.antiAliasing = GP_AA_NONE;
        else
            o.samplesPerPixel = 8;
        return o;
    }
    // The mean of a small picture; of real time, of several frames.
    static glm::dvec3 look(Stage& stage, const GpCameraDesc& camera, const GpRenderOptions& o,
                           uint32_t size = 8) {
        const GpFrame frame = stage.frame(size, size);
        const int frames = GetParam() == GP_MODE_REALTIME ? 8 : 1;
        glm::dvec3 mean(0);
        for (int i = 0; i < frames; ++i) {
            stage.check(gpRender(frame, stage.scene, &camera, &o));
            for (const glm::vec4& c : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, size * size))
                mean += glm::dvec3(c) / double(size * size * uint32_t(frames));
        }
        return mean;
    }
    static GpCameraDesc lookAlong(glm::vec3 from, glm::vec3 direction) {
        return lookFrom(from + direction, -glm::normalize(direction), glm::length(direction), 0.1f);
    }
    static void expectColor(glm::dvec3 seen, glm::vec3 expected, double error = 2e-3) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], double(expected[c]), error);
    }
};

constexpr glm::vec3 sides[6] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                               {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
glm::vec3 colorOf(int side) {
    return {0.1f * float(side + 1), side % 2 ? 0.25f : 0.75f, 0.5f};
}

Triangles wall(glm::vec3 centre, int side, float half) {
    const glm::vec3 n = sides[side];
    const glm::vec3 u = glm::vec3(n.y, n.z, n.x) * half, v = glm::vec3(n.z, n.x, n.y) * half;
    Triangles t;
    t.quad(centre + n * half - u - v, 2.0f * u, 2.0f * v);
    return t;
}

TEST_P(SkyGeometry, IsSeenFromItsViewerInEveryDirection) {
    Stage stage(variant());
    stage.surround({9, 9, 9});
    const glm::vec3 centre(1000, 50, 0);
    for (int side = 0; side < 6; ++side)
        addSky(stage, wall(centre, side, 3), unlit(colorOf(side)));
    GpRenderOptions o = options();
    put(o.skyViewerPosition, centre + glm::vec3(0.5f));
    for (int side = 0; side < 6; ++side)
        expectColor(look(stage, lookAlong({5, -3, 2}, sides[side] * 1.0f), o), colorOf(side));
    o.skyViewerPosition[0] = 0;  // a kilometre beside the box, which is then behind the camera
    expectColor(look(stage, lookAlong({5, -3, 2}, {-1, 0, 0}), o), glm::vec3(9));
}

TEST_P(SkyGeometry, MovesWithTheCameraAsTheScaleSays) {
    Stage stage(variant());
    Triangles left, right;
    left.quad({1, -9, -9}, {0, 18, 0}, {0, 0, 9});
    right.quad({1, -9, 0}, {0, 18, 0}, {0, 0, 9});
    addSky(stage, left, unlit({1, 0, 0}));
    addSky(stage, right, unlit({0, 1, 0}));
    GpRenderOptions o = options();
    o.skyScale = 1.0f / 16, o.skyViewerPosition[2] = -0.25f;
    expectColor(look(stage, lookAlong({0, 0, 8}, {1, 0, 0}), o), {0, 1, 0});   // at 0.25
    expectColor(look(stage, lookAlong({0, 0, 1}, {1, 0, 0}), o), {1, 0, 0});   // at -0.19
    o.skyScale = 0;
    expectColor(look(stage, lookAlong({0, 0, 8}, {1, 0, 0}), o), {1, 0, 0});
}

// It stands in the middle of the scene, and is not there: no ray of the scene meets it.
TEST_P(SkyGeometry, IsNoPartOfTheScene) {
    Stage stage(variant());
    for (int side = 0; side < 6; ++side) {
        GpMaterialDesc glowing = lambertDesc(glm::vec3(0));
        put(glowing.emission, glm::vec3(0.01f));
        glowing.doubleSided = 1;
        addSky(stage, wall({0, 0, 0}, side, 1), glowing);
    }
    Triangles floor;
    floor.quad({-5, -2, 5}, {10, 0, 0}, {0, 0, -10});
    stage.add(floor, stage.lambert(glm::vec3(0.5f)));
    GpLightDesc sun{};
    sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = 3.14159265f;
    stage.light(sun);
    const GpRenderOptions o = options();
    expectColor(look(stage, lookAlong({0, 0, 0}, {0, -1, 0}), o), glm::vec3(0.505f), 0.01);
    GpSceneInfo info{};
    stage.check(gpGetSceneInfo(stage.scene, &info));
    EXPECT_EQ(info.boundsMax[1], -2);
    EXPECT_EQ(info.boundsMin[0], -5);
    const GpFrame frame = stage.frame(4, 4);
    const GpCameraDesc up = lookAlong({0, 0, 0}, {0, 1, 0});
    stage.check(gpRender(frame, stage.scene, &up, &o));
    EXPECT_EQ(stage.read<uint32_t>(frame, GP_IMAGE_INSTANCE, 16)[5], 0u);
    EXPECT_NEAR(stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, 16)[5].x, 0.01, 1e-4);
}

TEST_P(SkyGeometry, MirrorsShowIt) {
    for (const bool turned : {false, true}) {
        Stage stage(variant());
        for (int side = 0; side < 6; ++side)
            addSky(stage, wall({0, 0, 0}, side, 3), unlit(colorOf(side)));
        GpMaterialDesc silver{};
        silver.metallic = 1, silver.given = GP_GIVEN_ROUGHNESS;
        Triangles mirror;
        mirror.quad({-5, -5, turned ? -15.0f : -10.0f}, {10, 0, turned ? 10.0f : 0.0f},
                    {0, 10, 0});  // turned: its normal is (-1, 0, 1)
        stage.add(mirror, stage.material(silver));
        GpRenderOptions o = options();
        expectColor(look(stage, lookAlong({0, 0, 0}, {0, 0, -1}), o), colorOf(turned ? 1 : 4),
                    0.01);
    }
}

TEST_P(SkyGeometry, LightsWhatIsUnderIt) {
    Stage stage(variant());
    for (int side = 0; side < 6; ++side)
        addSky(stage, wall({0, 0, 0}, side, 3), unlit(glm::vec3(0.7f, 0.35f, 0.14f)));
    Triangles floor;
    floor.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    stage.add(floor, stage.lambert(glm::vec3(0.5f)));
    GpRenderOptions o = options();
    for (const int bounces : {GP_NO_BOUNCES, 1, 3}) {
        o.maxBounces = bounces;
        const glm::dvec3 seen = look(stage, lookAlong({0, 2, 0}, {0, -1, 0}), o, 32);
        expectColor(seen, {0.35f, 0.175f, 0.07f}, 0.005);
    }
}

// Half of the sky is a red environment, half of it blue geometry; a wall bounces light on.
TEST_P(SkyGeometry, SharesTheSkyWithTheEnvironment) {
    Stage stage(variant());
    stage.surround({1, 0, 0});
    Triangles roof, floor;
    roof.quad({0, 1e-3f, -1}, {1, 0, 0}, {0, 0, 2});
    addSky(stage, roof, unlit({0, 0, 1}));
    floor.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    stage.add(floor, stage.lambert(glm::vec3(0.5f)));
    const GpRenderOptions o = options();
    const glm::dvec3 seen = look(stage, lookAlong({0, 2, 0}, {0, -1, 0}), o, 48);
    EXPECT_NEAR(seen.x, 0.25, 0.01);
    EXPECT_NEAR(seen.z, 0.25, 0.01);
}

TEST_P(SkyGeometry, ComesAndGoes) {
    Stage stage(variant());
    stage.surround({1, 0, 0});
    const GpInstance instance = addSky(stage, wall({0, 0, 0}, 2, 3), unlit({0, 0, 1}));
    const GpRenderOptions o = options();
    const GpCameraDesc up = lookAlong({0, -1, 0}, {0, 1, 0});
    expectColor(look(stage, up, o), {0, 0, 1});
    stage.check(gpSetInstanceVisibility(instance, GP_VISIBILITY_WORLD, GP_VISIBLE_CAMERA));
    expectColor(look(stage, up, o), {1, 0, 0});
    stage.check(gpSetInstanceVisibility(instance, GP_VISIBILITY_SKY, 0));
    expectColor(look(stage, up, o), {0, 0, 1});
    stage.check(gpRemoveInstance(instance));
    expectColor(look(stage, up, o), {1, 0, 0});
}

INSTANTIATE_TEST_SUITE_P(, SkyGeometry, ::testing::Values(GP_MODE_REFERENCE, GP_MODE_REALTIME),
                         [](const auto& p) {
                             return p.param == GP_MODE_REALTIME ? "realtime" : "reference";
                         });

TEST(SkyGeometryOthers, LocalLightingShowsItAndTakesItsMeanAsAmbientLight) {
    Variant v;
    v.mode = GP_MODE_LOCAL;
    Stage stage(v);
    for (int side = 0; side < 6; ++side) {
        GpMaterialDesc d = lambertDesc(glm::vec3(0.6f));
        d.unlit = 1;
        const Triangles t = wall({0, 0, 0}, side, 3);
        const GpMeshDesc mesh = meshDesc(t, stage.material(d));
        GpInstanceDesc i{};
        i.mesh = gpNewMesh(stage.device, &mesh), i.visibility = GP_VISIBILITY_SKY;
        ASSERT_NE(gpNewInstance(stage.scene, &i), nullptr);
    }
    Triangles floor;
    floor.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    stage.add(floor, stage.lambert(glm::vec3(0.5f)));
    GpRenderOptions o{};
    o.samplesPerPixel = 1;
    const Picture down = stage.render(4, 4, lookFrom({0, 0, 0}, {0, 1, 0}, 2, 0.5f), o);
    EXPECT_NEAR(down.mean().x, 0.3, 2e-3);
    const Picture up = stage.render(4, 4, lookFrom({0, 9, 0}, {0, -1, 0}, 2, 0.5f), o);
    EXPECT_NEAR(up.mean().x, 0.6, 2e-3);
}

TEST(SkyGeometryOthers, AnotherSkyIsNothingToAccumulate) {
    Stage stage(Variant{});
    stage.surround(glm::vec3(1));
    const GpFrame frame = stage.frame(4, 4);
    GpRenderOptions o{};
    o.samplesPerPixel = 1;
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 1, 1);
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    o.accumulate = 1;
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    o.skyViewerPosition[1] = 1;
    EXPECT_EQ(gpRender(frame, stage.scene, &camera, &o), GP_ERROR_INVALID_OPERATION);
    gpGetError(stage.device, nullptr);
}

}  // namespace
}  // namespace gp::test
