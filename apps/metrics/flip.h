// FLIP: how different two pictures look when one is shown after the other in the same place.
//
// Based on: Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", HPG 2020 (below [FLIP 2020]); Andersson, Nilsson, Shirley,
// Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021
// short papers ([FLIP 2021]).
#pragma once

#include "metrics/picture.h"

namespace gp::metrics {

// [FLIP 2020, section 3] A monitor 0.7 m wide of 3840 pixels, seen from 0.7 m:
// 0.7 * (3840 / 0.7) * pi / 180.
inline constexpr double kPixelsPerDegree = 67.0206432765823;

struct FlipResult {
    Plane map;        // per pixel: 0 (the same) .. 1
    double mean = 0;  // of the map: the number that is quoted
};

// Of display-referred pictures, linear values 0..1.
FlipResult ldrFlip(const Picture& test, const Picture& reference,
                   double pixelsPerDegree = kPixelsPerDegree);

// Exposures in stops over which an HDR picture is looked at.
struct ExposureRange {
    double start = 0, stop = 0;
    int count = 2;  // evenly spaced, both ends included

    double middle() const { return 0.5 * (start + stop); }
};

// From the darkest exposure, at which the brightest pixel is not yet white, to that at which the
// median is bright.
ExposureRange exposureRange(const Picture& reference);

// The tone map of [FLIP 2021], ACES as fitted by Narkowicz 2015; clipped to 0..1.
glm::vec3 acesTonemap(glm::vec3 exposed);

// Of scene-referred pictures: at each pixel the largest LDR-FLIP of all exposures.
FlipResult hdrFlip(const Picture& test, const Picture& reference,
                   double pixelsPerDegree = kPixelsPerDegree);

}  // namespace gp::metrics
