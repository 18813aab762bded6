// All metrics of two pictures at once.
#pragma once

#include "metrics/flip.h"

namespace gp::metrics {

enum class PictureKind {
    display,  // PNG, JPEG: 1 is white
    scene     // EXR, HDR: radiance
};

struct Comparison {
    PictureKind kind = PictureKind::display;
    double rmse = 0;    // of linear values
    double relmse = 0;  // of linear values
    double psnr = 0;    // as displayed; infinite for pictures that are displayed alike
    double ssim = 1;    // as displayed
    double flip = 0;
    bool identical = false;  // every pixel has the same value
    glm::dvec3 meanTest{0.0}, meanReference{0.0};
    ExposureRange exposures;  // of HDR-FLIP; 0 to 0 for display pictures
    Plane flipMap;
};

// Both of one size, at least one pixel, all values finite; linear values in both kinds. PSNR and
// SSIM were made for 0..255: they look at sRGB-encoded values. Scene-referred pictures are first
// exposed at the middle of HDR-FLIP's exposures and tone mapped as there.
Comparison comparePictures(const Picture& test, const Picture& reference, PictureKind kind);

}  // namespace gp::metrics
