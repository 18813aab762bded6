// Slopes of one cascade and what they vary by, from single points to the whole square: a chain of
// levels of which each has a quarter of the nodes of the one before.
// Based on: Olano and Baker 2010, "LEAN Mapping"; Dupuy et al. 2013, LEADR. What is ours: moments
// are weighted by displaced horizontal area, which P22 is a density over; and they are kept about
// their own mean, so that no difference of large numbers is ever taken.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/slope_node.h"

namespace gp {

class SlopePyramid {
public:
    // size * size points, rows of y.
    void build(const OceanPoint* points, uint32_t size);
    // Level 0 are the points themselves, and the last one is a single node.
    uint32_t levels() const { return levels_; }
    // level from 1 on; indices wrap around.
    const SlopeNode& at(uint32_t level, int ix, int iy) const {
        return nodes_[slopeNodeIndex(size_, level, ix, iy)];
    }
    const SlopeNode& whole() const { return nodes_.back(); }
    // In the order of slopeNodeIndex.
    const SlopeNode* nodes() const { return nodes_.data(); }

private:
    uint32_t size_ = 0, levels_ = 0;
    std::vector<SlopeNode> nodes_;
};

}  // namespace gp
