// What a real-time frame keeps and tells: layers, pass times, the size of rays, cut and cancel.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 31, height = 17;

struct Shown {
    Stage stage;
    GpFrame frame;
    GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 4, 2.5f);

    explicit Shown(GpBackend backend = GP_BACKEND_CPU) : stage(variant(backend)) {
        Triangles ball;
        ball.sphere({0, 0, 0}, 1, 12, false, true);
        stage.add(ball, stage.lambert({0.8f, 0.4f, 0.2f}));
        stage.surround(glm::vec3(1));
        frame = stage.frame(width, height);
    }
    static Variant variant(GpBackend backend) {
        Variant v;
        v.backend = backend, v.mode = GP_MODE_REALTIME;
        return v;
    }
    void render(const GpRealtimeOptions& realtime = {}, uint64_t seed = 0) {
        GpRenderOptions o{};
        o.realtime = realtime, o.seed = seed;
        stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    std::vector<glm::vec4> layer(const char* name) {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }
};

TEST(RealtimeFrame, EveryLayerCanBeReadAndIsFinite) {
    Shown s, fitting;
    GpRealtimeOptions reuse{}, bmfr{};
    reuse.lightReuse = reuse.indirectReuse = GP_REUSE_BIASED;
    reuse.heatMaps = 1;
    bmfr.denoiser = GP_DENOISER_BMFR;
    for (int i = 0; i < 2; ++i) s.render(reuse), fitting.render(bmfr);
    uint32_t count = 0;
    const char *name, *meaning;
    while (gpGetFrameLayerInfo(count, &name, &meaning) == GP_SUCCESS) {
        EXPECT_GT(std::string(meaning).size(), 5u) << name;
        const bool isFitted = std::string(name).starts_with("fitted_");
        if (std::string(name) == "sun") {  // sun_reflection_test.cpp has such a scene
            ++count;
            continue;
        }
        for (const glm::vec4& p : (isFitted ? fitting : s).layer(name))
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(p[c])) << name;
        ++count;
    }
    EXPECT_GT(count, 20u);
}

TEST(RealtimeFrame, LayersThatTheOptionsDoNotMakeAreAnError) {
    Shown s;
    GpRealtimeOptions plain{};
    plain.denoiser = GP_DENOISER_NONE;
    s.render(plain);
    std::vector<glm::vec4> pixels(width * height);
    for (const char* name :
         {"reservoir", "indirect_reservoir_hit", "indirect", "fitted_diffuse", "sun"}) {
        EXPECT_EQ(gpReadFrameLayer(s.frame, name, &pixels[0].x, pixels.size() * 16),
                  GP_ERROR_INVALID_OPERATION);
        const char* message = "";
        gpGetError(s.stage.device, &message);
        EXPECT_NE(std::string(message).find(name), std::string::npos) << message;
    }
    s.layer("indirect_raw");
}

TEST(RealtimeFrame, LayersAndImagesShowTheBall) {
    Shown s;
    GpRealtimeOptions o{};
    o.antiAliasing = GP_AA_NONE;
    s.render(o);
    const size_t middle = height / 2 * width + width / 2;
    EXPECT_NEAR(s.layer("normal")[middle].z, 1, 0.02);
    EXPECT_NEAR(s.layer("albedo")[middle].x, 0.8, 1.0 / 255);
    EXPECT_NEAR(s.layer("depth")[middle].x, 3, 0.05);
    EXPECT_EQ(s.layer("hit")[middle].x, 0);
    const auto depth = s.stage.read<float>(s.frame, GP_IMAGE_DEPTH, width * height);
    EXPECT_NEAR(depth[middle], 3, 0.05);
    EXPECT_TRUE(std::isinf(depth[0]));
    EXPECT_EQ(s.stage.read<uint32_t>(s.frame, GP_IMAGE_INSTANCE, width * height)[middle], 1u);
    const auto color = s.stage.read<glm::vec4>(s.frame, GP_IMAGE_COLOR, width * height);
    EXPECT_EQ(color[0], glm::vec4(1, 1, 1, 0));  // the surrounding, which covers nothing
    EXPECT_EQ(color[middle].w, 1);
    const auto emission = s.stage.read<glm::vec4>(s.frame, GP_IMAGE_EMISSION, width * height);
    const auto direct = s.stage.read<glm::vec4>(s.frame, GP_IMAGE_DIRECT, width * height);
    const auto indirect = s.stage.read<glm::vec4>(s.frame, GP_IMAGE_INDIRECT, width * height);
    for (size_t i = 0; i < color.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(color[i][c], emission[i][c] + direct[i][c] + indirect[i][c],
                        2e-3 * color[i][c]);
}

TEST(RealtimeFrame, PassesAreNamedAndTimed) {
    Shown s;
    uint32_t count = 7;
    s.stage.check(gpGetPassTimes(s.frame, nullptr, 0, &count));
    EXPECT_EQ(count, 0u);
    s.render();
    GpPassTime times[64];
    s.stage.check(gpGetPassTimes(s.frame, times, 64, &count));
    ASSERT_GE(count, 4u);
    EXPECT_STREQ(times[0].name, "primary");
    double sum = 0;
    for (uint32_t i = 0; i < count; ++i) sum += times[i].milliseconds;
    GpFrameStatistics statistics{};
    s.stage.check(gpGetFrameStatistics(s.frame, &statistics));
    EXPECT_GT(sum, 0);
    EXPECT_LE(sum, statistics.secondsRender * 1e3);
    EXPECT_EQ(statistics.cameraRays, width * height);
    EXPECT_GT(statistics.shadowRays, 0u);
}

TEST(RealtimeFrame, FewerRaysGiveTheSamePictureLater) {
    Shown full, half;
    GpRealtimeOptions o{};
    for (uint32_t i = 0; i < 24; ++i) full.render(o, i);
    o.renderScale = 0.5f;
    for (uint32_t i = 0; i < 24; ++i) half.render(o, i);
    GpFrameStatistics statistics{};
    half.stage.check(gpGetFrameStatistics(half.frame, &statistics));
    EXPECT_EQ(statistics.cameraRays, 16u * 9u);
    const auto a = full.stage.read<glm::vec4>(full.frame, GP_IMAGE_COLOR, width * height);
    const auto b = half.stage.read<glm::vec4>(half.frame, GP_IMAGE_COLOR, width * height);
    double error = 0;
    for (size_t i = 0; i < a.size(); ++i) error += std::abs(double(a[i].y) - double(b[i].y));
    EXPECT_LT(error / double(a.size()), 0.06);
    EXPECT_NE(a, b);
}

TEST(RealtimeFrame, TheSameSeedGivesTheSameBitsOnAnyNumberOfThreads) {
    std::vector<glm::vec4> first;
    for (uint32_t threads : {1u, 2u, 5u}) {
        Stage stage(Shown::variant(GP_BACKEND_CPU), threads);
        Triangles ball;
        ball.sphere({0, 0, 0}, 1, 12, false, true);
        stage.add(ball, stage.lambert({0.8f, 0.4f, 0.2f}));
        stage.surround(glm::vec3(1));
        const GpFrame frame = stage.frame(width, height);
        const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 4, 2.5f);
        for (int i = 0; i < 3; ++i) stage.check(gpRender(frame, stage.scene, &camera, nullptr));
        const auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, width * height);
        if (first.empty()) first = color;
        EXPECT_EQ(first, color) << threads;
    }
}

