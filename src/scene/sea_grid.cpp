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

std::vector<glm::vec2> seaGridPoints(const SeaGrid& grid, float height) {
    std::vector<glm::vec2> around(grid.sectors);
    for (uint32_t j = 0; j < grid.sectors; ++j) {
        const double phi = 2 * std::numbers::pi * j / grid.sectors;
        around[j] = {float(std::cos(phi)), float(std::sin(phi))};
    }
    around.push_back(around[0]);
    std::vector<glm::vec2> points(around.size(), glm::vec2(0));
    points.reserve(grid.vertexCount());
    for (uint32_t i = 0; i < grid.rings; ++i)
        for (const glm::vec2& direction : around)
            points.push_back(direction * grid.radius(i, height));
    return points;
}

}  // namespace gp
