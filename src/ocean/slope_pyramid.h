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

struct SlopeNode {
    float foam = 0.0f;
    float weight = 0.0f;    // horizontal area over that at rest, at least oceanLeastJacobian
    glm::vec2 mean{0.0f};   // of slopes, by that weight
    glm::vec3 cov{0.0f};    // xx, yy, xy about the mean
    glm::vec2 gradient{0.0f};  // plain means, as of OceanPoint
    glm::vec3 stretch{0.0f};
};

// Of a single point: nothing varies.
SlopeNode slopeNode(const OceanPoint& point);

// Gathers nodes into one.
class SlopeSum {
public:
    // share: of the area at rest, above 0.
    void add(const SlopeNode& node, float share);
    SlopeNode node() const;  // of at least one

private:
    float share_ = 0.0f, weight_ = 0.0f, foam_ = 0.0f;
    glm::vec2 about_{0.0f};  // the first mean: what the moments are about until the end
    glm::vec2 first_{0.0f}, gradient_{0.0f};
    glm::vec3 second_{0.0f}, stretch_{0.0f};
};

class SlopePyramid {
public:
    // size * size points, rows of y.
    void build(const OceanPoint* points, uint32_t size);
    // Level 0 are the points themselves, and the last one is a single node.
    uint32_t levels() const { return uint32_t(levels_.size()) + 1; }
    // level from 1 on; indices wrap around.
    const SlopeNode& at(uint32_t level, int ix, int iy) const;
    const SlopeNode& whole() const { return levels_.back()[0]; }

private:
    uint32_t size_ = 0;
    std::vector<std::vector<SlopeNode>> levels_;
};

}  // namespace gp
