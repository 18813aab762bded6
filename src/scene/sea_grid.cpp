#include "scene/sea_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shading/lang.h"
GP_SHADING_BEGIN
#include "shading/ocean/sea_rings.glsl"
GP_SHADING_END

namespace gp {

float SeaGrid::radius(uint32_t ring, float height) const {
    return shading::sea_ring_radius({sectors, rings, growth, height}, ring);
}

SeaGrid seaGrid(uint32_t sectors) {
    SeaGrid grid;
    grid.sectors = sectors;
    grid.growth = shading::sea_rings_growth(sectors);
    grid.rings = 1 + uint32_t(std::ceil(std::log(SEA_OUTERMOST_RING / SEA_INNERMOST_RING) /
                                        std::log(grid.growth)));
    return grid;
}

float seaGridHeight(float height) {
    return std::clamp(std::abs(height), 1.0f, 1.0e5f);
}

std::vector<glm::uvec3> seaGridTriangles(const SeaGrid& grid) {
    std::vector<glm::uvec3> triangles;
    triangles.reserve(grid.triangleCount());
    const uint32_t n = grid.sectors;
    for (uint32_t j = 0; j < n; ++j) triangles.emplace_back(0, 1 + j, 1 + (j + 1) % n);
    for (uint32_t i = 0; i + 1 < grid.rings; ++i)
        for (uint32_t j = 0; j < n; ++j) {
            const uint32_t a = 1 + i * n + j, b = 1 + i * n + (j + 1) % n;
            triangles.emplace_back(a, a + n, b + n);
            triangles.emplace_back(a, b + n, b);
        }
    return triangles;
}

std::vector<glm::vec2> seaGridPoints(const SeaGrid& grid, float height) {
    std::vector<glm::vec2> around(grid.sectors);
    for (uint32_t j = 0; j < grid.sectors; ++j) {
        const double phi = 2 * std::numbers::pi * j / grid.sectors;
        around[j] = {float(std::cos(phi)), float(std::sin(phi))};
    }
    std::vector<glm::vec2> points;
    points.reserve(grid.vertexCount());
    points.emplace_back(0.0f);
    for (uint32_t i = 0; i < grid.rings; ++i)
        for (const glm::vec2& direction : around)
            points.push_back(direction * grid.radius(i, height));
    return points;
}

}  // namespace gp
