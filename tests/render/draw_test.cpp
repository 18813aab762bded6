// gpDraw as programs use it: where things are drawn to, when, and what stays as it was.
#include <cstring>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t w = 32, h = 24;

class Draw : public ::testing::Test {
protected:
    Draw() : stage(bestFullVariant()[0]), frame(stage.frame(w, h)) {
        Triangles ball;
        ball.sphere({0, 0, 0}, 1, 24, false, true);
        stage.add(ball, stage.lambert({0.6f, 0.3f, 0.2f}));
        stage.surround({0.2f, 0.25f, 0.3f});
        camera = lookFrom({0, 0, 0}, {0, 0, 1}, 4, 3);
        options = stage.options(8);
        options.tonemap = GP_TONEMAP_NONE;
    }
    // A rectangle of pixels, from x0, y0 to x1, y1.
    GpDrawDesc rectangle(float x0, float y0, float x1, float y1, glm::vec4 color) {
        corners = {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
        GpDrawDesc d{};
        d.positions = &corners[0].x;
        d.vertexCount = 6;
        d.view = GP_VIEW_PIXELS;
        d.depthTest = GP_DEPTH_ALWAYS;
        std::memcpy(d.color, &color, sizeof d.color);
        return d;
    }
    void render() { stage.check(gpRender(frame, stage.scene, &camera, &options)); }
    std::vector<glm::vec4> color(GpFrameImage image = GP_IMAGE_COLOR) {
        return stage.read<glm::vec4>(frame, image, w * h);
    }
    std::vector<glm::u8vec4> display() {
        return stage.read<glm::u8vec4>(frame, GP_IMAGE_DISPLAY, w * h);
    }

    Stage stage;
    GpFrame frame;
    GpCameraDesc camera;
    GpRenderOptions options;
    std::vector<glm::vec3> corners;
};

TEST_F(Draw, TheOverlayIsDrawnOverTheTonemappedPictureAlone) {
    render();
    const auto plainColor = color();
    const auto plain = display();
    GpDrawDesc d = rectangle(2, 3, 12, 9, {1, 0.5f, 0, 0.5f});
    d.target = GP_DRAW_OVERLAY;
    d.view = GP_VIEW_DEFAULT;
    d.blend = 1;
    stage.check(gpDraw(frame, &d));
    render();
    EXPECT_EQ(color(), plainColor);
    const auto check = [&](const std::vector<glm::u8vec4>& below) {
        const auto drawn = display();
        for (uint32_t i = 0; i < w * h; ++i) {
            const bool inside = i % w >= 2 && i % w < 12 && i / w >= 3 && i / w < 9;
            for (int c = 0; c < 4; ++c) {
                const float source = c == 0 ? 255 : c == 1 ? 127.5f : c == 2 ? 0 : 255;
                const float expected =
                    inside ? 0.5f * source + 0.5f * float(below[i][c]) : float(below[i][c]);
                ASSERT_NEAR(float(drawn[i][c]), expected, 0.51f) << i << ", channel " << c;
            }
        }
    };
    check(plain);
    // Another exposure: the overlay stays as bright as it is.
    stage.check(gpTonemapFrame(frame, 1, GP_TONEMAP_NONE));
    const GpFrame other = stage.frame(w, h);
    GpRenderOptions o = options;
    o.exposureEv = 1;
    stage.check(gpRender(other, stage.scene, &camera, &o));
    check(stage.read<glm::u8vec4>(other, GP_IMAGE_DISPLAY, w * h));
    // Used up: the next picture has none.
    render();
    EXPECT_EQ(display(), plain);
    stage.check(gpTonemapFrame(frame, 0, GP_TONEMAP_NONE));
    EXPECT_EQ(display(), plain);
}

TEST_F(Draw, SceneGeometryIsRadianceAndIsTonemapped) {
    render();
    const auto plain = color(), direct = color(GP_IMAGE_DIRECT);
    const auto depth = stage.read<float>(frame, GP_IMAGE_DEPTH, w * h);
    GpFrameStatistics before{};
    stage.check(gpGetFrameStatistics(frame, &before));
    GpDrawDesc d = rectangle(0, 0, 16, 24, {3, 0.25f, 0.0625f, 1});
    d.depthWrite = 1;
    stage.check(gpDraw(frame, &d));
    options.exposureEv = 1;
    render();
    const auto drawn = color();
    const auto shown = display();
    for (uint32_t i = 0; i < w * h; ++i)
        ASSERT_EQ(drawn[i], i % w < 16 ? glm::vec4(3, 0.25f, 0.0625f, 1) : plain[i]) << i;
    EXPECT_EQ(shown[0], glm::u8vec4(255, 188, 99, 255));  // sRGB of 2 * 0.25 and 2 * 0.0625
    EXPECT_EQ(color(GP_IMAGE_DIRECT), direct) << "other images keep what was traced";
    EXPECT_EQ(stage.read<float>(frame, GP_IMAGE_DEPTH, w * h), depth);
    GpFrameStatistics after{};
    stage.check(gpGetFrameStatistics(frame, &after));
    EXPECT_EQ(after.frameBytes, before.frameBytes + w * h * sizeof(glm::vec4));
}

TEST_F(Draw, AccumulationIsOfWhatWasTracedAlone) {
    options.samplesPerPixel = 4;
    render();
    options.samplesPerPixel = 4, options.accumulate = 1;
    render();
    const auto plain = color();
    options.accumulate = 0;
    for (int n = 0; n < 2; ++n) {
        GpDrawDesc d = rectangle(0, 0, 32, 24, {100, 100, 100, 1});
        stage.check(gpDraw(frame, &d));
        render();
        EXPECT_EQ(color()[5].x, 100);
        options.accumulate = 1;
    }
    options.accumulate = 0;
    GpDrawDesc d = rectangle(0, 0, 32, 24, {100, 100, 100, 1});
    stage.check(gpDraw(frame, &d));
    render();
    options.accumulate = 1;
    render();
    EXPECT_EQ(color(), plain);
}

TEST_F(Draw, TheSkyIsSeenWhereNothingIs) {
    options.samplesPerPixel = 64;
    options.tonemap = GP_TONEMAP_NONE;
    render();
    const auto plain = color();
    GpDrawDesc d = rectangle(0, 0, 32, 24, {0, 5, 0, 1});
    d.target = GP_DRAW_SKY;
    stage.check(gpDraw(frame, &d));
    render();
    const auto drawn = color();
    uint32_t sky = 0, ball = 0, edges = 0;
    for (uint32_t i = 0; i < w * h; ++i) {
        const float coverage = plain[i].w;
        ASSERT_NEAR(drawn[i].w, 1, 1e-5) << "an opaque sky covers";
        if (coverage == 0) {
            ++sky;
            ASSERT_EQ(drawn[i], glm::vec4(0, 5, 0, 1)) << i;
        } else if (coverage > 0.9999f) {
            ++ball;
            ASSERT_EQ(glm::vec3(drawn[i]), glm::vec3(plain[i])) << i;
        } else {
            // The environment is one colour: its share is replaced exactly.
            ++edges;
            const glm::vec3 change = (1 - coverage) * (glm::vec3(0, 5, 0) -
                                                       glm::vec3(0.2f, 0.25f, 0.3f));
            ASSERT_LT(glm::length(glm::vec3(drawn[i] - plain[i]) - change), 2e-4f) << i;
        }
    }
    EXPECT_GT(sky, 100u);
    EXPECT_GT(ball, 100u);
    EXPECT_GT(edges, 10u);
}

// A box of walls around the origin: the camera's place does not matter, its direction does.
TEST_F(Draw, TheSkyIsInfinitelyFarAway) {
    corners = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, -1, -1}, {1, 1, -1}, {-1, 1, -1}};
    GpDrawDesc d{};
    d.target = GP_DRAW_SKY;
    d.positions = &corners[0].x;
    d.vertexCount = 6;
    camera.kind = GP_CAMERA_PERSPECTIVE;
    const auto skyAt = [&](glm::vec3 from, glm::vec3 towards) {
        put(camera.position, from), put(camera.target, from + towards);
        stage.check(gpDraw(frame, &d));
        render();
        return color()[0].x;
    };
    EXPECT_EQ(skyAt({30, 0, 0}, {0, 0, -1}), 1);
    EXPECT_EQ(skyAt({0, -500, 80}, {0, 0, -1}), 1);
    EXPECT_LT(skyAt({30, 0, 0}, {0, 0, 1}), 0.5f);
    EXPECT_LT(skyAt({30, 0, 0}, {1, 0, 0}), 0.5f);
}

