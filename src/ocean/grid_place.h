// Where on its grid a cascade is read. Hot code for several instruction sets includes this:
// everything is part of the function that uses it.
#pragma once

#include <glm/glm.hpp>

namespace gp {

// The four grid points around a position of -1 or more, and the weight of each.
struct GridCorners {
    int x, y;
    float weights[4];
};

[[gnu::always_inline]] inline GridCorners gridCorners(glm::vec2 grid) {
    const int x = int(grid.x + 1.0f) - 1, y = int(grid.y + 1.0f) - 1;
    const float fx = grid.x - float(x), fy = grid.y - float(y);
    return {x, y, {(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy}};
}

// Places in a period of 1, 0 to 1, as far as numbers go that have a fraction. (std::floor is a call
// in code for every processor.)
[[gnu::always_inline]] inline float wrapped(float v) {
    if (!(v < 8388608.0f && v > -8388608.0f)) return 0.0f;
    const float f = v - float(int(v));
    return f < 0.0f ? f + 1.0f : f;
}

// In grid points of a square of `size` points; perLength: 1 / metres of its side.
[[gnu::always_inline]] inline glm::vec2 gridPosition(glm::vec2 rest, float perLength,
                                                     uint32_t size) {
    return {wrapped(rest.x * perLength) * float(size), wrapped(rest.y * perLength) * float(size)};
}

}  // namespace gp
