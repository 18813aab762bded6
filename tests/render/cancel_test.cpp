// Cancelling from another thread stops in the middle of a batch: some tiles have samples that
// others lack. What the frame tells is what every pixel has, and going on evens it out.
#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class Cancel : public ::testing::TestWithParam<Variant> {};

void furnish(Stage& stage) {
    Triangles room;
    room.sphere({0, 0, 0}, 2, 16, true, false);
    stage.add(room, stage.lambert(glm::vec3(0.8f), glm::vec3(0.2f)));
}

GpCameraDesc view() {
    GpCameraDesc c{};
    put(c.position, {0.5f, 0.4f, 0.3f});
    return c;
}

TEST_P(Cancel, InTheMiddleOfABatchAndGoOn) {
    constexpr uint32_t size = 48, total = 16;
    Stage stage(GetParam(), 2);
    furnish(stage);
    const GpCameraDesc camera = view();
    const GpFrame plain = stage.frame(size, size), stopped = stage.frame(size, size);
    GpRenderOptions o = stage.options(total);
    o.noRussianRoulette = 1;
    stage.check(gpRender(plain, stage.scene, &camera, &o));
    GpFrameStatistics s{};
    stage.check(gpGetFrameStatistics(plain, &s));
    const double seconds = s.secondsRender;

    uint32_t held = 0;
    int cancelled = 0;
    o.accumulate = 1;
    for (int attempt = 0; held < total; ++attempt) {
        o.samplesPerPixel = total - held;
        std::atomic<bool> done = false;
        std::thread other([&] {
            // Somewhere within the first renders; later ones run to their end.
            const double wait = attempt < 3 ? seconds * (0.13 + 0.21 * attempt) : 1e9;
            const auto end = std::chrono::steady_clock::now() +
                             std::chrono::duration<double>(std::min(wait, 60.0));
            while (!done && std::chrono::steady_clock::now() < end)
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            if (!done) gpCancelRender(stage.device);
        });
        const GpError result = gpRender(stopped, stage.scene, &camera, &o);
        done = true;
        other.join();
        ASSERT_TRUE(result == GP_SUCCESS || result == GP_ERROR_CANCELLED) << gpErrorName(result);
        cancelled += result == GP_ERROR_CANCELLED;
        stage.check(gpGetFrameStatistics(stopped, &s));
        ASSERT_GE(s.samplesPerPixel, held);
        ASSERT_LE(s.samplesPerPixel, total);
        held = s.samplesPerPixel;
    }
    EXPECT_GT(cancelled, 0);
    for (const GpFrameImage image : {GP_IMAGE_COLOR, GP_IMAGE_VARIANCE}) {
        const auto a = stage.read<glm::uvec4>(plain, image, size * size);
        const auto b = stage.read<glm::uvec4>(stopped, image, size * size);
        size_t different = 0;
        for (size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
        EXPECT_EQ(different, 0u) << "image " << int(image);
    }
}

INSTANTIATE_TEST_SUITE_P(Best, Cancel, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
