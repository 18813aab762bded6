#include "metrics/pixel_errors.h"

#include <cmath>

#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

template <class PixelValue>
glm::dvec3 meanOver(const Picture& picture, const PixelValue& value) {
    const glm::dvec3 sum = sumOverRows<glm::dvec3>(picture.height, [&](int y) {
        glm::dvec3 rowSum(0.0);
        for (int x = 0; x < picture.width; ++x) {
            rowSum += value(x, y);
        }
        return rowSum;
    });
    return sum / static_cast<double>(picture.pixels.size());
}

double meanOfChannels(glm::dvec3 v) {
    return (v.x + v.y + v.z) / 3.0;
}

}  // namespace

glm::dvec3 meanColor(const Picture& picture) {
    return meanOver(picture, [&](int x, int y) { return glm::dvec3(picture.at(x, y)); });
}

double meanSquaredError(const Picture& a, const Picture& b) {
    return meanSquaredError(a, b, b);
}

double meanSquaredError(const Picture& test, const Picture& a, const Picture& b) {
    return meanOfChannels(meanOver(test, [&](int x, int y) {
        const glm::dvec3 t(test.at(x, y));
        return (t - glm::dvec3(a.at(x, y))) * (t - glm::dvec3(b.at(x, y)));
    }));
}

// [Rousselle et al. 2011, Adaptive Sampling and Reconstruction using Greedy Error Minimization,
// section 6]
double relativeMse(const Picture& test, const Picture& reference) {
    return meanOfChannels(meanOver(test, [&](int x, int y) {
        const glm::dvec3 r(reference.at(x, y));
        const glm::dvec3 d = glm::dvec3(test.at(x, y)) - r;
        return d * d / (r * r + kRelativeMseEpsilon);
    }));
}

double psnr(double meanSquaredError) {
    return -10.0 * std::log10(meanSquaredError);
}

}  // namespace gp::metrics
