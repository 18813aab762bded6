// Rasterised sky in real time: what mirrors and surfaces see of what gpDraw put into it.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

Variant realtime() {
    Variant v;
    v.mode = GP_MODE_REALTIME;
    return v;
}

constexpr glm::vec3 sides[6] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                               {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};

// One wall of a box around the origin, drawn into the sky.
void drawWall(Stage& stage, GpFrame frame, glm::vec3 n, glm::vec3 color, float turn = 0,
              int32_t blend = 0) {
    const glm::vec3 u(n.y, n.z, n.x), v(n.z, n.x, n.y);
    std::vector<glm::vec3> corners;
    for (const glm::vec2 c : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1),
                              glm::vec2(-1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
        corners.push_back(n + u * c.x + v * c.y);
    GpDrawDesc d{};
    d.target = GP_DRAW_SKY;
    d.positions = &corners[0].x, d.vertexCount = uint32_t(corners.size());
    put(d.color, color);
    d.color[3] = blend ? 0.5f : 1.0f, d.blend = blend, d.given = GP_GIVEN_DRAW_COLOR;
    const float s = std::sin(turn), c = std::cos(turn);
    const float rows[12] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0};
    std::copy(rows, rows + 12, d.worldFromObject);
    stage.check(gpDraw(frame, &d));
}

glm::vec3 colorOf(int side) {
    return {0.1f * float(side + 1), side % 2 ? 0.25f : 0.75f, side == 2 ? 4.0f : 0.5f};
}

void drawBox(Stage& stage, GpFrame frame, float turn = 0) {
    for (int side = 0; side < 6; ++side)
        drawWall(stage, frame, sides[side], colorOf(side), turn);
}

GpRenderOptions plain() {
    GpRenderOptions o{};
    o.realtime.denoiser = GP_DENOISER_NONE, o.realtime.antiAliasing = GP_AA_NONE;
    return o;
}

constexpr uint32_t size = 24;

glm::dvec3 meanOf(Stage& stage, GpFrame frame) {
    glm::dvec3 mean(0);
    for (const glm::vec4& c : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, size * size))
        mean += glm::dvec3(c) / double(size * size);
    return mean;
}

void addFloor(Stage& stage, glm::vec3 albedo) {
    Triangles floor;
    floor.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10});
    stage.add(floor, stage.lambert(albedo));
}

// A mirror at right angles to the view, turned to each side: the wall behind the camera shows.
TEST(DrawnSky, MirrorsShowItWhereItIs) {
    for (int side = 0; side < 6; ++side) {
        Stage stage(realtime());
        const glm::vec3 n = sides[side], u(n.y, n.z, n.x), v(n.z, n.x, n.y);
        GpMaterialDesc silver{};
        silver.metallic = 1, silver.given = GP_GIVEN_ROUGHNESS;
        Triangles mirror;
        mirror.quad(-9.0f * n - 5.0f * u - 5.0f * v, 10.0f * u, 10.0f * v);
        stage.add(mirror, stage.material(silver));
        const GpFrame frame = stage.frame(size, size);
        GpCameraDesc camera = lookFrom(-n, n, 1, 0.1f);
        const GpRenderOptions o = plain();
        drawBox(stage, frame);
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        const glm::dvec3 seen = meanOf(stage, frame);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c], double(colorOf(side)[c]), 0.01) << side << ' ' << c;
        // Without draws there is nothing.
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        EXPECT_EQ(meanOf(stage, frame).x, 0) << side;
    }
}

// A slanted mirror and two halves of one wall: left and right, above and below are not exchanged.
TEST(DrawnSky, CubeFacesAreNotMirrored) {
    Stage stage(realtime());
    GpMaterialDesc silver{};
    silver.metallic = 1, silver.given = GP_GIVEN_ROUGHNESS;
    Triangles mirror;
    mirror.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10});  // a lake
    stage.add(mirror, stage.material(silver));
    const GpFrame frame = stage.frame(size, size);
    GpRenderOptions o = plain();
    o.realtime.skyCubeSize = 64;
    for (int side : {0, 1, 4, 5}) {
        const glm::vec3 ahead = sides[side];
        const glm::vec3 right = glm::cross(ahead, glm::vec3(0, 1, 0));
        // What lies to the right is red, what lies to the left green.
        GpDrawDesc d{};
        d.target = GP_DRAW_SKY, d.given = GP_GIVEN_DRAW_COLOR;
        for (const float sign : {1.0f, -1.0f}) {
            const glm::vec3 corners[3] = {ahead, ahead + right * (8 * sign) + glm::vec3(0, 9, 0),
                                          ahead + right * (8 * sign) - glm::vec3(0, 9, 0)};
            d.positions = &corners[0].x, d.vertexCount = 3;
            put(d.color, sign > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
            d.color[3] = 1;
            stage.check(gpDraw(frame, &d));
        }
        // Down into the lake, ahead and to the right.
        const glm::vec3 view = glm::normalize(ahead + 0.6f * right - glm::vec3(0, 0.3f, 0));
        GpCameraDesc camera = lookFrom({0, 0, 0}, -view, 1, 0.05f);
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        const glm::dvec3 seen = meanOf(stage, frame);
        EXPECT_NEAR(seen.x, 1, 0.02) << side;
        EXPECT_NEAR(seen.y, 0, 0.02) << side;
    }
}

