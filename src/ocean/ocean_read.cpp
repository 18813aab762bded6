// Reading the sea at points and over footprints.
#include <algorithm>
#include <array>
#include <cmath>

#include "ocean/ocean_parts.h"

namespace gp {

namespace {

using glm::vec2;
using glm::vec3;

// The four grid points around a position, and the weight of each.
struct Corners {
    int x, y;
    float weights[4];
};

Corners cornersOf(vec2 grid) {
    const vec2 cell(std::floor(grid.x), std::floor(grid.y));
    const vec2 f = grid - cell;
    return {int(cell.x), int(cell.y),
            {(1.0f - f.x) * (1.0f - f.y), f.x * (1.0f - f.y), (1.0f - f.x) * f.y, f.x * f.y}};
}

// Of a length, so that its integer part stays small however far the position is.
float wrapped(float v, float length) { return v - length * std::floor(v / length); }

vec2 gridPosition(const OceanCascade& c, vec2 rest) {
    const float length = c.waves.length;
    return vec2(wrapped(rest.x, length), wrapped(rest.y, length)) * (float(c.waves.size) / length);
}

void accumulate(OceanPoint& sum, const OceanPoint& p, float weight) {
    sum.displacement += weight * p.displacement;
    sum.foam += weight * p.foam;
    sum.gradient += weight * p.gradient;
    sum.stretch += weight * p.stretch;
}

OceanPoint pointAt(const OceanCascade& c, vec2 rest) {
    const Corners corners = cornersOf(gridPosition(c, rest));
    OceanPoint sum;
    for (int i = 0; i < 4; ++i) {
        accumulate(sum, c.point(corners.x + i % 2, corners.y + i / 2), corners.weights[i]);
    }
    return sum;
}

// Foam of all cascades from that of each. Each is the chance of foam given one cascade alone, and
// their means are nearly the same: given all, it is the mean times what each changes it by, if
// they are independent.
class FoamProduct {
public:
    void add(float foam, float mean) {
        logMean_ += std::log(std::max(mean, 1.0e-30f));
        product_ *= mean > 0.0f ? foam / mean : 0.0f;
        ++count_;
    }
    float foam() const {
        return std::clamp(product_ * std::exp(logMean_ / float(count_)), 0.0f, 1.0f);
    }

private:
    float logMean_ = 0.0f, product_ = 1.0f;
    int count_ = 0;
};

// Where and how coarsely a cascade is read for a footprint.
struct Probes {
    int count;
    vec2 first, step;  // positions, m
    float level;       // of the pyramid
};

// A long footprint is read several times along its longer side. A node's weight falls off linearly
// to both sides, which is twice the variance of a box: hence nodes are narrower by sqrt(2).
Probes probesOf(const OceanCascade& c, uint32_t levels, vec2 rest, vec2 d0, vec2 d1) {
    constexpr float most = 16.0f;
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

void addLevel(SlopeSum& sum, const OceanCascade& c, uint32_t level, vec2 position, float share) {
    if (share <= 0.0f) return;
    if (level == 0) {
        // Between points the surface is what is interpolated: nothing varies.
        sum.add(slopeNode(pointAt(c, position)), share);
        return;
    }
    // The centre of node i of level l is grid position (i + 1/2) 2^l - 1/2.
    const float scale = 1.0f / float(1u << level);
    const Corners corners =
        cornersOf((gridPosition(c, position) + vec2(0.5f)) * scale - vec2(0.5f));
    for (int i = 0; i < 4; ++i) {
        if (corners.weights[i] <= 0.0f) continue;
        sum.add(c.slopes.at(level, corners.x + i % 2, corners.y + i / 2),
                share * corners.weights[i]);
    }
}

SlopeNode nodeOver(const OceanCascade& c, vec2 rest, vec2 d0, vec2 d1) {
    const Probes probes = probesOf(c, c.slopes.levels(), rest, d0, d1);
    const auto level = uint32_t(probes.level);
    const float f = probes.level - float(level);
    SlopeSum sum;
    for (int i = 0; i < probes.count; ++i) {
        const vec2 position = probes.first + float(i) * probes.step;
        addLevel(sum, c, level, position, 1.0f - f);
        addLevel(sum, c, level + 1, position, f);
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
    FoamProduct foam;
    for (const OceanCascade& c : parts_->cascades) {
        const OceanPoint p = pointAt(c, rest);
        accumulate(sum, p, 1.0f);
        foam.add(p.foam, c.slopes.whole().foam);
    }
    sum.foam = foam.foam();
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
    FoamProduct foam;
    const size_t count = parts_->cascades.size();
    for (size_t i = 0; i < count; ++i) {
        const OceanCascade& c = parts_->cascades[i];
        nodes[i] = nodeOver(c, rest, d0, d1);
        all.gradient += nodes[i].gradient;
        all.stretch += nodes[i].stretch;
        foam.add(nodes[i].foam, c.slopes.whole().foam);
    }
    OceanSlopes result;
    result.mean = all.slope();
    result.foam = foam.foam();
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
