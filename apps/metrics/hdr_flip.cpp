#include "metrics/flip.h"

#include <algorithm>
#include <cmath>

#include "metrics/color.h"
#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

// (k0 x^2 + k1 x) / (k2 x^2 + k3 x + k4)
struct TonemapCurve {
    double k0, k1, k2, k3, k4;
};

// [Narkowicz 2015, ACES Filmic Tone Mapping Curve], with x scaled by 0.6 as in [FLIP 2021].
constexpr TonemapCurve kAces = {0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14};

// The x at which the curve reaches y: the positive root of a quadratic.
double inverseAces(double y) {
    const double a = kAces.k0 - y * kAces.k2;
    const double b = kAces.k1 - y * kAces.k3;
    const double c = -y * kAces.k4;
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

float aces(float value) {
    const double x = std::max(0.0f, value);
    const double y = (kAces.k0 * x * x + kAces.k1 * x) /
                     (kAces.k2 * x * x + kAces.k3 * x + kAces.k4);
    return static_cast<float>(std::clamp(y, 0.0, 1.0));
}

Picture tonemapped(const Picture& picture, double exposure) {
    Picture result(picture.width, picture.height);
    const auto scale = static_cast<float>(std::exp2(exposure));
    forEachRow(picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            result.at(x, y) = acesTonemap(picture.at(x, y) * scale);
        }
    });
    return result;
}

// The mean of the two middle values where there is no single one.
float median(std::vector<float>& values) {
    const std::size_t half = values.size() / 2;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half),
                     values.end());
    const float upper = values[half];
    if (values.size() % 2 == 1) {
        return upper;
    }
    const float lower =
        *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half));
    return 0.5f * (lower + upper);
}

}  // namespace

glm::vec3 acesTonemap(glm::vec3 exposed) {
    return {aces(exposed.x), aces(exposed.y), aces(exposed.z)};
}

// [FLIP 2021, section 3.1] Both ends bring a luminance to 0.85 of white: first the largest of the
// reference, last its median.
ExposureRange exposureRange(const Picture& reference) {
    std::vector<float> luminances;
    luminances.reserve(reference.pixels.size());
    for (const glm::vec3& pixel : reference.pixels) {
        luminances.push_back(luminance(pixel));
    }
    // A picture half black would ask for an infinite exposure.
    constexpr double tiny = 1.0e-6;
    const double brightest = *std::max_element(luminances.begin(), luminances.end());
    const double middle = median(luminances);
    const double bright = inverseAces(0.85);
    ExposureRange range;
    range.start = std::log2(bright / std::max(brightest, tiny));
    range.stop = std::log2(bright / std::max(middle, tiny));
    range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
    return range;
}

FlipResult hdrFlip(const Picture& test, const Picture& reference, double pixelsPerDegree) {
    const ExposureRange range = exposureRange(reference);
    FlipResult result;
    result.map = Plane(test.width, test.height);
    for (int i = 0; i < range.count; ++i) {
        const double exposure = range.start + (range.stop - range.start) * i / (range.count - 1);
        const FlipResult one = ldrFlip(tonemapped(test, exposure),
                                       tonemapped(reference, exposure), pixelsPerDegree);
        for (std::size_t p = 0; p < result.map.pixels.size(); ++p) {
            result.map.pixels[p] = std::max(result.map.pixels[p], one.map.pixels[p]);
        }
    }
    double sum = 0;
    for (float error : result.map.pixels) {
        sum += error;
    }
    result.mean = sum / static_cast<double>(result.map.pixels.size());
    return result;
}

}  // namespace gp::metrics