TEST_F(Draw, TargetsHaveTheirOrderAndTheirDepth) {
    // Overlay first, scene second, sky third: the pictures' order is not that of the calls.
    GpDrawDesc overlay = rectangle(0, 0, 8, 24, {1, 1, 1, 1});
    overlay.target = GP_DRAW_OVERLAY;
    stage.check(gpDraw(frame, &overlay));
    GpDrawDesc scene = rectangle(0, 0, 16, 24, {0.25f, 0, 0, 1});
    stage.check(gpDraw(frame, &scene));
    GpDrawDesc sky = rectangle(0, 0, 32, 24, {0, 0, 0.25f, 1});
    sky.target = GP_DRAW_SKY;
    stage.check(gpDraw(frame, &sky));
    render();
    const auto shown = display();
    EXPECT_EQ(shown[0], glm::u8vec4(255, 255, 255, 255));
    EXPECT_EQ(shown[12], glm::u8vec4(137, 0, 0, 255));
    EXPECT_EQ(shown[31], glm::u8vec4(0, 0, 137, 255));
    // In the overlay a near thing that is drawn first hides a far one.
    GpDrawDesc near = rectangle(0, 0, 8, 8, {1, 0, 0, 1});
    near.target = GP_DRAW_OVERLAY, near.depthTest = GP_DEPTH_LESS, near.depthWrite = 1;
    for (glm::vec3& c : corners) c.z = 1;
    stage.check(gpDraw(frame, &near));
    GpDrawDesc far = near;
    far.color[1] = 1;
    for (glm::vec3& c : corners) c.z = 2;
    stage.check(gpDraw(frame, &far));
    render();
    EXPECT_EQ(display()[0], glm::u8vec4(255, 0, 0, 255));
}