// What BMFR has fitted shows no less light than the rays found, and little of their noise.
TEST(RealtimeFrame, BmfrKeepsTheLightAndNotTheNoise) {
    Shown noisy, fitted;
    GpRealtimeOptions none{}, bmfr{};
    none.antiAliasing = bmfr.antiAliasing = GP_AA_NONE;
    none.denoiser = GP_DENOISER_NONE, bmfr.denoiser = GP_DENOISER_BMFR;
    const auto colors = [](Shown& s) {
        return s.stage.read<glm::vec4>(s.frame, GP_IMAGE_COLOR, width * height);
    };
    std::vector<glm::dvec4> sum(width * height);
    constexpr int frames = 48;
    for (int i = 0; i < frames; ++i) {
        noisy.render(none), fitted.render(bmfr);
        const auto now = colors(noisy);
        for (size_t p = 0; p < sum.size(); ++p) sum[p] += glm::dvec4(now[p]) / double(frames);
    }
    const auto raw = colors(noisy), quiet = colors(fitted);
    double rawError = 0, quietError = 0, light = 0, quietLight = 0;
    for (size_t p = 0; p < sum.size(); ++p) {
        rawError += std::pow(raw[p].y - sum[p].y, 2);
        quietError += std::pow(quiet[p].y - sum[p].y, 2);
        light += sum[p].y, quietLight += quiet[p].y;
    }
    EXPECT_GT(rawError, 0);
    EXPECT_LT(quietError, 0.5 * rawError);
    EXPECT_NEAR(quietLight, light, 0.03 * light);
}

TEST(RealtimeFrame, AnotherDenoiserOrSceneBeginsAnew) {
    Shown s;
    const size_t middle = height / 2 * width + width / 2;
    const auto frames = [&] { return 255 * s.layer("history_length")[middle].x; };
    GpRealtimeOptions o{};
    for (int i = 0; i < 4; ++i) s.render(o);
    EXPECT_GT(frames(), 1.5f);
    o.denoiser = GP_DENOISER_SVGF;
    s.render(o);
    EXPECT_NEAR(frames(), 1, 0.1f);
    for (int i = 0; i < 3; ++i) s.render(o);
    EXPECT_GT(frames(), 1.5f);
    s.stage.scene = gpNewScene(s.stage.device);
    Triangles ball;
    ball.sphere({0, 0, 0}, 1, 12, false, true);
    s.stage.add(ball, s.stage.lambert({0.8f, 0.4f, 0.2f}));
    s.render(o);
    EXPECT_NEAR(frames(), 1, 0.1f);
}

TEST(RealtimeFrame, RendersNothingOnTheNullBackend) {
    Shown s(GP_BACKEND_NULL);
    s.render();
    EXPECT_EQ(s.stage.read<glm::u8vec4>(s.frame, GP_IMAGE_DISPLAY, width * height)[0],
              glm::u8vec4(0, 0, 0, 255));
}

TEST(RealtimeFrame, ToneMapsAnewAndSaves) {
    Shown s;
    s.render();
    const auto before = s.stage.read<glm::u8vec4>(s.frame, GP_IMAGE_DISPLAY, width * height);
    s.stage.check(gpTonemapFrame(s.frame, -2, GP_TONEMAP_NONE));
    const auto after = s.stage.read<glm::u8vec4>(s.frame, GP_IMAGE_DISPLAY, width * height);
    EXPECT_LT(after[0].x, before[0].x);
    const std::string path = std::string(GP_BINARY_DIR) + "/realtime_frame_test.exr";
    GpSaveOptions layers{};
    layers.layers = (1u << GP_IMAGE_NORMAL) | (1u << GP_IMAGE_DEPTH);
    s.stage.check(gpSaveFrame(s.frame, path.c_str(), &layers));
    GpImage image{};
    s.stage.check(gpLoadImage(s.stage.device, path.c_str(), &image));
    EXPECT_EQ(image.width, width);
    EXPECT_NEAR(image.pixels[0], 1, 1e-3);
    gpFreeImage(&image);
}

}  // namespace
}  // namespace gp::test
