// Reading the sea at points and over footprints.
#include <algorithm>
#include <array>
#include <cmath>

#include "ocean/ocean_parts.h"

namespace gp {

namespace {

using glm::vec2;
using glm::vec3;

// The four grid points around a position of -1 or more, and the weight of each.
struct Corners {
    int x, y;
    float weights[4];
};

Corners cornersOf(vec2 grid) {
    const int x = int(grid.x + 1.0f) - 1, y = int(grid.y + 1.0f) - 1;
    const vec2 f = grid - vec2(float(x), float(y));
    return {x, y,
            {(1.0f - f.x) * (1.0f - f.y), f.x * (1.0f - f.y), (1.0f - f.x) * f.y, f.x * f.y}};
}

// Places in a period of 1, 0 to 1, as far as numbers go that have a fraction. (std::floor is a call
// in code for every processor.)
float wrapped(float v) {
    if (!(std::abs(v) < 8388608.0f)) return 0.0f;
    const float f = v - float(int(v));
    return f < 0.0f ? f + 1.0f : f;
}

vec2 gridPosition(const OceanCascade& c, vec2 rest) {
    const vec2 period = rest * (1.0f / c.waves.length);
    return vec2(wrapped(period.x), wrapped(period.y)) * float(c.waves.size);
}

void accumulate(OceanPoint& sum, const OceanPoint& p, float weight) {
    sum.displacement += weight * p.displacement;
    sum.foam += weight * p.foam;
    sum.gradient += weight * p.gradient;
    sum.stretch += weight * p.stretch;
}

OceanPoint pointAt(const OceanCascade& c, vec2 grid) {
    const Corners corners = cornersOf(grid);
    OceanPoint sum;
    for (int i = 0; i < 4; ++i) {
        accumulate(sum, c.point(corners.x + i % 2, corners.y + i / 2), corners.weights[i]);
    }
    return sum;
}

// Where and how coarsely a cascade is read for a footprint.
struct Probes {
    int count;
    vec2 first, step;  // positions, m
    float level;       // of the pyramid
};

// A long footprint is read several times along its longer side. A node's weight falls off linearly
// to both sides, which is twice the variance of a box: hence nodes are narrower by sqrt(2). More
// than four readings would cost more than they show: what is then too wide has its variance in cov.
Probes probesOf(const OceanCascade& c, uint32_t levels, vec2 rest, vec2 d0, vec2 d1) {
    constexpr float most = 4.0f;
    if (!(glm::dot(d0, d0) + glm::dot(d1, d1) < 1.0e16f)) {
        // As good as infinite, or no number at all: the whole sea.
        return {1, rest, vec2(0.0f), float(levels - 1)};
    }
    const float texel = c.waves.length / float(c.waves.size);
    const bool firstIsLonger = glm::dot(d0, d0) >= glm::dot(d1, d1);
    const vec2 axis = firstIsLonger ? d0 : d1;
    const float longer = glm::length(axis);
    const vec2 other = firstIsLonger ? d1 : d0;
    // The width across the longer side, which is less than the other where they are askew.
    const float area = std::abs(axis.x * other.y - axis.y * other.x);
    const float across = longer > 0.0f ? area / longer : 0.0f;
    const float width = std::max({across, longer / most, texel});
    Probes probes;
    probes.count = std::clamp(int(std::ceil(longer / width)), 1, int(most));
    probes.step = axis / float(probes.count);
    probes.first = rest - 0.5f * axis + 0.5f * probes.step;
    const float size = std::max(across, longer / float(probes.count));
    probes.level = size > 0.0f ? std::clamp(std::log2(size / texel) - 0.5f, 0.0f,
                                            float(levels - 1)) : 0.0f;
    return probes;
}

void addLevel(SlopeSum& sum, const OceanCascade& c, uint32_t level, vec2 grid, float share) {
    if (share <= 0.0f) return;
    if (level == 0) {
        // Between points the surface is what is interpolated: nothing varies.
        sum.add(slopeNode(pointAt(c, grid)), share);
        return;
    }
    // The centre of node i of level l is grid position (i + 1/2) 2^l - 1/2.
    const float scale = 1.0f / float(1u << level);
    const Corners corners = cornersOf((grid + vec2(0.5f)) * scale - vec2(0.5f));
    for (int i = 0; i < 4; ++i) {
        if (corners.weights[i] <= 0.0f) continue;
        sum.add(c.slopes.at(level, corners.x + i % 2, corners.y + i / 2),
                share * corners.weights[i]);
    }
}

SlopeNode nodeOver(const OceanCascade& c, vec2 rest, vec2 d0, vec2 d1) {
    const Probes probes = probesOf(c, c.slopes.levels(), rest, d0, d1);
    const auto level = uint32_t(probes.level);
    if (level + 1 == c.slopes.levels()) return c.slopes.whole();
    const float f = probes.level - float(level);
    SlopeSum sum;
    for (int i = 0; i < probes.count; ++i) {
        const vec2 grid = gridPosition(c, probes.first + float(i) * probes.step);
        addLevel(sum, c, level, grid, 1.0f - f);
        addLevel(sum, c, level + 1, grid, f);
    }
    return sum.node();
}

// Covariance of J^-T s for s of covariance cov (xx, yy, xy), J by stretch: short waves are steeper
// where longer ones squeeze them.
vec3 squeezed(vec3 cov, vec3 stretch) {
    const float least = std::max(oceanJacobian(stretch.x, stretch.y, stretch.z),
                                 oceanLeastJacobian);
    const float a = (1.0f + stretch.y) / least, b = -stretch.z / least;
    const float d = (1.0f + stretch.x) / least;
    const float ax = a * cov.x + b * cov.z, ay = a * cov.z + b * cov.y;
    const float bx = b * cov.x + d * cov.z, by = b * cov.z + d * cov.y;
    return vec3(ax * a + ay * b, bx * b + by * d, ax * b + ay * d);
}

}  // namespace

OceanPoint Ocean::at(glm::vec2 rest) const {
    OceanPoint sum;
    float foam = parts_->foamScale;
    for (const OceanCascade& c : parts_->cascades) {
        const OceanPoint p = pointAt(c, gridPosition(c, rest));
        accumulate(sum, p, 1.0f);
        foam *= p.foam;
    }
    sum.foam = std::min(foam, 1.0f);
    return sum;
}

glm::vec3 Ocean::displacement(glm::vec2 rest) const {
    vec3 sum(0.0f);
    for (const OceanCascade& c : parts_->cascades) {
        const Corners corners = cornersOf(gridPosition(c, rest));
        for (int i = 0; i < 4; ++i) {
            sum += corners.weights[i]
                 * c.point(corners.x + i % 2, corners.y + i / 2).displacement;
        }
    }
    return sum;
}

OceanSlopes Ocean::slopes(glm::vec2 rest, glm::vec2 d0, glm::vec2 d1) const {
    std::array<SlopeNode, oceanMostCascades> nodes;
    OceanPoint all;
    float foam = parts_->foamScale;
    const size_t count = parts_->cascades.size();
    for (size_t i = 0; i < count; ++i) {
        const OceanCascade& c = parts_->cascades[i];
        nodes[i] = nodeOver(c, rest, d0, d1);
        all.gradient += nodes[i].gradient;
        all.stretch += nodes[i].stretch;
        foam *= nodes[i].foam;
    }
    OceanSlopes result;
    result.mean = all.slope();
    result.foam = std::min(foam, 1.0f);
    vec3 cov(0.0f);
    for (size_t i = 0; i < count; ++i) {
        const SlopeNode& node = nodes[i];
        // A mean slope is not quite that of mean derivatives.
        OceanPoint alone;
        alone.gradient = node.gradient;
        alone.stretch = node.stretch;
        result.mean += node.mean - alone.slope();
        cov += squeezed(node.cov, all.stretch - node.stretch);
    }
    result.varX = cov.x;
    result.varY = cov.y;
    result.cov = cov.z;
    return result;
}

}  // namespace gp
