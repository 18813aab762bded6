#include "metrics/flip_color.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/color.h"
#include "metrics/convolve.h"
#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

constexpr double kPi = std::numbers::pi;

// A Gaussian over frequency, or a sum of two: amplitude a, width b (degrees squared).
struct Sensitivity {
    double a1, b1, a2, b2;
};

// [FLIP 2020, table 1] for the achromatic, red-green and blue-yellow channels.
constexpr Sensitivity kSensitivities[3] = {
    {1.0, 0.0047, 0.0, 1.0e-5}, {1.0, 0.0053, 0.0, 1.0e-5}, {34.1, 0.04, 13.5, 0.025}};

// [FLIP 2020, section 4.1.1] Three standard deviations of the widest of the Gaussians.
int filterRadius(double pixelsPerDegree) {
    double widest = 0;
    for (const Sensitivity& s : kSensitivities) {
        widest = std::max({widest, s.b1, s.b2});
    }
    return static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * kPi * kPi)) *
                                      pixelsPerDegree));
}

double total(const std::vector<double>& weights) {
    double sum = 0;
    for (double w : weights) {
        sum += w;
    }
    return sum;
}

Kernel scaled(const std::vector<double>& weights, double factor) {
    Kernel kernel;
    for (double w : weights) {
        kernel.push_back(static_cast<float>(w * factor));
    }
    return kernel;
}

// The sum of two round Gaussians is not a product of a row and a column, but each of them is.
Plane filterChannel(const Plane& channel, const Sensitivity& s, double pixelsPerDegree) {
    const int radius = filterRadius(pixelsPerDegree);
    // [FLIP 2020, eq. 2] a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
    const double perPixel = kPi * kPi / (pixelsPerDegree * pixelsPerDegree);
    const std::vector<double> g1 = gaussian(radius, perPixel / s.b1);
    const std::vector<double> g2 = gaussian(radius, perPixel / s.b2);
    const double weight1 = s.a1 * std::sqrt(kPi / s.b1);
    const double weight2 = s.a2 * std::sqrt(kPi / s.b2);
    const double sum = weight1 * total(g1) * total(g1) + weight2 * total(g2) * total(g2);
    Plane result = convolve(channel, scaled(g1, weight1 / sum), scaled(g1, 1.0));
    if (weight2 == 0.0) {
        return result;
    }
    const Plane second = convolve(channel, scaled(g2, weight2 / sum), scaled(g2, 1.0));
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        result.pixels[i] += second.pixels[i];
    }
    return result;
}

float huntHyab(glm::vec3 linearA, glm::vec3 linearB) {
    return hyabDistance(huntAdjusted(labFromLinear(linearA)), huntAdjusted(labFromLinear(linearB)));
}

}  // namespace

Picture contrastFiltered(const Picture& ycxcz, double pixelsPerDegree) {
    Picture result(ycxcz.width, ycxcz.height);
    for (int c = 0; c < 3; ++c) {
        Plane channel(ycxcz.width, ycxcz.height);
        for (std::size_t i = 0; i < channel.pixels.size(); ++i) {
            channel.pixels[i] = ycxcz.pixels[i][c];
        }
        const Plane filtered = filterChannel(channel, kSensitivities[c], pixelsPerDegree);
        for (std::size_t i = 0; i < channel.pixels.size(); ++i) {
            result.pixels[i][c] = filtered.pixels[i];
        }
    }
    forEachRow(result.height, [&](int y) {
        for (int x = 0; x < result.width; ++x) {
            const glm::vec3 linear = linearFromYcxcz(result.at(x, y));
            result.at(x, y) = glm::clamp(linear, glm::vec3(0.0f), glm::vec3(1.0f));
        }
    });
    return result;
}

// [FLIP 2020, section 4.1.3, eqs. 4 and 5] The greatest distance, green against blue, becomes 1;
// small errors take up most of the range, since they are what we look for.
float colorError(glm::vec3 linearA, glm::vec3 linearB) {
    constexpr float qc = 0.7f;
    constexpr float pc = 0.4f;
    constexpr float pt = 0.95f;
    static const float largest =
        std::pow(huntHyab(glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)), qc);
    const float knee = pc * largest;
    const float error = std::pow(huntHyab(linearA, linearB), qc);
    if (error < knee) {
        return pt / knee * error;
    }
    return std::min(1.0f, pt + (error - knee) / (largest - knee) * (1.0f - pt));
}

}  // namespace gp::metrics
