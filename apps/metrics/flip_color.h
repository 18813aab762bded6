// The first half of FLIP: differences of colour, as blurred as the eye sees them.
#pragma once

#include "metrics/picture.h"

namespace gp::metrics {

// What the contrast sensitivity of the eye leaves of a picture; Y Cx Cz in, linear RGB 0..1 out.
Picture contrastFiltered(const Picture& ycxcz, double pixelsPerDegree);

// From two filtered colours to an error of 0..1.
float colorError(glm::vec3 linearA, glm::vec3 linearB);

}  // namespace gp::metrics
