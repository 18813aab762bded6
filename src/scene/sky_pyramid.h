// What surrounds a scene, as a cube of all directions at every level of detail: light from a part
// of the sphere is one look at the level whose texels are as large.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/cube_map.h"

namespace gp {

// Six faces of (size + 2)^2 texels: each has a border of the texels beyond its edges, so that
// bilinear reading needs no other face.
struct SkyLevel {
    uint32_t size = 0;
    std::vector<glm::vec3> texels;  // faces, rows, pixels; W/(m^2 sr)
};

struct SkyPyramid {
    std::vector<SkyLevel> levels;  // the finest first, the last of size 1; means by solid angle
    SkyLevel irradiance;           // over pi, by the normal: what a white matte surface sends back
};

// Of faces whose size is a power of two, 1..2^11. On TBB's threads.
SkyPyramid makeSkyPyramid(const CubeMap& cube);

}  // namespace gp
