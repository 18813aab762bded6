// The second half of FLIP: edges and points that one picture has and the other has not.
#pragma once

#include "metrics/picture.h"

namespace gp::metrics {

struct Features {
    Plane edges, points;  // strengths, >= 0
};

// `brightness`: the relative luminance of the unfiltered picture, 0..1.
Features detectFeatures(const Plane& brightness, double pixelsPerDegree);

// From the strengths at one pixel of two pictures to a difference of 0..1.
float featureError(float edgeA, float edgeB, float pointA, float pointB);

}  // namespace gp::metrics
