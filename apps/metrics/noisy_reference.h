// Comparing with references that are noisy themselves. A reference comes as two pictures of the
// same light with noise of their own; products of the errors against both have, on average, no
// noise of the references in them, so that few paths a pixel say as much as many.
#pragma once

#include "metrics/flip.h"
#include "metrics/temporal.h"

namespace gp::metrics {

// Display pictures: linear values of 0..1.
struct ReferencePair {
    Picture a, b;

    Picture mean() const;
};

struct NoisyComparison {
    double mse = 0;   // of linear values, without the references' noise: it may be negative
    double ssim = 1;  // of sRGB-encoded luma; without the noise of the references
    FlipResult flip;  // against the mean of the references, whose noise is in it
};

NoisyComparison compareWithPair(const Picture& test, const ReferencePair& reference);

// What value(test) - value(reference) is at each pixel, for both references.
template <class Value>
ErrorPair errorsOf(const Picture& test, const ReferencePair& reference, const Value& value) {
    ErrorPair errors{Plane(test.width, test.height), Plane(test.width, test.height)};
    for (std::size_t i = 0; i < test.pixels.size(); ++i) {
        const float shown = value(test.pixels[i]);
        errors.a.pixels[i] = shown - value(reference.a.pixels[i]);
        errors.b.pixels[i] = shown - value(reference.b.pixels[i]);
    }
    return errors;
}

// What is wrong with the references: the deviation of the noise of their mean, and how alike the
// two are. Numbers like these would stand in a comparison with a single noisy reference.
struct ReferenceNoise {
    double rmse = 0, ssim = 1;
};
ReferenceNoise noiseOf(const ReferencePair& reference);

// 0..1, of linear colour: what SSIM and flicker look at.
float shownLuma(const glm::vec3& linear);

// The square root of a mean of squares that may have come out negative: 0 then.
double rootOf(double meanSquare);

}  // namespace gp::metrics
