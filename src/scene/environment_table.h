// The table that directions of an environment image are chosen from, in proportion to luminance and
// solid angle: first a row, then a column, by inverting cumulative sums.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/image.h"

namespace gp {

// Cells are the image's pixels. Radiance is read bilinearly, so a cell's weight is the largest of its
// own and its neighbours' luminance: no direction with light has a density of zero.
struct EnvironmentTable {
    uint32_t width = 0, height = 0;
    std::vector<float> rowCdf;           // height + 1 values from 0 to 1
    std::vector<float> columnCdf;        // height rows of width + 1 values from 0 to 1
    std::vector<uint16_t> rowGuide;      // entry i: where the search for u in [i, i+1)/height begins
    std::vector<uint16_t> columnGuide;   // the same for each row
    double meanLuminance = 0;            // over the sphere, W/(m^2 sr) as luminance

    bool empty() const { return width == 0; }
};

// `image` is rgba32f, at most 65535 pixels wide and high. A black image gives an empty table.
EnvironmentTable makeEnvironmentTable(const Image& image);

}  // namespace gp
