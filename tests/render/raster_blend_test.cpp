// Blending of each pair of factors against the formula of OpenGL's specification, written down here
// once more in double; tests of alpha; colours and their interpolation.
#include <cmath>
#include <random>

#include "render/canvas.h"

namespace gp::test {
namespace {

class RasterBlend : public ::testing::TestWithParam<std::string> {};

constexpr uint32_t lastFactor = BLEND_SRC_ALPHA_SATURATE;

// One channel's factor: 3 is alpha. [OpenGL 2.1 specification, table 4.2]
double factorOf(uint32_t factor, int c, glm::dvec4 s, glm::dvec4 d) {
    switch (factor) {
        case BLEND_ZERO: return 0;
        case BLEND_ONE: return 1;
        case BLEND_SRC_COLOR: return s[c];
        case BLEND_ONE_MINUS_SRC_COLOR: return 1 - s[c];
        case BLEND_SRC_ALPHA: return s.w;
        case BLEND_ONE_MINUS_SRC_ALPHA: return 1 - s.w;
        case BLEND_DST_ALPHA: return d.w;
        case BLEND_ONE_MINUS_DST_ALPHA: return 1 - d.w;
        case BLEND_DST_COLOR: return d[c];
        case BLEND_ONE_MINUS_DST_COLOR: return 1 - d[c];
        default: return c == 3 ? 1 : std::min(s.w, 1 - d.w);
    }
}

glm::dvec4 blended(const DrawState& b, glm::dvec4 s, glm::dvec4 d, double most) {
    glm::dvec4 r;
    for (int c = 0; c < 4; ++c) {
        const uint32_t fs = c == 3 ? b.blendSourceAlpha : b.blendSource;
        const uint32_t fd = c == 3 ? b.blendDestinationAlpha : b.blendDestination;
        const double v = s[c] * factorOf(fs, c, s, d) + d[c] * factorOf(fd, c, s, d);
        r[c] = std::clamp(v, 0.0, c == 3 ? 1.0 : most);
    }
    return r;
}

// All pairs for colour, and by a shift of one all pairs for alpha.
template <class Check>
void forAllPairs(const Check& check) {
    for (uint32_t source = BLEND_ZERO; source <= lastFactor; ++source)
        for (uint32_t destination = BLEND_ZERO; destination < lastFactor; ++destination) {
            DrawState state;
            state.depthTest = DEPTH_ALWAYS;
            state.blend = true;
            state.blendSource = source, state.blendDestination = destination;
            state.blendSourceAlpha = source % lastFactor + 1;
            state.blendDestinationAlpha = destination % (lastFactor - 1) + 1;
            SCOPED_TRACE(std::to_string(source) + " " + std::to_string(destination));
            check(state);
        }
}

TEST_P(RasterBlend, RadianceFollowsTheFormulaForEveryPair) {
    Canvas canvas(4, 4, GetParam());
    const glm::vec4 source(0.3f, 1.7f, 0.05f, 0.6f), there(2.5f, 0.2f, 0.8f, 0.3f);
    forAllPairs([&](const DrawState& state) {
        DrawCommand d = rectangleDraw({0, 0}, {4, 4}, source);
        d.state = state;
        canvas.color.assign(16, there);
        canvas.draw(d);
        const glm::dvec4 expected = blended(state, source, there, 1e30);
        for (const glm::vec4& c : canvas.color)
            for (int i = 0; i < 4; ++i) ASSERT_NEAR(c[i], expected[i], 1e-6) << "channel " << i;
    });
}

TEST_P(RasterBlend, DisplaysFollowTheFormulaForEveryPair) {
    Canvas canvas(4, 4, GetParam());
    const glm::vec4 source(0.3f, 0.9f, 0.05f, 0.6f);
    const glm::u8vec4 there(250, 20, 128, 77);
    forAllPairs([&](const DrawState& state) {
        DrawCommand d = rectangleDraw({0, 0}, {4, 4}, source);
        d.state = state;
        canvas.display.assign(16, there);
        canvas.draw({d}, true);
        const glm::dvec4 expected =
            blended(state, source, glm::dvec4(there) / 255.0, 1.0) * 255.0;
        for (const glm::u8vec4& c : canvas.display)
            for (int i = 0; i < 4; ++i)  // rounded to the nearest
                ASSERT_NEAR(double(c[i]), expected[i], 0.5001) << "channel " << i;
    });
}

// Combinations that have code of their own must be what the general code makes of them.
TEST_P(RasterBlend, TheUsualStatesAgreeWithTheFormula) {
    const uint32_t usual[][4] = {
        {BLEND_SRC_ALPHA, BLEND_ONE_MINUS_SRC_ALPHA, BLEND_ONE, BLEND_ONE_MINUS_SRC_ALPHA},
        {BLEND_SRC_ALPHA, BLEND_ONE, BLEND_ONE, BLEND_ONE},
        {BLEND_ONE, BLEND_ZERO, BLEND_ONE, BLEND_ZERO}};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    for (const auto& f : usual) {
        Canvas canvas(40, 1, GetParam());
        std::vector<glm::vec4> there(40);
        for (glm::vec4& c : there)
            c = {unit(random) * 3, unit(random), unit(random), unit(random)};
        canvas.color = there;
        DrawCommand d = rectangleDraw({0, 0}, {37, 1}, {0.2f, 1.5f, 0.7f, 0.45f});
        d.state.blend = true;
        d.state.blendSource = f[0], d.state.blendDestination = f[1];
        d.state.blendSourceAlpha = f[2], d.state.blendDestinationAlpha = f[3];
        canvas.draw(d);
        for (uint32_t x = 0; x < 40; ++x) {
            const glm::dvec4 expected =
                x < 37 ? blended(d.state, d.color, there[x], 1e30) : glm::dvec4(there[x]);
            for (int i = 0; i < 4; ++i) ASSERT_NEAR(canvas.color[x][i], expected[i], 1e-6) << x;
        }
    }
}

TEST_P(RasterBlend, NothingBecomesInfiniteOrNotANumber) {
    Canvas canvas(4, 4, GetParam());
    for (float radiance : {1e6f, 3e38f, std::numeric_limits<float>::infinity()})
        forAllPairs([&](const DrawState& state) {
            DrawCommand d = rectangleDraw({0, 0}, {4, 4}, {1e6f, 0, 1e-30f, 1});
            d.state = state;
            canvas.color.assign(16, glm::vec4(radiance, 0, 1, 1));
            for (int n = 0; n < 3; ++n) canvas.draw(d);
            for (const glm::vec4& c : canvas.color)
                for (int i = 0; i < 4; ++i)
                    ASSERT_TRUE(c[i] >= 0 && c[i] <= BLEND_RADIANCE_MAX) << c[i];
        });
}

TEST_P(RasterBlend, AlphaBelowTheThresholdIsNotDrawn) {
    Canvas canvas(32, 1, GetParam());
    DrawCommand d = rectangleDraw({0, 0}, {32, 1});
    d.colors = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};  // alpha = x / 32
    d.state.alphaThreshold = 0.5f;
    d.state.depthWrite = true;
    canvas.draw(d);
    for (uint32_t x = 0; x < 32; ++x) {
        EXPECT_EQ(canvas.at(x, 0).x, x >= 16 ? 1.0f : 0.0f) << x;
        EXPECT_EQ(std::isinf(canvas.depth[x]), x < 16) << x;
    }
}

TEST_P(RasterBlend, ColoursAreInterpolatedAndMultiplied) {
    Canvas canvas(64, 8, GetParam());
    DrawCommand d = rectangleDraw({0, 0}, {64, 8}, {2, 1, 0.5f, 1});
    d.colors = {{0, 1, 1, 1}, {1, 1, 0, 1}, {1, 1, 0, 1}, {0, 1, 1, 1}};
    canvas.draw(d);
    for (uint32_t x = 0; x < 64; ++x) {
        const float share = (float(x) + 0.5f) / 64;
        EXPECT_NEAR(canvas.at(x, 3).x, 2 * share, 1e-5);
        EXPECT_NEAR(canvas.at(x, 3).y, 1, 1e-6);
        EXPECT_NEAR(canvas.at(x, 3).z, 0.5f * (1 - share), 1e-5);
    }
}

TEST_P(RasterBlend, WhatComesLaterLiesAbove) {
    Canvas canvas(8, 8, GetParam());
    std::vector<DrawCommand> draws;
    for (int n = 1; n <= 50; ++n)
        draws.push_back(rectangleDraw({0, 0}, {8, 8}, glm::vec4(float(n), 0, 0, 1)));
    canvas.draw(draws);
    for (const glm::vec4& c : canvas.color) EXPECT_EQ(c.x, 50);
}

INSTANTIATE_TEST_SUITE_P(All, RasterBlend, ::testing::ValuesIn(instructionSetsHere()),
                         instructionSetName);

}  // namespace
}  // namespace gp::test
