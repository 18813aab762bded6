// The surroundings in which spheres are shown when nobody says otherwise.
#pragma once

#include <vector>

namespace gp::tool {

struct Surroundings {
    unsigned width = 0, height = 0;
    std::vector<float> rgba;  // radiance; latitude and longitude as the library reads them
};

// A photographer's studio: a large key light from the upper left, a strip behind on the right, a
// weak fill and a dim room. A white matte sphere stays below 1.
Surroundings makeStudio();

}  // namespace gp::tool
