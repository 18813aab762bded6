// Reading the sea at points. (Over footprints: isa/slopes.inc.)
#include <algorithm>

#include "ocean/grid_place.h"
#include "ocean/ocean_parts.h"

namespace gp {

namespace {

using glm::vec2;
using glm::vec3;

void accumulate(OceanPoint& sum, const OceanPoint& p, float weight) {
    sum.displacement += weight * p.displacement;
    sum.foam += weight * p.foam;
    sum.gradient += weight * p.gradient;
    sum.stretch += weight * p.stretch;
}

OceanPoint pointAt(const OceanCascade& c, vec2 rest) {
    const GridCorners corners =
        gridCorners(gridPosition(rest, 1.0f / c.waves.length, c.waves.size));
    OceanPoint sum;
    for (int i = 0; i < 4; ++i) {
        accumulate(sum, c.point(corners.x + i % 2, corners.y + i / 2), corners.weights[i]);
    }
    return sum;
}

}  // namespace

OceanPoint Ocean::at(glm::vec2 rest) const {
    OceanPoint sum;
    float foam = parts_->table.foamScale;
    for (const OceanCascade& c : parts_->cascades) {
        const OceanPoint p = pointAt(c, rest);
        accumulate(sum, p, 1.0f);
        foam *= p.foam;
    }
    sum.foam = std::min(foam, 1.0f);
    return sum;
}

glm::vec3 Ocean::displacement(glm::vec2 rest) const {
    vec3 sum(0.0f);
    for (const OceanCascade& c : parts_->cascades) {
        const GridCorners corners =
            gridCorners(gridPosition(rest, 1.0f / c.waves.length, c.waves.size));
        for (int i = 0; i < 4; ++i) {
            sum += corners.weights[i]
                 * c.point(corners.x + i % 2, corners.y + i / 2).displacement;
        }
    }
    return sum;
}

OceanSlopes Ocean::slopes(glm::vec2 rest, glm::vec2 d0, glm::vec2 d1) const {
    return parts_->kernels.slopes(parts_->table, rest, d0, d1);
}

}  // namespace gp
