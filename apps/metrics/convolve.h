// Convolution with symmetric-width kernels that are a product of a row and a column.
#pragma once

#include "metrics/picture.h"

#include <vector>

namespace gp::metrics {

// 2 * radius + 1 weights, from -radius to +radius.
using Kernel = std::vector<float>;

// exp(-scale x^2) for x = -radius..radius, not normalised.
std::vector<double> gaussian(int radius, double scale);

// Sums w(dx, dy) = horizontal[dx] * vertical[dy] times the pixel there; beyond the border the
// nearest pixel counts, so that a uniform picture stays uniform.
Plane convolve(const Plane& source, const Kernel& horizontal, const Kernel& vertical);

}  // namespace gp::metrics
