// Two pictures of the same thing as one: left of a line the first, right of it the second.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gp::tool {

// Pixels of the left picture in each row of one that is `width` wide. divider: 0..1.
inline std::size_t columnsLeftOf(double divider, std::size_t width) {
    const double columns = std::round(divider * static_cast<double>(width));
    return static_cast<std::size_t>(std::clamp(columns, 0.0, static_cast<double>(width)));
}

// Both of `width` times `height` pixels of four values; so is the result. The pixel on each side of
// the line has the values of `line`, unless the line is at the border.
template <class Value>
std::vector<Value> besideEachOther(const std::vector<Value>& left, const std::vector<Value>& right,
                                   std::size_t width, std::size_t height, double divider,
                                   const std::array<Value, 4>& line) {
    const std::size_t split = columnsLeftOf(divider, width);
    std::vector<Value> both = right;
    for (std::size_t y = 0; y < height; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(4 * y * width);
        std::copy_n(left.begin() + row, 4 * split, both.begin() + row);
        if (split > 0 && split < width) {
            const auto at = row + static_cast<std::ptrdiff_t>(4 * (split - 1));
            std::copy(line.begin(), line.end(), both.begin() + at);
            std::copy(line.begin(), line.end(), both.begin() + at + 4);
        }
    }
    return both;
}

}  // namespace gp::tool
