// Which triangle of the sea lies where, by formulas, against the vertices that the mesh has.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/sea_grid.h"

#include "shading/lang.h"
GP_SHADING_BEGIN
#include "shading/ocean/sea_rings.glsl"
GP_SHADING_END

namespace gp {
namespace {

using shading::SeaRings;
using shading::SeaTriangle;

SeaRings ringsOf(const SeaGrid& grid, float height) {
    return {grid.sectors, grid.rings, grid.growth, height};
}

struct Corners {
    glm::vec2 a, b, c;
    glm::vec2 at(float u, float v) const { return a * (1 - u - v) + b * u + c * v; }
    float size() const { return std::max(glm::length(b - a), glm::length(c - a)); }
};

struct MeshOfRings {
    SeaGrid grid;
    float height;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::vec2> points;

    MeshOfRings(uint32_t sectors, float h)
        : grid(seaGrid(sectors)), height(h), triangles(latticeTriangles(grid.lattice())),
          points(seaGridPoints(grid, h)) {}
    Corners corners(size_t i) const {
        const glm::uvec3 t = triangles[i];
        return {points[t.x], points[t.y], points[t.z]};
    }
};

constexpr glm::vec2 inside[] = {{0.3f, 0.4f}, {0.02f, 0.95f}, {0.01f, 0.02f}, {0.97f, 0.01f}};

TEST(SeaRings, TrianglesAreWhereTheMeshHasThem) {
    for (const uint32_t sectors : {16u, 384u}) {
        const MeshOfRings m(sectors, 7);
        const SeaRings rings = ringsOf(m.grid, m.height);
        for (size_t i = 0; i < m.triangles.size(); i += sectors == 16 ? 1 : 37)
            for (const glm::vec2 at : inside) {
                const Corners c = m.corners(i);
                const glm::vec2 found =
                    shading::sea_place_of_triangle(rings, uint32_t(i), at.x, at.y);
                ASSERT_LT(glm::length(found - c.at(at.x, at.y)), 1e-3f * c.size()) << i;
            }
    }
}

TEST(SeaRings, EveryPlaceIsFoundInItsTriangle) {
    for (const uint32_t sectors : {16u, 384u}) {
        const MeshOfRings m(sectors, 40);
        const SeaRings rings = ringsOf(m.grid, m.height);
        for (size_t i = 0; i < m.triangles.size(); i += sectors == 16 ? 1 : 37)
            for (const glm::vec2 at : inside) {
                if (i < 2 * sectors && i % 2 == 0) continue;  // of the middle: no area
                const SeaTriangle t =
                    shading::sea_triangle_at(rings, m.corners(i).at(at.x, at.y));
                ASSERT_EQ(t.exists, 1u) << i;
                ASSERT_EQ(t.number, i) << at.x << ' ' << at.y;
                ASSERT_NEAR(t.u, at.x, 2e-3) << i;
                ASSERT_NEAR(t.v, at.y, 2e-3) << i;
            }
    }
}

// The rings of another viewer, elsewhere and at another height, have the same water.
TEST(SeaRings, WaterIsFoundAgainUnderOtherRings) {
    const MeshOfRings before(384, 3), now(384, 3.7f);
    const glm::vec2 step(1.3f, -0.8f);  // by which the middle has gone
    const SeaRings rings = ringsOf(now.grid, now.height);
    for (size_t i = 0; i < before.triangles.size(); i += 53) {
        const glm::vec2 place = before.corners(i).at(0.3f, 0.4f) - step;
        const SeaTriangle t = shading::sea_triangle_at(rings, place);
        ASSERT_EQ(t.exists, 1u) << i;
        ASSERT_LT(t.number, now.triangles.size());
        const Corners c = now.corners(t.number);
        ASSERT_LT(glm::length(c.at(t.u, t.v) - place), 1e-3f * c.size()) << i;
    }
}

TEST(SeaRings, BeyondTheLastRingIsNothing) {
    const MeshOfRings m(16, 3);
    const SeaRings rings = ringsOf(m.grid, m.height);
    const float last = m.grid.radius(m.grid.rings - 1, m.height);
    for (const glm::vec2 place : {glm::vec2(1.01f * last, 0), glm::vec2(0, -1e6f * last)}) {
        const SeaTriangle t = shading::sea_triangle_at(rings, place);
        EXPECT_EQ(t.exists, 0u);
        EXPECT_LT(t.number, m.triangles.size());  // nothing is read outside of the mesh
    }
    EXPECT_EQ(shading::sea_triangle_at(rings, {0.9f * last, 0}).exists, 1u);
    EXPECT_LT(shading::sea_triangle_at(rings, {0, 0}).number, 32u);
}

}  // namespace
}  // namespace gp
