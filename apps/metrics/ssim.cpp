#include "metrics/ssim.h"

#include "metrics/convolve.h"
#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

// [Wang 2004, section III.C] 11 x 11 Gaussian of standard deviation 1.5, K1 = 0.01, K2 = 0.03.
constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

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

}  // namespace

double ssim(const Plane& a, const Plane& b) {
    const Kernel kernel = window();
    const Plane meanA = convolve(a, kernel, kernel);
    const Plane meanB = convolve(b, kernel, kernel);
    const Plane meanAa = convolve(product(a, a), kernel, kernel);
    const Plane meanBb = convolve(product(b, b), kernel, kernel);
    const Plane meanAb = convolve(product(a, b), kernel, kernel);
    const bool fits = a.width > 2 * kRadius && a.height > 2 * kRadius;
    const int border = fits ? kRadius : 0;
    const int rows = a.height - 2 * border;
    const int columns = a.width - 2 * border;
    const double sum = sumOverRows<double>(rows, [&](int row) {
        double rowSum = 0;
        for (int column = 0; column < columns; ++column) {
            const std::size_t i = a.index(column + border, row + border);
            const double ma = meanA.pixels[i];
            const double mb = meanB.pixels[i];
            const double varianceA = meanAa.pixels[i] - ma * ma;
            const double varianceB = meanBb.pixels[i] - mb * mb;
            const double covariance = meanAb.pixels[i] - ma * mb;
            // [Wang 2004, eq. 13]
            rowSum += ((2 * ma * mb + kC1) * (2 * covariance + kC2)) /
                      ((ma * ma + mb * mb + kC1) * (varianceA + varianceB + kC2));
        }
        return rowSum;
    });
    return sum / (static_cast<double>(rows) * static_cast<double>(columns));
}

}  // namespace gp::metrics
