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
    // Written as the vectors that SlopeSum reads at once: a processor waits where a vector is read
    // that was written number by number.
    typedef float Four __attribute__((vector_size(16)));
    const glm::vec2 g = point.gradient, slope = point.slope();
    const glm::vec3 s = point.stretch;
    const float weight = std::max(point.jacobian(), oceanLeastJacobian);
    const Four v[3] = {
        {point.foam, weight, slope.x, slope.y}, {0.0f, 0.0f, 0.0f, g.x}, {g.y, s.x, s.y, s.z}};
    SlopeNode node;
    __builtin_memcpy(static_cast<void*>(&node), v, sizeof(v));
    return node;
}

static_assert(sizeof(SlopeNode) == 12 * sizeof(float), "SlopeSum reads three vectors");

SlopeNode SlopeSum::node() const {
    SlopeNode node;
    const float weight = sums_[0][1], perShare = 1.0f / share_, perWeight = 1.0f / weight;
    const glm::vec2 d = perWeight * glm::vec2(sums_[0][2], sums_[0][3]);
    node.foam = perShare * sums_[0][0];
    node.weight = perShare * weight;
    node.mean = glm::vec2(about_[2], about_[3]) + d;
    node.cov = perWeight * glm::vec3(sums_[1][0], sums_[1][1], sums_[1][2])
             - glm::vec3(d.x * d.x, d.y * d.y, d.x * d.y);
    node.cov.x = std::max(node.cov.x, 0.0f);
    node.cov.y = std::max(node.cov.y, 0.0f);
    node.gradient = perShare * glm::vec2(sums_[1][3], sums_[2][0]);
    node.stretch = perShare * glm::vec3(sums_[2][1], sums_[2][2], sums_[2][3]);
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
                    if (from) {
                        sum.add(from[i], 0.25f);
                    } else {
                        sum.add(slopeNode(points[i]), 0.25f);
                    }
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

}  // namespace gp
