#pragma once

#include <vector>

#include <tbb/task_arena.h>

#include "backend/cpu/raster_view.h"
#include "frame/draw.h"

namespace gp::cpu {

// Backend::rasterize. Rows are shared out in bands, and each band draws all that touches it in the
// order of submission: no pixel has two writers, and the number of threads changes nothing.
void rasterizeDraws(const RasterKernels& kernels, tbb::task_arena& arena, const DrawImages& images,
                    const std::vector<PlacedDraw>& draws);

}  // namespace gp::cpu
