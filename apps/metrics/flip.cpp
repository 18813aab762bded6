#include "metrics/flip.h"

#include <algorithm>
#include <cmath>

#include "metrics/color.h"
#include "metrics/flip_color.h"
#include "metrics/flip_features.h"
#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

struct Seen {  // what FLIP needs of each of the two pictures
    Picture filtered;
    Features features;
};

Seen look(const Picture& linear, double pixelsPerDegree) {
    Picture ycxcz(linear.width, linear.height);
    Plane brightness(linear.width, linear.height);
    forEachRow(linear.height, [&](int y) {
        for (int x = 0; x < linear.width; ++x) {
            const glm::vec3 opponent = ycxczFromLinear(linear.at(x, y));
            ycxcz.at(x, y) = opponent;
            brightness.at(x, y) = (opponent.x + 16.0f) / 116.0f;
        }
    });
    return {contrastFiltered(ycxcz, pixelsPerDegree), detectFeatures(brightness, pixelsPerDegree)};
}

}  // namespace

FlipResult ldrFlip(const Picture& test, const Picture& reference, double pixelsPerDegree) {
    const Seen a = look(test, pixelsPerDegree);
    const Seen b = look(reference, pixelsPerDegree);
    FlipResult result;
    result.map = Plane(test.width, test.height);
    const double sum = sumOverRows<double>(test.height, [&](int y) {
        double rowSum = 0;
        for (int x = 0; x < test.width; ++x) {
            const float color = colorError(a.filtered.at(x, y), b.filtered.at(x, y));
            const float feature =
                featureError(a.features.edges.at(x, y), b.features.edges.at(x, y),
                             a.features.points.at(x, y), b.features.points.at(x, y));
            // [FLIP 2020, eq. 8] A feature that differs makes a difference of colour worse.
            const float error = std::pow(color, 1.0f - std::min(feature, 1.0f));
            result.map.at(x, y) = color > 0.0f ? error : 0.0f;
            rowSum += result.map.at(x, y);
        }
        return rowSum;
    });
    result.mean = sum / static_cast<double>(result.map.pixels.size());
    return result;
}

}  // namespace gp::metrics
