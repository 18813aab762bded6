// Rasterised geometry that means no good, and the same bits on any number of threads.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "render/canvas.h"
#include "render/stage.h"

namespace gp::test {
namespace {

// Any finite float, the huge and the tiny ones as likely as the others.
float anyFloat(std::mt19937& random) {
    const int exponent = int(random() % 250) - 125;
    const float value = std::ldexp(float(random() % 1000) / 1000, exponent);
    return random() % 2 ? value : -value;
}

float someFloat(std::mt19937& random) {
    switch (random() % 4) {
        case 0: return anyFloat(random);
        case 1: return float(int(random() % 9)) - 4;
        case 2: return 0;
        default: return float(int(random() % 20000)) / 100 - 100;
    }
}

// Whatever finite numbers are handed over, the call succeeds or says what it does not want, and
// radiance stays finite.
TEST(DrawHostile, AnyFiniteNumbersAreDrawnOrRefused) {
    Stage stage(bestFullVariant()[0]);
    Triangles wall;
    wall.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    stage.add(wall, stage.lambert(glm::vec3(0.5f)));
    stage.surround(glm::vec3(1));
    const uint8_t texels[16] = {255, 0, 0, 255, 0, 255, 0, 0, 0, 0, 255, 128, 9, 9, 9, 9};
    GpTextureDesc texture{};
    texture.width = texture.height = 2;
    texture.pixels = texels;
    const GpTexture handle = stage.texture(texture);
    const GpFrame frame = stage.frame(40, 30);
    std::mt19937 random(11);
    uint32_t accepted = 0;
    for (int n = 0; n < 400; ++n) {
        std::vector<float> positions(4 * 30), uv(2 * 30), colors(4 * 30, 0.5f);
        for (float& v : positions) v = someFloat(random);
        for (float& v : uv) v = someFloat(random);
        GpDrawDesc d{};
        d.target = GpDrawTarget(random() % 3);
        d.view = GpDrawView(random() % 4);
        d.positions = positions.data(), d.positionComponents = random() % 2 ? 3 : 4;
        d.vertexCount = 30;
        d.texCoords = uv.data(), d.colors = colors.data();
        if (random() % 2) d.texture = handle;
        d.blend = int32_t(random() % 2);
        d.blendSource = GpBlendFactor(random() % 12);
        d.blendDestination = GpBlendFactor(random() % 11);
        d.depthTest = GpDepthTest(random() % 9), d.depthWrite = int32_t(random() % 2);
        if (d.view == GP_VIEW_MATRIX)
            for (float& v : d.viewProjection) v = someFloat(random);
        if (random() % 4 == 0)
            for (float& v : d.worldFromObject) v = someFloat(random);
        if (random() % 4 == 0)
            for (float& v : d.viewport) v = someFloat(random);
        accepted += gpDraw(frame, &d) == GP_SUCCESS;
        if (n % 20 != 19) continue;
        GpRenderOptions o = stage.options(1);
        GpCameraDesc camera{};
        put(camera.position, {0, 0, 3});
        camera.kind = GpCameraKind(random() % 2);
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        for (const glm::vec4& c : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, 40 * 30))
            for (int i = 0; i < 4; ++i) ASSERT_TRUE(c[i] >= 0 && c[i] <= BLEND_RADIANCE_MAX);
    }
    EXPECT_GT(accepted, 300u);
    gpGetError(stage.device, nullptr);
}

TEST(DrawHostile, ViewportsBesideAndBeyondTheFrame) {
    for (const glm::vec4 viewport : {glm::vec4(-32768, -32768, 32768, 32768),
                                     {32767, 0, 32768, 1}, {0, 32767, 1, 32768},
                                     {-20000, -20000, 32768, 32768}, {5, 5, 1e-6f, 1e-6f}}) {
        Canvas canvas(20, 20);
        DrawCommand d = countingDraw({{-1e6f, -1e6f}, {1e6f, -1e6f}, {0, 1e6f}});
        d.viewport = viewport;
        canvas.draw(d);
        const bool covers = viewport.x <= -20000 && viewport.x + viewport.z > 20;
        for (const glm::vec4& c : canvas.color) ASSERT_EQ(c.x, covers ? 1.0f : 0.0f);
    }
}

// Triangles that all lie over each other, blended: any other order would show.
TEST(DrawDeterminism, ThreadsDoNotChangeABit) {
    std::mt19937 random(12);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<DrawCommand> draws;
    for (int n = 0; n < 7; ++n) {
        std::vector<glm::vec2> corners;
        for (int i = 0; i < 3 * 300; ++i)
            corners.push_back({unit(random) * 300 - 40, unit(random) * 200 - 30});
        DrawCommand d = pixelDraw(std::move(corners));
        for (size_t i = 0; i < d.positions.size(); ++i) {
            d.colors.push_back({unit(random), unit(random), unit(random), unit(random)});
            d.positions[i].z = unit(random);
        }
        d.state.blend = true;
        d.state.blendSource = BLEND_SRC_ALPHA;
        d.state.blendDestination = n % 2 ? BLEND_ONE_MINUS_SRC_ALPHA : BLEND_SRC_COLOR;
        d.state.blendSourceAlpha = BLEND_ONE, d.state.blendDestinationAlpha = BLEND_DST_ALPHA;
        d.state.depthTest = n % 3 ? DEPTH_ALWAYS : DEPTH_LESS;
        d.state.depthWrite = n % 3 == 0;
        draws.push_back(std::move(d));
    }
    Canvas one(213, 150, {}, 1);
    one.draw(draws);
    glm::vec4 sum(0);
    for (const glm::vec4& c : one.color) sum += c;
    EXPECT_GT(sum.x, 1000);
    for (uint32_t threads : {2u, 3u, 8u}) {
        Canvas many(213, 150, {}, threads);
        many.draw(draws);
        EXPECT_EQ(many.color, one.color) << threads << " threads";
        EXPECT_EQ(many.depth, one.depth) << threads << " threads";
    }
}

// More triangles than are set up at a time.
TEST(DrawDeterminism, LongListsAreDrawnInTheirOrder) {
    std::vector<glm::vec2> corners;
    DrawCommand d = pixelDraw({});
    constexpr int count = 70000;
    for (int n = 0; n < count; ++n) {
        for (glm::vec2 corner : {glm::vec2(-9, -9), {60, -9}, {-9, 60}}) {
            d.positions.push_back({corner, 0, 1});
            d.colors.push_back({float(n), 0, 0, 1});
        }
    }
    for (size_t i = 3; i < d.positions.size() - 3; ++i) d.positions[i] *= glm::vec4(0.02f, 1, 1, 1);
    Canvas canvas(16, 16, {}, 2);
    canvas.draw(d);
    for (const glm::vec4& c : canvas.color) ASSERT_EQ(c.x, count - 1);
}

}  // namespace
}  // namespace gp::test
