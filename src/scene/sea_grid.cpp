#include "scene/sea_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp {

namespace {

// In heights of the viewer. The outermost ring is seen 0.2 mrad below the horizontal, a tenth of a
// pixel or so; the innermost one lies at the viewer's feet.
constexpr float innermost = 0.1f, outermost = 5000;

}  // namespace

float SeaGrid::radius(uint32_t ring, float height) const {
    return innermost * height * std::pow(growth, float(ring));
}

SeaGrid seaGrid(uint32_t sectors) {
    SeaGrid grid;
    grid.sectors = sectors;
    // As long as wide.
    grid.growth = 1 + float(2 * std::numbers::pi) / float(sectors);
    grid.rings =
        1 + uint32_t(std::ceil(std::log(outermost / innermost) / std::log(grid.growth)));
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
