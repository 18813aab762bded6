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

double squaredFlicker(const ErrorPair& error, const ErrorPair& previousError, const Motion* motion,
                      const Plane* previousSeen) {
    const glm::dvec2 sum = sumOverRows<glm::dvec2>(error.a.height, [&](int y) {
        glm::dvec2 row(0.0);  // squares, pixels
        for (int x = 0; x < error.a.width; ++x) {
            glm::vec2 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const std::size_t index = error.a.index(x, y);
            if (motion != nullptr) {
                at += motion->toPrevious.pixels[index];
            }
            const std::optional<float> beforeA = interpolated(previousError.a, at);
            const std::optional<float> beforeB = interpolated(previousError.b, at);
            const bool hidden = motion != nullptr && previousSeen != nullptr && beforeA &&
                                !wasSeen(*motion, *previousSeen, index, at);
            if (beforeA && beforeB && !hidden) {
                const double changeA = double(error.a.pixels[index]) - double(*beforeA);
                const double changeB = double(error.b.pixels[index]) - double(*beforeB);
                row += glm::dvec2(changeA * changeB, 1.0);
            }
        }
        return row;
    });
    return sum.y > 0 ? sum.x / sum.y : 0.0;
}

std::optional<double> afterglow(const ErrorPair& error, const ErrorPair& step) {
    const glm::dvec2 sum = sumOverRows<glm::dvec2>(step.a.height, [&](int y) {
        glm::dvec2 row(0.0);
        for (int x = 0; x < step.a.width; ++x) {
            const double a = step.a.at(x, y);
            const double b = step.b.at(x, y);
            row += glm::dvec2(0.5 * (double(error.a.at(x, y)) * b + double(error.b.at(x, y)) * a),
                              a * b);
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
