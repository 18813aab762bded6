#include "exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gp::tool {

const char* const kExposureRule =
    "Automatic exposure (PNG only; the EV found is printed): bright scenes are darkened until\n"
    "their middle tones are near 0.25, dark ones brightened by at most 6 stops and only until 2 %\n"
    "of the pixels pass white; within about a stop of that a picture is left nearly as it is.\n"
    "Surfaces count four times as much as the surroundings. --exposure 0 shows radiance 1 as\n"
    "(nearly) white.";

namespace {

struct Sample {
    double log2Luminance;
    double weight;
};

constexpr double kTargetKey = 0.25;
constexpr double kSurroundingsWeight = 0.25;

std::vector<Sample> litPixels(const float* rgba, std::size_t count) {
    std::vector<Sample> samples;
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float* p = rgba + 4 * i;
        // [ITU-R BT.709-6, item 3.2]
        const double y = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
        const double coverage = std::clamp(static_cast<double>(p[3]), 0.0, 1.0);
        if (y > 1.0e-12 && std::isfinite(y)) {
            const double weight = kSurroundingsWeight + (1.0 - kSurroundingsWeight) * coverage;
            samples.push_back({std::log2(y), weight});
        }
    }
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
        return a.log2Luminance < b.log2Luminance;
    });
    return samples;
}

// The weighted mean between two quantiles.
double trimmedMean(const std::vector<Sample>& sorted, double low, double high) {
    double total = 0;
    for (const Sample& s : sorted) {
        total += s.weight;
    }
    double before = 0;
    double sum = 0;
    double weights = 0;
    for (const Sample& s : sorted) {
        const double from = std::max(before, low * total);
        const double to = std::min(before + s.weight, high * total);
        before += s.weight;
        if (to > from) {
            sum += (to - from) * s.log2Luminance;
            weights += to - from;
        }
    }
    return sum / weights;
}

// The log2 luminance that 2 % of all pixels pass; black ones count too.
double brightEnd(const std::vector<Sample>& sorted, std::size_t pixelCount) {
    const auto brighter = static_cast<std::size_t>(0.02 * static_cast<double>(pixelCount));
    const std::size_t index = sorted.size() - 1 - std::min(brighter, sorted.size() - 1);
    return sorted[index].log2Luminance;
}

}  // namespace

double automaticExposureEv(const float* rgba, std::size_t pixelCount) {
    const std::vector<Sample> sorted = litPixels(rgba, pixelCount);
    if (sorted.empty()) {
        return 0;
    }
    const double d = trimmedMean(sorted, 0.05, 0.95) - std::log2(kTargetKey);
    const double d4 = d * d * d * d;
    const double correction = -d * d4 / (d4 + 16.0);
    if (correction <= 0) {
        return correction;
    }
    const double untilWhite = std::max(0.0, -brightEnd(sorted, pixelCount));
    return std::min({correction, 6.0, untilWhite});
}

}  // namespace gp::tool
