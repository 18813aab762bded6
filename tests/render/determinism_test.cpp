// The same seed gives the same bits, on any number of threads and however the samples are cut.
#include <cstring>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 37, height = 23;  // no multiples of a tile

// A little of everything that draws random numbers: veils, lamps, gloss, glass, a lens.
void furnish(Stage& stage) {
    Triangles floor, ball, lamp, veil;
    floor.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
    GpMaterialDesc gloss{};
    gloss.roughness = 0.3f;
    stage.add(floor, stage.material(gloss));
    ball.sphere({0, 0.6f, 0}, 0.6f, 12, false, true);
    GpMaterialDesc glass{};
    glass.roughness = 0.2f, glass.transmission = 1, glass.solid = 1;
    stage.add(ball, stage.material(glass));
    lamp.quad({-0.5f, 2, -0.5f}, {1, 0, 0}, {0, 0, 1});
    stage.add(lamp, stage.lambert(glm::vec3(0), {6, 5, 4}));
    veil.quad({-1, 0, 0.8f}, {1, 0, 0}, {0, 1, 0});
    GpMaterialDesc veiled = lambertDesc({0.2f, 0.4f, 0.8f});
    veiled.alphaMode = GP_ALPHA_BLEND, veiled.baseColor[3] = 0.5f;
    stage.add(veil, stage.material(veiled));
    stage.surround({0.2f, 0.3f, 0.4f});
    GpLightDesc point{};  // the only light here that is one in GP_MODE_LOCAL too
    point.kind = GP_LIGHT_SPHERE, point.intensity = 1;
    put(point.position, {-1.5f, 1.5f, 1});
    stage.light(point);
}

GpCameraDesc view() {
    GpCameraDesc c{};
    put(c.position, {0.5f, 1, 4});
    put(c.target, {0, 0.6f, 0});
    c.apertureRadius = 0.05f;
    return c;
}

class Determinism : public ::testing::TestWithParam<Variant> {
protected:
    struct Call {
        uint32_t samples;
        uint64_t seed;
    };
    // All bits of the sums that a frame shows, after these calls.
    static std::vector<uint32_t> bits(uint32_t threads, const std::vector<Call>& calls) {
        Stage stage(GetParam(), threads);
        furnish(stage);
        const GpFrame frame = stage.frame(width, height);
        for (const Call& call : calls) {
            GpRenderOptions o = stage.options(call.samples);
            o.seed = call.seed;
            o.accumulate = 1;
            const GpCameraDesc camera = view();
            stage.check(gpRender(frame, stage.scene, &camera, &o));
        }
        return bitsOf(stage, frame);
    }
    static std::vector<uint32_t> bitsOf(const Stage& stage, GpFrame frame) {
        std::vector<uint32_t> all;
        for (const GpFrameImage image : {GP_IMAGE_COLOR, GP_IMAGE_VARIANCE, GP_IMAGE_DIRECT,
                                         GP_IMAGE_ALBEDO, GP_IMAGE_NORMAL}) {
            const auto part = stage.read<glm::uvec4>(frame, image, width * height);
            const auto* words = reinterpret_cast<const uint32_t*>(part.data());
            all.insert(all.end(), words, words + part.size() * 4);
        }
        const auto depth = stage.read<uint32_t>(frame, GP_IMAGE_DEPTH, width * height);
        const auto instance = stage.read<uint32_t>(frame, GP_IMAGE_INSTANCE, width * height);
        all.insert(all.end(), depth.begin(), depth.end());
        all.insert(all.end(), instance.begin(), instance.end());
        return all;
    }
};

TEST_P(Determinism, ThreadsDoNotMatter) {
    const auto one = bits(1, {{8, 5}});
    EXPECT_EQ(one, bits(2, {{8, 5}}));
    EXPECT_EQ(one, bits(7, {{8, 5}}));
}

TEST_P(Determinism, CuttingDoesNotMatter) {
    const auto whole = bits(2, {{16, 1}});
    EXPECT_EQ(whole, bits(2, {{4, 1}, {4, 1}, {4, 1}, {4, 1}}));
    EXPECT_EQ(whole, bits(3, {{1, 1}, {13, 1}, {2, 1}}));
}

TEST_P(Determinism, SeedsDiffer) {
    const auto first = bits(2, {{4, 1}});
    for (const uint64_t seed : {uint64_t(0), uint64_t(2), uint64_t(1) << 32}) {
        const auto other = bits(2, {{4, seed}});
        size_t same = 0;
        for (size_t i = 0; i < width * height * 4; ++i) same += other[i] == first[i];
        // Alpha is 1 in both, and the plain surrounding fills 40 % of the picture.
        EXPECT_LT(same, size_t(width) * height * 4 * 13 / 20) << "seed " << seed;
    }
}

// Cancelled wherever it may be, the frame keeps what it has, and going on gives the very bits of a
// render that nobody stopped.
TEST_P(Determinism, CancelledRendersGoOn) {
    constexpr uint32_t total = 192;
    const auto whole = bits(2, {{total, 3}});
    Stage stage(GetParam(), 2);
    furnish(stage);
    const GpFrame frame = stage.frame(width, height);
    const GpCameraDesc camera = view();
    uint32_t held = 0, cancelled = 0;
    struct Stopper {
        GpDevice device;
        int calls;
    } stopper{stage.device, 0};
    while (held < total) {
        GpRenderOptions o = stage.options(total - held);
        o.seed = 3, o.accumulate = 1, o.progressUser = &stopper;
        stopper.calls = 0;
        // Stops the second batch of each call.
        o.progress = [](void* user, const GpProgress*) {
            return ++static_cast<Stopper*>(user)->calls == 2 ? 1 : 0;
        };
        const GpError result = gpRender(frame, stage.scene, &camera, &o);
        ASSERT_TRUE(result == GP_SUCCESS || result == GP_ERROR_CANCELLED);
        cancelled += result == GP_ERROR_CANCELLED;
        GpFrameStatistics s{};
        stage.check(gpGetFrameStatistics(frame, &s));
        ASSERT_GT(s.samplesPerPixel, held);
        held = s.samplesPerPixel;
    }
    EXPECT_GT(cancelled, 0u);
    EXPECT_EQ(held, total);
    EXPECT_EQ(bitsOf(stage, frame), whole);
}

INSTANTIATE_TEST_SUITE_P(All, Determinism, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });
INSTANTIATE_TEST_SUITE_P(Local, Determinism, ::testing::ValuesIn(localVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
