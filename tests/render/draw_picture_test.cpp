// A user interface over a path-traced box, as a game would draw it: pixels of the picture are what
// OpenGL's formula makes of the picture without it. Leaves draw_picture.png in the build folder, to
// look at.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t w = 320, h = 240;

void furnish(Stage& stage) {
    const glm::vec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    Triangles white, red, green, lamp;
    white.quad({-1, 0, -1}, z, x);
    white.quad({-1, 2, -1}, x, z);
    white.quad({-1, 0, -1}, x, y);
    white.box({-0.6f, 0, -0.6f}, {0, 1.2f, 0});
    white.uv0.clear();
    red.quad({-1, 0, -1}, y, z);
    green.quad({1, 0, -1}, z, y);
    lamp.quad({-0.25f, 1.995f, -0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f});
    stage.add(white, stage.lambert(glm::vec3(0.73f)));
    stage.add(red, stage.lambert({0.6f, 0.06f, 0.05f}));
    stage.add(green, stage.lambert({0.12f, 0.45f, 0.1f}));
    stage.add(lamp, stage.lambert(glm::vec3(0), glm::vec3(17, 14.5f, 10.2f)));
}

GpCameraDesc camera() {
    GpCameraDesc c{};
    put(c.position, {0, 1, 4.6f});
    put(c.target, {0, 1, 0});
    c.verticalFov = 0.5585f;
    return c;
}

// Pixels with the colours of their corners.
void bar(GpImmediate im, float x0, float y0, float x1, float y1, glm::vec4 left, glm::vec4 right) {
    gpBegin(im, GP_QUADS);
    gpColor4f(im, left.x, left.y, left.z, left.w);
    gpVertex3f(im, x0, y1, 0);
    gpVertex3f(im, x0, y0, 0);
    gpColor4f(im, right.x, right.y, right.z, right.w);
    gpVertex3f(im, x1, y0, 0);
    gpVertex3f(im, x1, y1, 0);
    gpEnd(im);
}

void drawInterface(Stage& stage, GpFrame frame) {
    const GpImmediate im = gpNewImmediate(stage.device);
    const glm::vec4 dark(0, 0, 0, 0.5f), red(0.8f, 0, 0, 1), yellow(1, 0.9f, 0, 1);
    bar(im, 10, 200, 150, 230, dark, dark);
    bar(im, 20, 210, 110, 220, red, yellow);
    gpBegin(im, GP_TRIANGLE_FAN);  // a radar
    gpColor4f(im, 0, 0.3f, 0.1f, 0.7f);
    gpVertex3f(im, 275, 45, 0);
    gpColor4f(im, 0, 1, 0.3f, 0.2f);
    for (int i = 0; i <= 48; ++i) {
        const float angle = float(i) * 6.2831853f / 48;
        gpVertex3f(im, 275 + 35 * std::cos(angle), 45 - 35 * std::sin(angle), 0);
    }
    gpEnd(im);
    GpDrawDesc d{};
    d.target = GP_DRAW_OVERLAY;
    d.blend = 1;
    stage.check(gpGetImmediateDraw(im, &d));
    stage.check(gpDraw(frame, &d));
    // A sprite in the room: a flame that the box hides a part of, added to what is there.
    gpClearImmediate(im);
    gpBegin(im, GP_TRIANGLE_FAN);
    gpColor4f(im, 3, 1.5f, 0.4f, 1);
    gpVertex3f(im, 0.1f, 0.9f, -0.3f);
    gpColor4f(im, 0, 0, 0, 1);
    for (int i = 0; i <= 48; ++i) {
        const float angle = float(i) * 6.2831853f / 48;
        gpVertex3f(im, 0.1f + 0.5f * std::cos(angle), 0.9f + 0.5f * std::sin(angle), -0.3f);
    }
    gpEnd(im);
    GpDrawDesc flame{};
    flame.blend = 1;
    flame.blendSource = flame.blendDestination = GP_BLEND_ONE;
    stage.check(gpGetImmediateDraw(im, &flame));
    stage.check(gpDraw(frame, &flame));
    gpReleaseImmediate(im);
}

TEST(DrawPicture, AUserInterfaceOverATracedRoom) {
    Stage stage(bestFullVariant()[0]);
    furnish(stage);
    GpRenderOptions o = stage.options(24);
    const GpCameraDesc view = camera();
    const GpFrame plain = stage.frame(w, h), drawn = stage.frame(w, h);
    stage.check(gpRender(plain, stage.scene, &view, &o));
    drawInterface(stage, drawn);
    stage.check(gpRender(drawn, stage.scene, &view, &o));
    stage.check(gpSaveFrame(drawn, GP_BINARY_DIR "/draw_picture.png", nullptr));
    const auto before = stage.read<glm::u8vec4>(plain, GP_IMAGE_DISPLAY, w * h);
    const auto after = stage.read<glm::u8vec4>(drawn, GP_IMAGE_DISPLAY, w * h);
    const auto expect = [&](uint32_t x, uint32_t y, glm::vec3 color, float alpha) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(float(after[y * w + x][c]),
                        255 * color[c] * alpha + (1 - alpha) * float(before[y * w + x][c]), 1.01f)
                << x << ", " << y;
    };
    expect(12, 202, {0, 0, 0}, 0.5f);
    expect(149, 229, {0, 0, 0}, 0.5f);
    expect(20, 215, {0.8011f, 0.005f, 0}, 1);
    expect(109, 215, {0.9989f, 0.895f, 0}, 1);
    expect(275, 44, {0, 0.3141f, 0.104f}, 0.6899f);  // 0.71 of 35 pixels from the radar's middle
    EXPECT_EQ(after[199 * w + 40], before[199 * w + 40]) << "above the panel";
    EXPECT_EQ(after[215 * w + 151], before[215 * w + 151]) << "beside it";
    // The flame: bright beside the box, hidden behind its front, and exact in COLOR.
    const auto light = stage.read<glm::vec4>(plain, GP_IMAGE_COLOR, w * h);
    const auto lit = stage.read<glm::vec4>(drawn, GP_IMAGE_COLOR, w * h);
    uint32_t brighter = 0;
    for (uint32_t i = 0; i < w * h; ++i) {
        const glm::vec3 added = glm::vec3(lit[i] - light[i]);
        brighter += added.x > 0;
        if (added.x > 0.01f) {
            ASSERT_NEAR(added.y, added.x * 0.5f, 1e-3f);
            ASSERT_LE(added.x, 3.0001f);
        }
    }
    EXPECT_GT(brighter, 1500u);
    const uint32_t inside = 130 * w + 140;  // the front of the box
    EXPECT_EQ(lit[inside], light[inside]);
    EXPECT_GT(lit[130 * w + 175].x, light[130 * w + 175].x + 1);
}

}  // namespace
}  // namespace gp::test
