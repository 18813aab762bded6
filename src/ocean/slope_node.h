// A mean of slopes over an area, and how means are added up. Hot code for several instruction sets
// includes this: everything is part of the function that uses it.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

#include "ocean/ocean.h"

namespace gp {

// Twelve floats, which SlopeSum adds as vectors.
struct alignas(16) SlopeNode {
    float foam = 0.0f;
    float weight = 0.0f;    // horizontal area over that at rest, at least oceanLeastJacobian
    glm::vec2 mean{0.0f};   // of slopes, by that weight
    glm::vec3 cov{0.0f};    // xx, yy, xy about the mean
    glm::vec2 gradient{0.0f};  // plain means, as of OceanPoint
    glm::vec3 stretch{0.0f};
};

static_assert(sizeof(SlopeNode) == 12 * sizeof(float), "read as vectors of 8 and 4");

// Of displaced over undisplaced area, as it counts.
[[gnu::always_inline]] inline float leastArea(glm::vec3 stretch) {
    const float area = oceanJacobian(stretch.x, stretch.y, stretch.z);
    return area > oceanLeastJacobian ? area : oceanLeastJacobian;
}

// Slope of the displaced surface: s with J^T s = gradient, where J is symmetric.
[[gnu::always_inline]] inline glm::vec2 displacedSlope(glm::vec2 gradient, glm::vec3 stretch) {
    const float perArea = 1.0f / leastArea(stretch);
    return {((1.0f + stretch.y) * gradient.x - stretch.z * gradient.y) * perArea,
            ((1.0f + stretch.x) * gradient.y - stretch.z * gradient.x) * perArea};
}

// Gathers nodes into one. Moments are about the mean of the first until the end. Inline wherever it
// is used, since a pixel adds up to a hundred, and code for one processor must not be another's.
class SlopeSum {
public:
    typedef float Four __attribute__((vector_size(16)));
    typedef float Eight __attribute__((vector_size(32)));

    // share: of the area at rest.
    [[gnu::always_inline]] void add(const SlopeNode& node, float share) {
        Eight v;
        Four shape;
        __builtin_memcpy(&v, &node, sizeof(v));
        __builtin_memcpy(&shape, &node.gradient.y, sizeof(shape));
        add(v, shape, node.weight, share);
    }
    // Of a single point: nothing varies.
    [[gnu::always_inline]] void add(float foam, glm::vec2 gradient, glm::vec3 stretch,
                                    float share) {
        const glm::vec2 s = displacedSlope(gradient, stretch);
        const float weight = leastArea(stretch);
        add(Eight{foam, weight, s.x, s.y, 0.0f, 0.0f, 0.0f, gradient.x},
            Four{gradient.y, stretch.x, stretch.y, stretch.z}, weight, share);
    }
    // Of at least one.
    [[gnu::always_inline]] SlopeNode node() const {
        SlopeNode node;
        const float weight = sums_[1], perShare = 1.0f / share_, perWeight = 1.0f / weight;
        const glm::vec2 d = perWeight * glm::vec2(sums_[2], sums_[3]);
        const float xx = perWeight * sums_[4] - d.x * d.x;
        const float yy = perWeight * sums_[5] - d.y * d.y;
        node.foam = perShare * sums_[0];
        node.weight = perShare * weight;
        node.mean = glm::vec2(about_[2], about_[3]) + d;
        node.cov = glm::vec3(xx > 0.0f ? xx : 0.0f, yy > 0.0f ? yy : 0.0f,
                             perWeight * sums_[6] - d.x * d.y);
        node.gradient = perShare * glm::vec2(sums_[7], shapes_[0]);
        node.stretch = perShare * glm::vec3(shapes_[1], shapes_[2], shapes_[3]);
        return node;
    }

private:
    // Foam, weight, mean, covariance and gradient x; what follows; the weight again.
    [[gnu::always_inline]] void add(Eight v, Four shape, float weight, float share) {
        constexpr Eight byShare = {1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f};
        constexpr Eight byWeight = {0.0f, 0.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 0.0f};
        if (share_ == 0.0f) about_ = Eight{0.0f, 0.0f, v[2], v[3]};
        share_ += share;
        const Eight d = v - about_, none = {};
        const Eight squares = __builtin_shufflevector(d, none, 8, 8, 8, 8, 2, 3, 2, 8)
                            * __builtin_shufflevector(d, none, 8, 8, 8, 8, 2, 3, 3, 8);
        sums_ += (share * byShare + (share * weight) * byWeight) * (d + squares);
        shapes_ += share * shape;
    }

    float share_ = 0.0f;
    Eight about_{};
    Eight sums_{};   // as SlopeNode: first moments for means, second ones for cov
    Four shapes_{};
};

// All levels of a pyramid but the points themselves stand behind each other, the largest first: the
// place of node (x, y) of `level`, from 1 on. Indices wrap around. (Before it: a geometric series.)
[[gnu::always_inline]] inline size_t slopeNodeIndex(uint32_t size, uint32_t level, int x, int y) {
    const uint32_t n = size >> level;
    return (size_t(size) * size - 4 * size_t(n) * n) / 3
         + size_t(uint32_t(y) & (n - 1)) * n + (uint32_t(x) & (n - 1));
}

}  // namespace gp
