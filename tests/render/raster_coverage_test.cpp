// Which pixels a triangle covers: the top-left rule to the last bit, and no gap and no double hit
// along edges that triangles share, clipped or not.
#include <cmath>
#include <random>

#include "render/canvas.h"

namespace gp::test {
namespace {

class RasterCoverage : public ::testing::TestWithParam<std::string> {};

// The rule by its definition, for corners on the grid of 1/256 pixel: products are exact in double.
bool covers(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
    const auto side = [](glm::dvec2 from, glm::dvec2 to, glm::dvec2 at) {
        return (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
    };
    if (side(a, b, c) < 0) std::swap(b, c);
    if (side(a, b, c) == 0) return false;
    const glm::dvec2 corners[4] = {a, b, c, a};
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 from = corners[i], to = corners[i + 1];
        const double s = side(from, to, p);
        const bool top = from.y == to.y && to.x > from.x, left = to.y < from.y;
        if (s < 0 || (s == 0 && !top && !left)) return false;
    }
    return true;
}

TEST_P(RasterCoverage, FollowsTheTopLeftRuleExactly) {
    // Corners on pixel centres, corners and edges of pixels often: there the rule decides.
    std::mt19937 random(1);
    Canvas canvas(24, 20, GetParam());
    const auto coordinate = [&](uint32_t size) {
        const uint32_t steps = random() % 4 == 0 ? 256u : 2u;
        return double(random() % (size * steps)) / steps;
    };
    size_t hits = 0;
    for (int n = 0; n < 2000; ++n) {
        const glm::dvec2 a(coordinate(24), coordinate(20)), b(coordinate(24), coordinate(20)),
            c(coordinate(24), coordinate(20));
        canvas.color.assign(canvas.color.size(), glm::vec4(0));
        canvas.draw(pixelDraw({glm::vec2(a), glm::vec2(b), glm::vec2(c)}));
        for (uint32_t y = 0; y < 20; ++y)
            for (uint32_t x = 0; x < 24; ++x) {
                const bool expected = covers(a, b, c, {x + 0.5, y + 0.5});
                hits += expected;
                ASSERT_EQ(canvas.at(x, y).x, expected ? 1.0f : 0.0f)
                    << "triangle " << n << ", pixel " << x << ", " << y;
            }
    }
    EXPECT_GT(hits, 50000u);
}

TEST_P(RasterCoverage, RectanglesOfWholePixelsAreExact) {
    Canvas canvas(16, 16, GetParam());
    canvas.draw(rectangleDraw({3, 5}, {11, 9}));
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 16; ++x)
            EXPECT_EQ(canvas.at(x, y).x, x >= 3 && x < 11 && y >= 5 && y < 9 ? 1.0f : 0.0f);
}

TEST_P(RasterCoverage, EdgesThatTrianglesShareAreHitOnce) {
    // A grid of points, moved at random, over more than the canvas: every pixel exactly once.
    std::mt19937 random(2);
    std::uniform_real_distribution<float> offset(-0.2f, 0.2f);
    constexpr uint32_t side = 30;
    constexpr float cell = 5.3f;
    std::vector<glm::vec2> points;
    for (uint32_t y = 0; y <= side; ++y)
        for (uint32_t x = 0; x <= side; ++x)
            points.push_back((glm::vec2(float(x), float(y)) +
                              glm::vec2(offset(random), offset(random))) * cell - 10.0f);
    DrawCommand d = countingDraw(points);
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t i = y * (side + 1) + x, below = i + side + 1;
            for (uint32_t corner : {i, i + 1, below + 1, i, below + 1, below})
                d.indices.push_back(corner);
        }
    Canvas canvas(130, 120, GetParam());
    canvas.draw(d);
    for (uint32_t y = 0; y < 120; ++y)
        for (uint32_t x = 0; x < 130; ++x) ASSERT_EQ(canvas.at(x, y).x, 1) << x << ", " << y;
}

