// SSIM: how alike the structure of two pictures is.
//
// Based on: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004 ([Wang 2004]).
#pragma once

#include "metrics/picture.h"

namespace gp::metrics {

// Of grey pictures with values 0..1. 1: identical; can be slightly negative. The mean over all
// windows that lie wholly inside; a picture smaller than one window is extended at its border.
double ssim(const Plane& a, const Plane& b);

}  // namespace gp::metrics
