// Slopes of one cascade and what they vary by, from single points to the whole square: a chain of
// levels of which each has a quarter of the nodes of the one before.
// Based on: Olano and Baker 2010, "LEAN Mapping"; Dupuy et al. 2013, LEADR. What is ours: moments
// are weighted by displaced horizontal area, which P22 is a density over; and they are kept about
// their own mean, so that no difference of large numbers is ever taken.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "ocean/ocean.h"

namespace gp {

// Three vectors of four floats, which SlopeSum adds as such.
struct alignas(16) SlopeNode {
    float foam = 0.0f;
    float weight = 0.0f;    // horizontal area over that at rest, at least oceanLeastJacobian
    glm::vec2 mean{0.0f};   // of slopes, by that weight
    glm::vec3 cov{0.0f};    // xx, yy, xy about the mean
    glm::vec2 gradient{0.0f};  // plain means, as of OceanPoint
    glm::vec3 stretch{0.0f};
};

// Of a single point: nothing varies.
SlopeNode slopeNode(const OceanPoint& point);

// Gathers nodes into one. Moments are about the mean of the first until the end.
class SlopeSum {
public:
    // share: of the area at rest, above 0. Inline, since a pixel adds up to a hundred.
    void add(const SlopeNode& node, float share) {
        Four v[3];
        __builtin_memcpy(v, &node, sizeof(v));
        const float w = share * node.weight;
        if (share_ == 0.0f) about_ = Four{0.0f, 0.0f, node.mean.x, node.mean.y};
        share_ += share;
        const Four d = v[0] - about_;
        sums_[0] += Four{share, share, w, w} * d;
        sums_[1] += Four{w, w, w, share}
                  * (v[1] + Four{d[2] * d[2], d[3] * d[3], d[2] * d[3], 0.0f});
        sums_[2] += share * v[2];
    }
    SlopeNode node() const;  // of at least one

private:
    typedef float Four __attribute__((vector_size(16)));

    float share_ = 0.0f;
    Four about_{};
    Four sums_[3]{};  // as SlopeNode: first moments for means, second ones for cov
};

class SlopePyramid {
public:
    // size * size points, rows of y.
    void build(const OceanPoint* points, uint32_t size);
    // Level 0 are the points themselves, and the last one is a single node.
    uint32_t levels() const { return uint32_t(levels_.size()) + 1; }
    // level from 1 on; indices wrap around.
    const SlopeNode& at(uint32_t level, int ix, int iy) const {
        const uint32_t n = size_ >> level;
        return levels_[level - 1][size_t(uint32_t(iy) & (n - 1)) * n + (uint32_t(ix) & (n - 1))];
    }
    const SlopeNode& whole() const { return levels_.back()[0]; }

private:
    uint32_t size_ = 0;
    std::vector<std::vector<SlopeNode>> levels_;
};

}  // namespace gp
