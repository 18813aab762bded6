// The metrics that look at each pixel by itself.
#pragma once

#include "metrics/picture.h"

namespace gp::metrics {

// Keeps the error of dark pixels finite; in squared units of the pictures.
inline constexpr double kRelativeMseEpsilon = 0.01;

glm::dvec3 meanColor(const Picture& picture);
// The mean over all pixels and channels of (a - b)^2.
double meanSquaredError(const Picture& a, const Picture& b);
// ... of (test - a) (test - b): the mean squared error against what `a` and `b` are noisy pictures
// of, if their noise is independent of each other; on average exactly, so it can be negative.
double meanSquaredError(const Picture& test, const Picture& a, const Picture& b);
// ... of (test - reference)^2 / (reference^2 + kRelativeMseEpsilon).
double relativeMse(const Picture& test, const Picture& reference);
// Decibels for signals of 0..1; infinite when the error is 0.
double psnr(double meanSquaredError);

}  // namespace gp::metrics
