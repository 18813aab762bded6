// The colour spaces in which people see differences.
#pragma once

#include <glm/glm.hpp>

namespace gp::metrics {

float luminance(glm::vec3 linear);  // Rec. 709

float srgbFromLinear(float linear);  // for 0..1
float linearFromSrgb(float encoded);
glm::vec3 srgbFromLinear(glm::vec3 linear);
glm::vec3 linearFromSrgb(glm::vec3 encoded);

// Relative to white: linear (1, 1, 1) becomes (1, 1, 1).
glm::vec3 relativeXyzFromLinear(glm::vec3 linear);
glm::vec3 linearFromRelativeXyz(glm::vec3 xyz);

// An opponent space that is linear in light, so that filters may be run in it.
glm::vec3 ycxczFromLinear(glm::vec3 linear);
glm::vec3 linearFromYcxcz(glm::vec3 ycxcz);

glm::vec3 labFromLinear(glm::vec3 linear);  // CIE 1976 L*a*b*
// Colours of dark things look paler: chroma is scaled by lightness.
glm::vec3 huntAdjusted(glm::vec3 lab);
// A distance that holds for large differences too.
float hyabDistance(glm::vec3 labA, glm::vec3 labB);

}  // namespace gp::metrics
