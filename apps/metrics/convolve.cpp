#include "metrics/convolve.h"

#include <algorithm>
#include <cmath>

#include "metrics/parallel.h"

namespace gp::metrics {

std::vector<double> gaussian(int radius, double scale) {
    std::vector<double> weights;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::exp(-scale * x * x));
    }
    return weights;
}

namespace {

int radiusOf(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

Plane convolveRows(const Plane& source, const Kernel& kernel) {
    Plane result(source.width, source.height);
    const int radius = radiusOf(kernel);
    forEachRow(source.height, [&](int y) {
        for (int x = 0; x < source.width; ++x) {
            float sum = 0;
            for (int i = -radius; i <= radius; ++i) {
                const int from = std::clamp(x + i, 0, source.width - 1);
                sum += kernel[static_cast<std::size_t>(i + radius)] * source.at(from, y);
            }
            result.at(x, y) = sum;
        }
    });
    return result;
}

// Rows outside, so that memory is read in order.
Plane convolveColumns(const Plane& source, const Kernel& kernel) {
    Plane result(source.width, source.height);
    const int radius = radiusOf(kernel);
    forEachRow(source.height, [&](int y) {
        float* sums = &result.at(0, y);
        for (int i = -radius; i <= radius; ++i) {
            const float weight = kernel[static_cast<std::size_t>(i + radius)];
            const float* row = &source.at(0, std::clamp(y + i, 0, source.height - 1));
            for (int x = 0; x < source.width; ++x) {
                sums[x] += weight * row[x];
            }
        }
    });
    return result;
}

}  // namespace

Plane convolve(const Plane& source, const Kernel& horizontal, const Kernel& vertical) {
    return convolveColumns(convolveRows(source, horizontal), vertical);
}

}  // namespace gp::metrics
