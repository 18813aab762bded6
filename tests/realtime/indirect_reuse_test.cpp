// Indirect reuse: less noise, light that goes out at once, and what it costs in rays. That the
// unbiased kind is the reference on average is a test of unbiased_test.cpp.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "realtime/box_scene.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 48, height = 36;

GpRealtimeOptions optionsOf(GpLightReuse reuse, GpDenoiser denoiser = GP_DENOISER_NONE) {
    GpRealtimeOptions o{};
    o.antiAliasing = GP_AA_NONE;
    o.denoiser = denoiser;
    o.indirectReuse = reuse;
    return o;
}

struct Box {
    Stage stage;
    GpLight lamp;
    GpFrame frame;

    explicit Box(uint32_t threads = 0, GpMaterial (*block)(Stage&) = nullptr)
        : stage(variant(), threads) {
        lamp = buildBox(stage, block ? block(stage) : nullptr);
        frame = stage.frame(width, height);
    }
    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    void render(const GpRealtimeOptions& realtime, uint64_t seed = 0) {
        GpRenderOptions o{};
        o.realtime = realtime, o.seed = seed;
        const GpCameraDesc camera = boxCamera();
        stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    std::vector<float> indirect() {
        const auto pixels = stage.read<glm::vec4>(frame, GP_IMAGE_INDIRECT, width * height);
        std::vector<float> light;
        for (const glm::vec4& p : pixels) light.push_back(p.x + p.y + p.z);
        return light;
    }
    std::vector<glm::vec4> layer(const char* name) {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }
    double raysPerPixel() {
        GpFrameStatistics s{};
        stage.check(gpGetFrameStatistics(frame, &s));
        return double(s.cameraRays + s.bounceRays + s.shadowRays) / (width * height);
    }
};

std::vector<double> referenceOf(uint32_t frames) {
    Box box;
    std::vector<double> mean(width * height);
    for (uint32_t i = 0; i < frames; ++i) {
        GpRealtimeOptions o = optionsOf(GP_REUSE_NONE);
        o.resetHistory = 1;
        box.render(o, 1000 + i);
        const std::vector<float> light = box.indirect();
        for (size_t p = 0; p < mean.size(); ++p) mean[p] += double(light[p]) / frames;
    }
    return mean;
}

struct Noise {
    double error = 0, brightness = 0, rays = 0;
};

// After 16 frames, over the mean of the reference: squared errors and light.
Noise noiseOf(GpLightReuse reuse, const std::vector<double>& reference) {
    constexpr int runs = 4;
    Noise noise;
    for (int run = 0; run < runs; ++run) {
        Box box;
        for (int i = 0; i < 16; ++i) box.render(optionsOf(reuse), uint64_t(run));
        const std::vector<float> light = box.indirect();
        double error = 0, sum = 0, expected = 0, squares = 0;
        for (size_t p = 0; p < light.size(); ++p) {
            const double e = double(light[p]) - reference[p];
            error += e * e, sum += double(light[p]);
            expected += reference[p], squares += reference[p] * reference[p];
        }
        noise.error += error / squares / runs, noise.brightness += sum / expected / runs;
        noise.rays += box.raysPerPixel() / runs;
    }
    return noise;
}

TEST(IndirectReuse, BringsLessNoiseForFewRays) {
    const std::vector<double> reference = referenceOf(512);
    const Noise none = noiseOf(GP_REUSE_NONE, reference);
    const Noise biased = noiseOf(GP_REUSE_BIASED, reference);
    const Noise unbiased = noiseOf(GP_REUSE_UNBIASED, reference);
    const auto print = [](const char* name, const Noise& n) {
        std::printf("%s: squared error %.4f, brightness %.4f, %.2f rays a pixel\n", name, n.error,
                    n.brightness, n.rays);
    };
    print("none", none), print("biased", biased), print("unbiased", unbiased);
    EXPECT_LT(biased.error, 0.4 * none.error);
    EXPECT_LT(unbiased.error, 0.6 * none.error);
    // Four runs of 1,728 pixels that share what they found.
    EXPECT_NEAR(unbiased.brightness, 1, 0.05);
    EXPECT_NEAR(biased.brightness, 1, 0.15);
    // One to the find; those from where it was kept, but for the one who found it.
    EXPECT_GT(biased.rays, none.rays + 0.2);
    EXPECT_LE(biased.rays, none.rays + 1);
    EXPECT_GT(unbiased.rays, biased.rays + 0.2);
    EXPECT_LE(unbiased.rays, none.rays + 1 + 2);
}

// What is handed on is the lamp, not its light.
TEST(IndirectReuse, ALampThatGoesOutIsGoneInTheSameFrame) {
    for (GpLightReuse reuse : {GP_REUSE_BIASED, GP_REUSE_UNBIASED}) {
        Box box;
        for (int i = 0; i < 6; ++i) box.render(optionsOf(reuse));
        float most = 0;
        for (float l : box.indirect()) most = std::max(most, l);
        ASSERT_GT(most, 0.1f);
        box.stage.check(gpRemoveLight(box.lamp));
        box.render(optionsOf(reuse));
        for (float l : box.indirect()) ASSERT_EQ(l, 0.0f);
    }
}

// The way behind the find is asked for again where something has moved.
TEST(IndirectReuse, ALidOverTheLampIsSeenInTheSameFrame) {
    for (GpLightReuse reuse : {GP_REUSE_BIASED, GP_REUSE_UNBIASED}) {
        Box box;
        for (int i = 0; i < 6; ++i) box.render(optionsOf(reuse));
        Triangles lid;
        lid.quad({-1.9f, 1.1f, -0.9f}, {2.4f, 0, 0}, {0, 0, 2.4f});
        box.stage.add(lid, box.stage.lambert(glm::vec3(0)));
        box.render(optionsOf(reuse));
        for (float l : box.indirect()) ASSERT_EQ(l, 0.0f);
    }
}

// Pixels that repeat the last frame find what it kept: where nothing changes, no change is seen.
TEST(IndirectReuse, RepeatedPixelsShowNoChangeWhereThereIsNone) {
    for (GpLightReuse reuse : {GP_REUSE_NONE, GP_REUSE_BIASED, GP_REUSE_UNBIASED}) {
        Box box;
        for (int i = 0; i < 4; ++i) box.render(optionsOf(reuse, GP_DENOISER_ASVGF));
        double sum = 0;
        for (const glm::vec4& change : box.layer("gradient")) sum += double(change.y);
        // Weights are kept with 11 bits, luminance with 6.
        EXPECT_LT(sum / (width * height), 0.02) << "reuse " << int(reuse);
        box.stage.check(gpRemoveLight(box.lamp));
        box.render(optionsOf(reuse, GP_DENOISER_ASVGF));
        sum = 0;
        for (const glm::vec4& change : box.layer("gradient")) sum += double(change.y);
        EXPECT_GT(sum / (width * height), 0.9) << "reuse " << int(reuse);
    }
}

std::vector<glm::vec4> colorAfter(Box& box, const GpRealtimeOptions& o, int frames = 3) {
    for (int i = 0; i < frames; ++i) box.render(o);
    return box.stage.read<glm::vec4>(box.frame, GP_IMAGE_COLOR, width * height);
}

TEST(IndirectReuse, TheSameBitsOnAnyNumberOfThreads) {
    for (GpLightReuse reuse : {GP_REUSE_BIASED, GP_REUSE_UNBIASED}) {
        Box one(1), two(2), five(5);
        const GpRealtimeOptions o = optionsOf(reuse, GP_DENOISER_ASVGF);
        const auto first = colorAfter(one, o);
        EXPECT_EQ(first, colorAfter(two, o));
        EXPECT_EQ(first, colorAfter(five, o));
    }
}

GpMaterial glossy(Stage& stage) {
    GpMaterialDesc d{};
    d.given = GP_GIVEN_ROUGHNESS;
    d.roughness = 0.4f, d.metallic = 1;
    return stage.material(d);
}

TEST(IndirectReuse, EveryParameterCounts) {
    Box plain(0, glossy);
    GpRealtimeOptions o = optionsOf(GP_REUSE_BIASED);
    const auto first = colorAfter(plain, o);
    const GpDenoiserParameter others[] = {{"indirect_reuse_neighbours", 0},
                                          {"indirect_reuse_radius", 4},
                                          {"indirect_reuse_history", 1},
                                          {"indirect_reuse_roughness", 0.5f},
                                          {"indirect_reuse_ratio", 1.2f}};
    for (const GpDenoiserParameter& p : others) {
        o.parameters = &p, o.parameterCount = 1;
        Box box(0, glossy);
        EXPECT_NE(first, colorAfter(box, o)) << p.name;
    }
}

}  // namespace
}  // namespace gp::test
