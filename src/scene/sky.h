// The built-in clear sky: an environment image and a sun that belong together.
#pragma once

#include "scene/scene.h"

namespace gp {

// Radians; azimuth from -Z towards +X, elevation 0..pi/2. sunLux 0: by elevation. Adds the sun to
// `scene.lights` (replacing an earlier sky's) and sets `scene.environment`. Throws std::bad_alloc;
// the scene is then unchanged.
void setSky(Scene& scene, float sunAzimuth, float sunElevation, float sunLux);

// Takes the sun of an earlier setSky away, if there is one.
void removeSkySun(Scene& scene);

// A camera that shows everything: from the front, a little from above.
Camera frameScene(const Scene& scene, float aspect);

}  // namespace gp