TEST_F(Draw, ACancelledRenderUsesItsDrawsUpAndAFailedOneKeepsThem) {
    GpDrawDesc d = rectangle(0, 0, 32, 24, {7, 7, 7, 1});
    stage.check(gpDraw(frame, &d));
    GpRenderOptions wrong = options;
    wrong.clamp = -1;
    EXPECT_EQ(gpRender(frame, stage.scene, &camera, &wrong), GP_ERROR_OUT_OF_RANGE);
    render();
    EXPECT_EQ(color()[0].x, 7) << "still waiting after the failure";
    stage.check(gpDraw(frame, &d));
    GpRenderOptions stopped = options;
    stopped.progress = [](void*, const GpProgress*) { return 1; };
    EXPECT_EQ(gpRender(frame, stage.scene, &camera, &stopped), GP_ERROR_CANCELLED);
    EXPECT_EQ(color()[0].x, 7);
    render();
    EXPECT_LT(color()[0].x, 1);
    gpGetError(stage.device, nullptr);
}

TEST_F(Draw, ObjectsAreMovedAndPositionsMayBeHomogeneous) {
    const float positions[] = {0, 0, 0, 2, 20, 0, 0, 2, 0, 40, 0, 2};  // w = 2: a half of each
    GpDrawDesc d{};
    d.positions = positions;
    d.positionComponents = 4;
    d.vertexCount = 3;
    d.view = GP_VIEW_PIXELS;
    d.depthTest = GP_DEPTH_ALWAYS;
    const float moved[12] = {1, 0, 0, 4, 0, 1, 0, 0, 0, 0, 1, 0};
    std::memcpy(d.worldFromObject, moved, sizeof moved);
    render();
    const auto plain = color();
    stage.check(gpDraw(frame, &d));
    render();
    const auto drawn = color();
    for (uint32_t x = 0; x < w; ++x)
        ASSERT_EQ(drawn[x] != plain[x], x >= 4 && x < 14) << x;
}

// In real time a picture remembers the ones before: what is drawn must not get into its memory.
TEST_F(Draw, RealTimeFramesAreDrawnIntoWithoutRememberingIt) {
    stage.variant.mode = GP_MODE_REALTIME;
    GpRenderOptions o{};
    o.tonemap = GP_TONEMAP_NONE;
    const auto film = [&](bool draws) {
        frame = stage.frame(w, h);
        std::vector<std::vector<glm::vec4>> pictures;
        for (int n = 0; n < 3; ++n) {
            if (draws && n == 1) {
                GpDrawDesc scene = rectangle(0, 0, 16, 24, {9, 1, 0, 1});
                stage.check(gpDraw(frame, &scene));
                GpDrawDesc sky = rectangle(0, 0, 32, 24, {0, 0, 0.25f, 1});
                sky.target = GP_DRAW_SKY;
                stage.check(gpDraw(frame, &sky));
                GpDrawDesc overlay = rectangle(0, 0, 4, 4, {1, 1, 1, 1});
                overlay.target = GP_DRAW_OVERLAY;
                stage.check(gpDraw(frame, &overlay));
            }
            stage.check(gpRender(frame, stage.scene, &camera, &o));
            pictures.push_back(color());
            if (n != 1) continue;
            EXPECT_EQ(display()[0], draws ? glm::u8vec4(255) : display()[w - 1]);
            stage.check(gpTonemapFrame(frame, 1, GP_TONEMAP_NONE));
            if (draws) {
                EXPECT_EQ(display()[0], glm::u8vec4(255));
                EXPECT_EQ(display()[15], glm::u8vec4(255, 255, 0, 255));
                EXPECT_EQ(display()[w - 1], glm::u8vec4(0, 0, 188, 255));
            }
        }
        return pictures;
    };
    const auto plain = film(false), drawn = film(true);
    EXPECT_EQ(drawn[0], plain[0]);
    EXPECT_EQ(drawn[2], plain[2]) << "the next picture remembers nothing of it";
    EXPECT_EQ(drawn[1][12 * w], glm::vec4(9, 1, 0, 1));
    EXPECT_EQ(drawn[1][31], glm::vec4(0, 0, 0.25f, 1));
    EXPECT_EQ(drawn[1][12 * w + 17], plain[1][12 * w + 17]) << "the ball";
    // Something behind the ball is hidden by it.
    corners = {{-9, -9, -2}, {9, -9, -2}, {0, 20, -2}};
    GpDrawDesc behind{};
    behind.positions = &corners[0].x, behind.vertexCount = 3;
    stage.check(gpDraw(frame, &behind));
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    EXPECT_EQ(color()[12 * w + 1], glm::vec4(1));
    EXPECT_NE(color()[12 * w + 16], glm::vec4(1));
}

}  // namespace
}  // namespace gp::test
