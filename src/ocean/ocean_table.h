// The sea as the hot code reads it: plain addresses into what an Ocean holds.
#pragma once

#include <cstdint>

#include "ocean/ocean_settings.h"
#include "ocean/slope_node.h"

namespace gp {

struct CascadeTable {
    float perLength = 0.0f;               // 1 / metres of a side
    float perTexel = 0.0f, texel = 0.0f;  // 1 / metres between points, and these
    uint32_t size = 0, levels = 0;        // points along it; of the pyramid
    const OceanPoint* points = nullptr;   // size * size and one more, rows of y
    const SlopeNode* nodes = nullptr;     // of all levels from 1 on: slopeNodeIndex
};

struct OceanTable {
    CascadeTable cascades[oceanMostCascades];
    uint32_t count = 0;
    // What foam of all cascades is, over the product of that of each. Each is the chance of foam
    // given one cascade alone, and their means are nearly the same: given all, it is the mean times
    // what each changes it by, if they are independent.
    float foamScale = 0.0f;
};

}  // namespace gp
