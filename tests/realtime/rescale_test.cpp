// Another renderScale keeps what the frames before have found.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 62, height = 34;
constexpr size_t middle = height / 2 * width + width / 2;

struct Scaled {
    Stage stage;
    GpFrame frame;
    GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 4, 2.5f);
    GpRealtimeOptions realtime{};

    Scaled() : stage(variant()) {
        Triangles ball;
        ball.sphere({0, 0, 0}, 1, 12, false, true);
        stage.add(ball, stage.lambert({0.8f, 0.4f, 0.2f}));
        stage.surround(glm::vec3(1));
        frame = stage.frame(width, height);
    }
    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    void render(float scale, int frames) {
        realtime.renderScale = scale;
        GpRenderOptions o{};
        o.realtime = realtime;
        for (int i = 0; i < frames; ++i) stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    std::vector<glm::vec4> layer(const char* name) const {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }
    float frames() const { return 255 * layer("history_length")[middle].x; }
    std::vector<glm::vec4> color() const {
        return stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, width * height);
    }
};

// The mean difference of two pictures, over the mean of the first.
double difference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double sum = 0, mean = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(double(a[i].y) - double(b[i].y));
        mean += double(a[i].y);
    }
    return sum / mean;
}

TEST(RealtimeRescale, KeepsHistoryDownAndUp) {
    for (const GpLightReuse reuse : {GP_REUSE_NONE, GP_REUSE_BIASED}) {
        Scaled s;
        s.realtime.lightReuse = reuse;
        s.render(1, 10);
        EXPECT_GT(s.frames(), 6);
        const auto before = s.color();
        for (const float scale : {0.7f, 0.5f, 0.84f, 1.0f}) {
            s.render(scale, 1);
            EXPECT_GT(s.frames(), 6) << scale;
            // The picture goes on.
            EXPECT_LT(difference(before, s.color()), 0.04) << scale;
            for (const glm::vec4& p : s.color())
                for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(p[c]));
        }
    }
}

TEST(RealtimeRescale, ACutAndAnotherDenoiserStillForget) {
    Scaled s;
    s.render(1, 10);
    s.realtime.resetHistory = 1;
    s.render(0.5f, 1);
    EXPECT_LT(s.frames(), 1.5f);
    s.realtime.resetHistory = 0;
    s.render(0.5f, 6);
    s.realtime.denoiser = GP_DENOISER_SVGF;
    s.render(1, 1);
    EXPECT_LT(s.frames(), 1.5f);
}

}  // namespace
}  // namespace gp::test
