// What one sees out of doors: a plain with hills behind it.
#pragma once

#include "glb.h"

namespace gp::make_scene {

// Ground at height `y` and ridges from 250 m to 1.6 km away in the direction of -Z, or all round.
void addLandscape(GlbBuilder& glb, float y);

}  // namespace gp::make_scene
