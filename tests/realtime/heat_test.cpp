// Heat maps: rays counted, time measured, variance as the denoiser sees it; and nothing of it where
// nobody asked.
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 45, height = 27;  // no multiple of a tile

struct Heated {
    Stage stage;
    GpFrame frame;
    GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 4, 2.5f);
    GpRealtimeOptions realtime{};

    explicit Heated(uint32_t threads = 0) : stage(variant(), threads) {
        Triangles ball;
        ball.sphere({0, 0, 0}, 1, 12, false, true);
        stage.add(ball, stage.lambert({0.8f, 0.4f, 0.2f}));
        stage.surround(glm::vec3(1));
        GpLightDesc lamp{};
        lamp.kind = GP_LIGHT_SPHERE;
        lamp.intensity = 5;
        lamp.position[1] = 3, lamp.radius = 0.1f;
        stage.light(lamp);
        frame = stage.frame(width, height);
        realtime.heatMaps = 1;
    }
    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    void render(int frames = 1) {
        GpRenderOptions o{};
        o.realtime = realtime;
        for (int i = 0; i < frames; ++i) stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    std::vector<glm::vec4> layer(const char* name) const {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }
    GpFrameStatistics statistics() const {
        GpFrameStatistics s{};
        stage.check(gpGetFrameStatistics(frame, &s));
        return s;
    }
    double sum(const char* name) const {
        double all = 0;
        for (const glm::vec4& p : layer(name)) all += double(p.x);
        return all;
    }
};

constexpr size_t middle = height / 2 * width + width / 2, corner = 0;

TEST(HeatMaps, RaysAddUpToTheCounters) {
    Heated s;
    for (const GpLightReuse reuse : {GP_REUSE_NONE, GP_REUSE_UNBIASED}) {
        s.realtime.lightReuse = s.realtime.indirectReuse = reuse;
        for (int i = 0; i < 3; ++i) {
            s.render();
            const GpFrameStatistics n = s.statistics();
            EXPECT_EQ(s.sum("heat_rays"), double(n.cameraRays + n.bounceRays + n.shadowRays));
        }
    }
    const auto rays = s.layer("heat_rays");
    EXPECT_EQ(rays[corner].x, 1);  // the sky: the camera's ray alone
    EXPECT_GE(rays[middle].x, 3);  // a shadow ray and the ray by the material, too
    EXPECT_EQ(rays[middle].x, rays[middle].z);
}

TEST(HeatMaps, MirrorsCostRays) {
    const auto raysOf = [](int32_t mirrors) {
        Heated s;
        GpMaterialDesc mirror{};
        mirror.given = GP_GIVEN_ROUGHNESS;
        mirror.metallic = 1;
        Triangles wall;
        wall.quad({-3, -3, -2}, {6, 0, 0}, {0, 6, 0});
        s.stage.add(wall, s.stage.material(mirror));
        s.realtime.mirrorLimit = mirrors;
        s.render();
        const GpFrameStatistics n = s.statistics();
        EXPECT_EQ(s.sum("heat_rays"), double(n.cameraRays + n.bounceRays + n.shadowRays));
        return s.layer("heat_rays")[corner].x;
    };
    EXPECT_EQ(raysOf(4), 2);  // the camera's, and its reflection into the sky
}

TEST(HeatMaps, TimeIsThatOfThePasses) {
    Heated s(1);
    s.render(2);
    const auto time = s.layer("heat_time");
    for (const glm::vec4& p : time) {
        ASSERT_TRUE(std::isfinite(p.x));
        ASSERT_GT(p.x, 0);
    }
    GpPassTime times[64];
    uint32_t count = 0;
    s.stage.check(gpGetPassTimes(s.frame, times, 64, &count));
    double passes = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const std::string name = times[i].name;
        if (name == "primary" || name == "lighting")
            passes += 1e3 * times[i].milliseconds;
    }
    // One thread: pixels share its time, but for what lies between them.
    EXPECT_LE(s.sum("heat_time"), passes);
    EXPECT_GE(s.sum("heat_time"), 0.3 * passes);
}

TEST(HeatMaps, VarianceIsHighWhereLightIsNoisy) {
    Heated s;
    s.render(8);
    const auto variance = s.layer("heat_variance");
    for (const glm::vec4& p : variance)
        for (int c = 0; c < 4; ++c) {
            ASSERT_TRUE(std::isfinite(p[c]));
            ASSERT_GE(p[c], 0);
        }
    EXPECT_EQ(variance[corner], glm::vec4(0));
    EXPECT_GT(variance[middle].x, 0);
    EXPECT_GT(variance[middle].y, 0);
    s.realtime.denoiser = GP_DENOISER_NONE;
    s.render();
    std::vector<glm::vec4> pixels(width * height);
    EXPECT_EQ(gpReadFrameLayer(s.frame, "heat_variance", &pixels[0].x, pixels.size() * 16),
              GP_ERROR_INVALID_OPERATION);
    gpGetError(s.stage.device, nullptr);
}

TEST(HeatMaps, ChangeNothingElseAndCostMemoryOnlyWhenWanted) {
    Heated with, without;
    without.realtime.heatMaps = 0;
    const size_t count = width * height;
    with.render(2);
    without.render(2);
    EXPECT_EQ(with.stage.read<glm::vec4>(with.frame, GP_IMAGE_COLOR, count),
              without.stage.read<glm::vec4>(without.frame, GP_IMAGE_COLOR, count));
    EXPECT_EQ(with.statistics().frameBytes, without.statistics().frameBytes + 8 * count);
    with.realtime.heatMaps = 0;
    with.render();
    EXPECT_EQ(with.statistics().frameBytes, without.statistics().frameBytes);
    std::vector<glm::vec4> pixels(count);
    EXPECT_EQ(gpReadFrameLayer(with.frame, "heat_time", &pixels[0].x, count * 16),
              GP_ERROR_INVALID_OPERATION);
    gpGetError(with.stage.device, nullptr);
}

TEST(HeatMaps, FollowTheSizeOfRays) {
    Heated s;
    s.realtime.renderScale = 0.5f;
    s.render(2);
    const GpFrameStatistics n = s.statistics();
    // Each of them is seen by about four pixels of the picture.
    EXPECT_NEAR(s.sum("heat_rays") / double(n.cameraRays + n.bounceRays + n.shadowRays), 4, 0.5);
}

}  // namespace
}  // namespace gp::test
