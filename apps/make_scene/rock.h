// Rocks, each seed another one.
#pragma once

#include "mesh.h"

namespace gp::make_scene {

// About as large as the unit sphere, a little flatter: 12 n^2 triangles for n subdivisions.
Mesh rock(int subdivisions, std::uint32_t seed);

}  // namespace gp::make_scene
