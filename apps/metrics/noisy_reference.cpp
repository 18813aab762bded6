#include "metrics/noisy_reference.h"

#include <algorithm>
#include <cmath>

#include "metrics/color.h"
#include "metrics/pixel_errors.h"
#include "metrics/ssim.h"

namespace gp::metrics {
namespace {

Plane lumaOf(const Picture& linear) {
    Plane plane(linear.width, linear.height);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i) {
        plane.pixels[i] = shownLuma(linear.pixels[i]);
    }
    return plane;
}

}  // namespace

Picture ReferencePair::mean() const {
    Picture picture = a;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
    }
    return picture;
}

float shownLuma(const glm::vec3& linear) {
    return luminance(srgbFromLinear(linear));
}

NoisyComparison compareWithPair(const Picture& test, const ReferencePair& reference) {
    NoisyComparison c;
    c.mse = meanSquaredError(test, reference.a, reference.b);
    c.ssim = ssim(lumaOf(test), lumaOf(reference.a), lumaOf(reference.b));
    c.flip = ldrFlip(test, reference.mean());
    return c;
}

ReferenceNoise noiseOf(const ReferencePair& reference) {
    // The difference of two has twice the variance of one, their mean half of it.
    return {0.5 * std::sqrt(meanSquaredError(reference.a, reference.b)),
            ssim(lumaOf(reference.a), lumaOf(reference.b))};
}

double rootOf(double meanSquare) {
    return std::sqrt(std::max(meanSquare, 0.0));
}

}  // namespace gp::metrics