// A floor of many squares from behind the camera to the horizon: near plane and guard band cut most
// of them.
TEST_P(RasterCoverage, ClippingOpensNoGaps) {
    Canvas canvas(160, 120, GetParam());
    canvas.camera.position = {0, 1, 0};
    canvas.camera.target = {0.3f, 0.8f, -1};
    constexpr int side = 40;
    constexpr float cell = 100;
    DrawCommand d = countingDraw({});
    d.view = DrawView::camera;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x)
            d.positions.push_back({float(x - side / 2) * cell + 0.137f, 0,
                                   float(y - side / 2) * cell - 0.211f, 1});
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t i = y * (side + 1) + x, below = i + side + 1;
            for (uint32_t corner : {i, i + 1, below + 1, i, below + 1, below})
                d.indices.push_back(corner);
        }
    canvas.draw(d);
    // A camera that looks down a little: all rows below the middle see the floor within 2 km.
    for (uint32_t y = 60; y < 120; ++y)
        for (uint32_t x = 0; x < 160; ++x) ASSERT_EQ(canvas.at(x, y).x, 1) << x << ", " << y;
    for (uint32_t x = 0; x < 160; ++x) EXPECT_EQ(canvas.at(x, 2).x, 0) << "above the horizon";
}

TEST_P(RasterCoverage, HugeTrianglesCoverWhatTheyShould) {
    Canvas canvas(40, 30, GetParam());
    canvas.draw(countingDraw({{-1e9f, -1e9f}, {1e9f, -1e9f}, {20, 1e9f}}));
    for (const glm::vec4& c : canvas.color) ASSERT_EQ(c.x, 1);
    canvas.draw(countingDraw({{1e30f, -1e30f}, {3e38f, 3e38f}, {2e38f, 3e38f}}));
    for (const glm::vec4& c : canvas.color) ASSERT_EQ(c.x, 1);
}

TEST_P(RasterCoverage, CullingAndDegenerateTriangles) {
    Canvas canvas(16, 16, GetParam());
    DrawCommand clockwise = countingDraw({{0, 0}, {16, 0}, {0, 16}});
    clockwise.cull = Cull::back;
    canvas.draw(clockwise);
    EXPECT_EQ(canvas.at(2, 2).x, 0) << "counter-clockwise is the front";
    clockwise.cull = Cull::front;
    canvas.draw(clockwise);
    EXPECT_EQ(canvas.at(2, 2).x, 1);
    DrawCommand counter = countingDraw({{0, 0}, {0, 16}, {16, 0}});
    counter.cull = Cull::back;
    canvas.draw(counter);
    EXPECT_EQ(canvas.at(2, 2).x, 2);
    canvas.draw(countingDraw({{0, 0}, {8, 8}, {16, 16}}));  // no area
    canvas.draw(countingDraw({{5, 5}, {5, 5}, {5, 5}}));
    EXPECT_EQ(canvas.at(2, 2).x, 2);
    EXPECT_EQ(canvas.at(5, 5).x, 2);
}

TEST_P(RasterCoverage, ViewportsMoveAndLimit) {
    Canvas canvas(20, 20, GetParam());
    DrawCommand d = countingDraw({{-100, -100}, {300, -100}, {-100, 300}});
    d.viewport = {4, 6, 5, 7};
    canvas.draw(d);
    for (uint32_t y = 0; y < 20; ++y)
        for (uint32_t x = 0; x < 20; ++x)
            EXPECT_EQ(canvas.at(x, y).x, x >= 4 && x < 9 && y >= 6 && y < 13 ? 1.0f : 0.0f);
    d.viewport = {-30, -30, 20, 20};  // beside the frame
    canvas.draw(d);
    EXPECT_EQ(canvas.at(0, 0).x, 0);
    // Its upper left corner is where pixels are counted from.
    Canvas shifted(20, 20, GetParam());
    DrawCommand corner = countingDraw({{0, 0}, {2, 0}, {2, 2}, {0, 0}, {2, 2}, {0, 2}});
    corner.viewport = {-1, 17, 10, 10};
    shifted.draw(corner);
    EXPECT_EQ(shifted.at(0, 17).x, 1);
    EXPECT_EQ(shifted.at(0, 18).x, 1);
    EXPECT_EQ(shifted.at(1, 17).x, 0);
}

INSTANTIATE_TEST_SUITE_P(All, RasterCoverage, ::testing::ValuesIn(instructionSetsHere()),
                         instructionSetName);

}  // namespace
}  // namespace gp::test
