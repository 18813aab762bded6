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

// The same against what two references are noisy pictures of, each with noise of its own: mean
// values and variances of the reference are products of the two, so that its noise, which is none
// of the test picture's fault, has no part in them. (Variances that come out clearly negative are
// cut, which makes the number a little smaller.)
double ssim(const Plane& test, const Plane& referenceA, const Plane& referenceB);

}  // namespace gp::metrics
