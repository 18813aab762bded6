// The gradients of A-SVGF in whole frames: nothing where nothing changes, much where light does.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 48, height = 36;

// A ball on a floor under the sky.
struct Lit {
    Stage stage;
    GpFrame frame;
    GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0.3f, 1}, 4, 3);

    Lit() : stage(variant()) {
        Triangles ball, floor;
        ball.sphere({0, 0, 0}, 1, 12, false, true);
        floor.quad({-5, -1, 5}, {10, 0, 0}, {0, 0, -10});
        stage.add(ball, stage.lambert({0.8f, 0.4f, 0.2f}));
        stage.add(floor, stage.lambert({0.5f, 0.5f, 0.5f}));
        stage.surround(glm::vec3(1));
        frame = stage.frame(width, height);
    }
    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    void render() {
        GpRenderOptions o{};
        stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    // Mean and largest gradient of direct, indirect and specular light.
    std::pair<glm::vec3, glm::vec3> gradient() {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, "gradient", &pixels[0].x, pixels.size() * 16));
        glm::vec3 sum(0), most(0);
        for (const glm::vec4& p : pixels) sum += glm::vec3(p), most = max(most, glm::vec3(p));
        return {sum / float(pixels.size()), most};
    }
};

TEST(RealtimeGradient, NothingChangesInAStillPicture) {
    Lit s;
    for (int i = 0; i < 8; ++i) {
        s.render();
        // The same points and draws: what is not equal is the rounding of floats.
        EXPECT_LT(s.gradient().first.x, 1e-3f) << i;
        EXPECT_LT(s.gradient().first.y, 1e-3f) << i;
        EXPECT_LT(s.gradient().first.z, 1e-3f) << i;
    }
}

TEST(RealtimeGradient, LightThatGoesOutIsSeen) {
    Lit s;
    for (int i = 0; i < 4; ++i) s.render();
    s.stage.surround(glm::vec3(0.01f));
    s.render();
    EXPECT_GT(s.gradient().first.x, 0.7f);
    EXPECT_GT(s.gradient().first.y, 0.7f);
}

}  // namespace
}  // namespace gp::test
