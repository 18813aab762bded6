// From the vertices of a draw to triangles that the hot code can fill.
#pragma once

#include <vector>

#include "backend/cpu/raster_view.h"
#include "frame/draw.h"

namespace gp::cpu {

// Appends what is visible of triangles [first, first + count) of `placed`, in their order;
// `draw` is the number that they get.
void setUpTriangles(const PlacedDraw& placed, uint32_t draw, size_t first, size_t count,
                    std::vector<RasterTriangle>& triangles);

// The state of a draw; it points into the draw's texture. `display`: into such an image.
RasterDraw rasterDraw(const PlacedDraw& placed, bool display);

}  // namespace gp::cpu
