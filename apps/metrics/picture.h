// Pictures as the metrics see them: finite linear RGB, Rec. 709, and one-channel planes of them.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace gp::metrics {

template <class Pixel>
struct Grid {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;  // top row first

    Grid() = default;
    Grid(int w, int h, Pixel value = Pixel(0))
        : width(w), height(h),
          pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    Pixel& at(int x, int y) { return pixels[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }
};

using Picture = Grid<glm::vec3>;
using Plane = Grid<float>;

}  // namespace gp::metrics
