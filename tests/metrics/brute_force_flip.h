// LDR-FLIP once more, from the text of the paper: whole two-dimensional kernels, doubles, and the
// rounded sRGB matrix of the standard. Slow, and written without a look at the fast one.
#pragma once

#include "metrics/picture.h"

namespace gp::metrics {

std::vector<double> bruteForceFlip(const Picture& a, const Picture& b, double pixelsPerDegree);

// The colour half of it for two colours that fill the picture.
double bruteForceColorError(glm::dvec3 a, glm::dvec3 b);

}  // namespace gp::metrics