TEST(DrawnSky, BlueSkyMakesTheFloorBlueAsTheSameEnvironmentDoes) {
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 3, 1);
    const GpRenderOptions o = plain();
    constexpr int frames = 16;
    glm::dvec3 drawn(0), cube(0);
    for (const bool asCube : {false, true}) {
        Stage stage(realtime());
        addFloor(stage, glm::vec3(0.5f));
        if (asCube) {
            GpCubemapDesc d{};
            for (int side = 0; side < 6; ++side) {
                std::vector<glm::vec4> pixels(64 * 64, glm::vec4(colorOf(side), 1));
                GpTextureDesc t{};
                t.width = t.height = 64, t.format = GP_FORMAT_RGBA32F, t.pixels = pixels.data();
                d.faces[side] = stage.texture(t);
            }
            stage.check(gpSetCubemap(stage.scene, &d));
        }
        const GpFrame frame = stage.frame(size, size);
        for (int i = 0; i < frames; ++i) {
            if (!asCube) drawBox(stage, frame);
            stage.check(gpRender(frame, stage.scene, &camera, &o));
            (asCube ? cube : drawn) += meanOf(stage, frame) / double(frames);
        }
    }
    EXPECT_GT(drawn.z, 2 * drawn.x);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / cube[c], 1, 0.02) << c;
}

// Half transparent, over a red environment.
TEST(DrawnSky, IsBlendedOverTheEnvironment) {
    Stage stage(realtime());
    stage.surround({1, 0, 0});
    addFloor(stage, glm::vec3(1));
    const GpFrame frame = stage.frame(size, size);
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 3, 1);
    const GpRenderOptions o = plain();
    glm::dvec3 mean(0);
    for (int i = 0; i < 8; ++i) {
        for (const glm::vec3 n : sides) drawWall(stage, frame, n, {0, 0, 2}, 0, 1);
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        mean += meanOf(stage, frame) / 8.0;
    }
    EXPECT_NEAR(mean.x, 0.5, 0.02);
    EXPECT_NEAR(mean.z, 1, 0.03);
}

std::vector<glm::vec4> layer(Stage& stage, GpFrame frame, const char* name) {
    std::vector<glm::vec4> pixels(size * size);
    stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
    return pixels;
}

// The sky turns a little from frame to frame, as clouds do: light goes on being averaged.
TEST(DrawnSky, MovingCloudsKeepHistory) {
    Stage stage(realtime());
    addFloor(stage, glm::vec3(0.5f));
    const GpFrame frame = stage.frame(size, size);
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 3, 1);
    const GpRenderOptions o{};
    constexpr int frames = 24;
    for (int i = 0; i < frames; ++i) {
        drawBox(stage, frame, 0.005f * float(i));
        stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    double length = 0;
    for (const glm::vec4& p : layer(stage, frame, "history_length"))
        length += double(p.x) * 255 / (size * size);
    EXPECT_GT(length, 0.6 * frames);
    // A sky that goes out takes its light with it.
    for (int i = 0; i < 2; ++i) {
        for (const glm::vec3 n : sides) drawWall(stage, frame, n, glm::vec3(0));
        stage.check(gpRender(frame, stage.scene, &camera, &o));
    }
    EXPECT_LT(meanOf(stage, frame).z, 0.1);
}

// What is drawn in pixels says nothing about other directions; other modes know no cube.
TEST(DrawnSky, OnlyTheWorldIsSeenFromTheScene) {
    for (const GpFrameMode mode : {GP_MODE_REALTIME, GP_MODE_REFERENCE}) {
        Variant v = realtime();
        v.mode = mode;
        Stage stage(v);
        addFloor(stage, glm::vec3(0.5f));
        const GpFrame frame = stage.frame(size, size);
        const glm::vec3 corners[3] = {{0, 0, 0}, {999, 0, 0}, {0, 999, 0}};
        GpDrawDesc d{};
        d.target = GP_DRAW_SKY, d.view = GP_VIEW_PIXELS;
        d.positions = &corners[0].x, d.vertexCount = 3;
        stage.check(gpDraw(frame, &d));
        if (mode == GP_MODE_REFERENCE) drawBox(stage, frame);
        const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 3, 1);
        GpRenderOptions o{};
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        EXPECT_EQ(meanOf(stage, frame).x, 0);
    }
}

}  // namespace
}  // namespace gp::test
