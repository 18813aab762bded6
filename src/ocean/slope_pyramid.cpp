#include "ocean/slope_pyramid.h"

#include <tbb/parallel_for.h>

namespace gp {

glm::vec2 OceanPoint::slope() const {
    return displacedSlope(gradient, stretch);
}

void SlopePyramid::build(const OceanPoint* points, uint32_t size) {
    size_ = size;
    nodes_.resize((size_t(size) * size - 1) / 3);
    levels_ = 1;
    for (uint32_t n = size / 2; n >= 1; n /= 2, ++levels_) {
        const uint32_t level = levels_;
        SlopeNode* to = nodes_.data() + slopeNodeIndex(size, level, 0, 0);
        const SlopeNode* from =
            level > 1 ? nodes_.data() + slopeNodeIndex(size, level - 1, 0, 0) : nullptr;
        const auto row = [&](uint32_t y) {
            for (uint32_t x = 0; x < n; ++x) {
                SlopeSum sum;
                for (uint32_t j = 0; j < 4; ++j) {
                    const size_t i = size_t(2 * y + j / 2) * (2 * n) + 2 * x + j % 2;
                    if (from) {
                        sum.add(from[i], 0.25f);
                    } else {
                        const OceanPoint& p = points[i];
                        sum.add(p.foam, p.gradient, p.stretch, 0.25f);
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
