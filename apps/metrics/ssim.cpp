#include "metrics/ssim.h"

#include <algorithm>

#include "metrics/convolve.h"
#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

// [Wang 2004, section III.C] 11 x 11 Gaussian of standard deviation 1.5, K1 = 0.01, K2 = 0.03.
constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;
// Products of two noisy references may come out as negative variances, which must not bring a
// denominator near zero. More than rounding, so that one reference without noise is left alone.
constexpr double kLeastVariance = -0.25 * kC2;

Kernel window() {
    const std::vector<double> weights = gaussian(kRadius, 1.0 / (2.0 * kSigma * kSigma));
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

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        result.pixels[i] = a.pixels[i] * b.pixels[i];
    }
    return result;
}

Plane mean(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        result.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
    }
    return result;
}

}  // namespace

double ssim(const Plane& a, const Plane& b) {
    return ssim(a, b, b);
}

double ssim(const Plane& test, const Plane& referenceA, const Plane& referenceB) {
    const Kernel kernel = window();
    const Plane reference = mean(referenceA, referenceB);
    const Plane meanT = convolve(test, kernel, kernel);
    const Plane meanA = convolve(referenceA, kernel, kernel);
    const Plane meanB = convolve(referenceB, kernel, kernel);
    const Plane meanTt = convolve(product(test, test), kernel, kernel);
    const Plane meanAb = convolve(product(referenceA, referenceB), kernel, kernel);
    const Plane meanTr = convolve(product(test, reference), kernel, kernel);
    const bool fits = test.width > 2 * kRadius && test.height > 2 * kRadius;
    const int border = fits ? kRadius : 0;
    const int rows = test.height - 2 * border;
    const int columns = test.width - 2 * border;
    const double sum = sumOverRows<double>(rows, [&](int row) {
        double rowSum = 0;
        for (int column = 0; column < columns; ++column) {
            const std::size_t i = test.index(column + border, row + border);
            const double mt = meanT.pixels[i];
            const double mr = 0.5 * (double(meanA.pixels[i]) + double(meanB.pixels[i]));
            const double mrmr = double(meanA.pixels[i]) * double(meanB.pixels[i]);
            const double varianceT = meanTt.pixels[i] - mt * mt;
            const double varianceR = std::max(meanAb.pixels[i] - mrmr, kLeastVariance);
            const double covariance = meanTr.pixels[i] - mt * mr;
            // [Wang 2004, eq. 13]
            rowSum += ((2 * mt * mr + kC1) * (2 * covariance + kC2)) /
                      ((mt * mt + mrmr + kC1) * (varianceT + varianceR + kC2));
        }
        return rowSum;
    });
    return sum / (static_cast<double>(rows) * static_cast<double>(columns));
}

}  // namespace gp::metrics
