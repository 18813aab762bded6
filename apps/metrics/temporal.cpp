#include "metrics/temporal.h"

#include <algorithm>
#include <cmath>

#include "metrics/parallel.h"

namespace gp::metrics {
namespace {

// Depths agree when they differ by no more than the surface's own slope over a pixel and a half,
// and a hundredth for what is curved or far away.
constexpr float kSlopePixels = 1.5f;
constexpr float kDepthTolerance = 0.01f;

// The centre of pixel (x, y) lies at (x + 0.5, y + 0.5); null where `at` is outside.
std::optional<float> interpolated(const Plane& plane, glm::vec2 at) {
    if (!(at.x >= 0 && at.y >= 0 && at.x <= static_cast<float>(plane.width) &&
          at.y <= static_cast<float>(plane.height))) {
        return std::nullopt;
    }
    const glm::vec2 corner = at - 0.5f;
    const glm::vec2 whole = glm::floor(corner);
    const glm::vec2 part = corner - whole;
    const auto pixel = [&](int dx, int dy) {
        const int x = std::clamp(static_cast<int>(whole.x) + dx, 0, plane.width - 1);
        const int y = std::clamp(static_cast<int>(whole.y) + dy, 0, plane.height - 1);
        return plane.at(x, y);
    };
    return glm::mix(glm::mix(pixel(0, 0), pixel(1, 0), part.x),
                    glm::mix(pixel(0, 1), pixel(1, 1), part.x), part.y);
}

bool wasSeen(const Motion& motion, const Plane& previousSeen, std::size_t index, glm::vec2 at) {
    const int x = std::clamp(static_cast<int>(at.x), 0, previousSeen.width - 1);
    const int y = std::clamp(static_cast<int>(at.y), 0, previousSeen.height - 1);
    const float expected = motion.previousDepth.pixels[index];
    const float difference = std::abs(previousSeen.at(x, y) - expected);
    return difference <= kSlopePixels * motion.slope.pixels[index] + kDepthTolerance * expected;
}

}  // namespace

double flicker(const Plane& error, const Plane& previousError, const Motion* motion,
               const Plane* previousSeen) {
    const glm::dvec2 sum = sumOverRows<glm::dvec2>(error.height, [&](int y) {
        glm::dvec2 row(0.0);  // squares, pixels
        for (int x = 0; x < error.width; ++x) {
            glm::vec2 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const std::size_t index = error.index(x, y);
            if (motion != nullptr) {
                at += motion->toPrevious.pixels[index];
            }
            const std::optional<float> before = interpolated(previousError, at);
            const bool hidden = motion != nullptr && previousSeen != nullptr && before &&
                                !wasSeen(*motion, *previousSeen, index, at);
            if (before && !hidden) {
                const double change = double(error.pixels[index]) - double(*before);
                row += glm::dvec2(change * change, 1.0);
            }
        }
        return row;
    });
    return sum.y > 0 ? std::sqrt(sum.x / sum.y) : 0.0;
}

std::optional<double> afterglow(const Plane& error, const Plane& step) {
    const glm::dvec2 sum = sumOverRows<glm::dvec2>(step.height, [&](int y) {
        glm::dvec2 row(0.0);
        for (int x = 0; x < step.width; ++x) {
            const double s = step.at(x, y);
            row += glm::dvec2(double(error.at(x, y)) * s, s * s);
        }
        return row;
    });
    if (!(sum.y > 0)) {
        return std::nullopt;
    }
    return sum.x / sum.y;
}

std::optional<std::size_t> lagFrames(std::span<const double> afterglow, double limit) {
    std::size_t frames = afterglow.size();
    while (frames > 0 && std::abs(afterglow[frames - 1]) < limit) {
        --frames;
    }
    if (frames == afterglow.size()) {
        return std::nullopt;
    }
    return frames;
}

}  // namespace gp::metrics
