#include "ocean/slope_pyramid.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace gp {

glm::vec2 OceanPoint::slope() const {
    // J^T s = gradient, and J is symmetric.
    const glm::vec2 scaled((1.0f + stretch.y) * gradient.x - stretch.z * gradient.y,
                           (1.0f + stretch.x) * gradient.y - stretch.z * gradient.x);
    return scaled / std::max(jacobian(), oceanLeastJacobian);
}

SlopeNode slopeNode(const OceanPoint& point) {
    SlopeNode node;
    node.foam = point.foam;
    node.weight = std::max(point.jacobian(), oceanLeastJacobian);
    node.mean = point.slope();
    node.gradient = point.gradient;
    node.stretch = point.stretch;
    return node;
}

void SlopeSum::add(const SlopeNode& node, float share) {
    if (share_ == 0.0f) about_ = node.mean;
    const float w = share * node.weight;
    const glm::vec2 d = node.mean - about_;
    share_ += share;
    weight_ += w;
    foam_ += share * node.foam;
    first_ += w * d;
    second_ += w * (node.cov + glm::vec3(d.x * d.x, d.y * d.y, d.x * d.y));
    gradient_ += share * node.gradient;
    stretch_ += share * node.stretch;
}

SlopeNode SlopeSum::node() const {
    SlopeNode node;
    const glm::vec2 d = first_ / weight_;
    node.foam = foam_ / share_;
    node.weight = weight_ / share_;
    node.mean = about_ + d;
    node.cov = second_ / weight_ - glm::vec3(d.x * d.x, d.y * d.y, d.x * d.y);
    node.cov.x = std::max(node.cov.x, 0.0f);
    node.cov.y = std::max(node.cov.y, 0.0f);
    node.gradient = gradient_ / share_;
    node.stretch = stretch_ / share_;
    return node;
}

void SlopePyramid::build(const OceanPoint* points, uint32_t size) {
    size_ = size;
    size_t level = 0;
    for (uint32_t n = size / 2; n >= 1; n /= 2, ++level) {
        if (levels_.size() == level) levels_.emplace_back(size_t(n) * n);
        std::vector<SlopeNode>& to = levels_[level];
        const SlopeNode* from = level > 0 ? levels_[level - 1].data() : nullptr;
        const auto row = [&](uint32_t y) {
            for (uint32_t x = 0; x < n; ++x) {
                SlopeSum sum;
                for (uint32_t j = 0; j < 4; ++j) {
                    const size_t i = size_t(2 * y + j / 2) * (2 * n) + 2 * x + j % 2;
                    sum.add(from ? from[i] : slopeNode(points[i]), 0.25f);
                }
                to[size_t(y) * n + x] = sum.node();
            }
        };
        if (n >= 32) {
            tbb::parallel_for(0u, n, row);
        } else {
            for (uint32_t y = 0; y < n; ++y) row(y);
        }
    }
}

const SlopeNode& SlopePyramid::at(uint32_t level, int ix, int iy) const {
    const uint32_t n = size_ >> level;
    return levels_[level - 1][size_t(uint32_t(iy) & (n - 1)) * n + (uint32_t(ix) & (n - 1))];
}

}  // namespace gp
