#include "metrics/flip_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/convolve.h"
#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

// [FLIP 2020, section 4.2.1] Positive weights sum to 1 and negative ones to -1, so that a step
// from black to white gives an edge of strength 1.
Kernel balanced(const std::vector<double>& weights) {
    double positive = 0;
    double negative = 0;
    for (double w : weights) {
        (w > 0 ? positive : negative) += std::abs(w);
    }
    Kernel kernel;
    for (double w : weights) {
        kernel.push_back(static_cast<float>(w > 0 ? w / positive : w / negative));
    }
    return kernel;
}

Kernel normalised(const std::vector<double>& weights) {
    double sum = 0;
    for (double w : weights) {
        sum += w;
    }
    Kernel kernel;
    for (double w : weights) {
        kernel.push_back(static_cast<float>(w / sum));
    }
    return kernel;
}

// The length of (detector along x, detector along y) at each pixel. The two-dimensional kernels
// are derivative in one direction times Gaussian in the other, so they separate.
Plane gradientLength(const Plane& brightness, const Kernel& detector, const Kernel& smoother) {
    Plane result = convolve(brightness, detector, smoother);
    const Plane vertical = convolve(brightness, smoother, detector);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        result.pixels[i] = std::hypot(result.pixels[i], vertical.pixels[i]);
    }
    return result;
}

}  // namespace

Features detectFeatures(const Plane& brightness, double pixelsPerDegree) {
    // [FLIP 2020, section 4.2.1] The width of the features that the eye detects, in degrees.
    constexpr double width = 0.082;
    const double sigma = 0.5 * width * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const std::vector<double> smooth = gaussian(radius, 1.0 / (2.0 * sigma * sigma));
    std::vector<double> edge = smooth;
    std::vector<double> point = smooth;
    for (int x = -radius; x <= radius; ++x) {
        const auto i = static_cast<std::size_t>(x + radius);
        edge[i] *= -x;
        point[i] *= x * x / (sigma * sigma) - 1.0;
    }
    Features features;
    features.edges = gradientLength(brightness, balanced(edge), normalised(smooth));
    features.points = gradientLength(brightness, balanced(point), normalised(smooth));
    return features;
}

float featureError(float edgeA, float edgeB, float pointA, float pointB) {
    // [FLIP 2020, eq. 7] with q_f = 0.5.
    const float difference = std::max(std::abs(edgeA - edgeB), std::abs(pointA - pointB));
    return std::sqrt(difference / std::numbers::sqrt2_v<float>);
}

}  // namespace gp::metrics
