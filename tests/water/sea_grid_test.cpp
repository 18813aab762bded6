// The triangles of the sea: closed, upright, and what they show of the waves.
#include <map>

#include <gtest/gtest.h>

#include "scene/sea_grid.h"
#include "scene/sea_shape.h"

namespace gp {
namespace {

// Of all vertices at one place the first: the middle, and where the last column is the first again.
uint32_t place(const SeaGrid& grid, uint32_t vertex) {
    const uint32_t columns = grid.lattice().columns;
    const uint32_t row = vertex / columns, column = vertex % columns;
    return row == 0 ? 0 : row * columns + column % grid.sectors;
}

TEST(SeaGrid, EveryInnerEdgeBelongsToTwoTriangles) {
    const SeaGrid grid = seaGrid(16);
    std::map<std::pair<uint32_t, uint32_t>, int> edges;  // by direction
    for (const glm::uvec3& t : latticeTriangles(grid.lattice())) {
        for (int i = 0; i < 3; ++i) ASSERT_LT(t[i], grid.vertexCount());
        const uint32_t p[3] = {place(grid, t.x), place(grid, t.y), place(grid, t.z)};
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
        for (int i = 0; i < 3; ++i) ++edges[{p[i], p[(i + 1) % 3]}];
    }
    const uint32_t outermost = grid.rings * grid.lattice().columns;
    size_t border = 0;
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);  // the neighbour runs through it the other way
        if (edges.contains({edge.second, edge.first})) continue;
        ++border;
        EXPECT_GE(std::min(edge.first, edge.second), outermost);
    }
    EXPECT_EQ(border, grid.sectors);
}

TEST(SeaGrid, WhatIsOnePlaceIsOnePoint) {
    const SeaGrid grid = seaGrid(48);
    const std::vector<glm::vec2> points = seaGridPoints(grid, 7);
    ASSERT_EQ(points.size(), grid.vertexCount());
    for (uint32_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], points[place(grid, i)]) << i;
}

TEST(SeaGrid, TrianglesFaceUpwardsAndReachTheHorizon) {
    for (const uint32_t sectors : {seaSectorsLeast, 384u}) {
        const SeaGrid grid = seaGrid(sectors);
        const float height = 3;
        const std::vector<glm::vec2> points = seaGridPoints(grid, height);
        size_t none = 0;
        for (const glm::uvec3& t : latticeTriangles(grid.lattice())) {
            const glm::vec2 a = points[t.y] - points[t.x], b = points[t.z] - points[t.x];
            const float area = a.x * b.y - a.y * b.x;
            ASSERT_GE(area, 0) << t.x << ' ' << t.y << ' ' << t.z;
            none += area == 0;
        }
        EXPECT_EQ(none, sectors);
        EXPECT_GE(glm::length(points.back()), 5000 * height);
        EXPECT_NEAR(glm::length(points[grid.lattice().columns]), 0.1 * height, 1e-4);
    }
    EXPECT_LT(seaGrid(384).vertexCount(), 260000u);
}

TEST(SeaGrid, HeightsAreWithinWhatTheGridCanBe) {
    EXPECT_EQ(seaGridHeight(-20), 20);
    EXPECT_EQ(seaGridHeight(0), 1);
    EXPECT_EQ(seaGridHeight(1e9f), 1.0e5f);
}

OceanSettings breeze() {
    OceanSettings s;
    s.windSpeed = 8;
    s.size = 64;
    return s;
}

TEST(SeaShape, SmallCellsShowTheWavesThemselves) {
    Ocean ocean(breeze());
    ocean.setTime(7);
    SeaShape shape;
    shape.read(ocean);
    const SeaShape::Detail finest = shape.detail(0);
    for (int i = 0; i < 40; ++i) {
        const glm::vec2 rest(31.7f * float(i) - 600, 17.3f * float(i * i % 91));
        const glm::vec3 expected = ocean.displacement(rest);
        const glm::vec3 found = SeaShape::at(rest, finest);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 2e-3) << i;
    }
}

TEST(SeaShape, LargeCellsShowLessAndLess) {
    const Ocean ocean(breeze());
    SeaShape shape;
    shape.read(ocean);
    double last = 1e9;
    for (const float cell : {0.05f, 1.0f, 10.0f, 100.0f, 1000.0f}) {
        const SeaShape::Detail detail = shape.detail(cell);
        double square = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::vec3 d = SeaShape::at({0.913f * float(i), 1.37f * float(i % 977)}, detail);
            square += double(d.z * d.z) / 4000;
        }
        EXPECT_LT(square, last) << cell;
        last = square;
    }
    EXPECT_LT(last, 1e-6);
}

}  // namespace
}  // namespace gp
