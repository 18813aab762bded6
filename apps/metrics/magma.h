// The colour map of error pictures: black, purple, orange, pale yellow; brightness rises evenly.
#pragma once

#include <glm/glm.hpp>

namespace gp::metrics {

glm::vec3 magmaSrgb(float t);  // t in 0..1; sRGB-encoded

}  // namespace gp::metrics
