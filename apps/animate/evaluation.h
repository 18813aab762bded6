// Real time against reference, frame by frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "animate/animate_settings.h"
#include "metrics/noisy_reference.h"

namespace gp::tool {

// A lamp that goes out, so that one sees how long its light stays.
struct EvaluationLamp {
    std::array<float, 3> position{};  // metres
    double lumen = 0;
    std::uint32_t offFrame = 0;       // the first frame without it
};

// One way to make the real-time picture.
struct Variant {
    std::string name;                 // for people
    GpRealtimeOptions options{};
};

struct EvaluateSettings {
    AnimateSettings motion;
    std::uint32_t skip = 0;           // frames at the beginning that means leave out
    bool skipGiven = false;
    std::optional<EvaluationLamp> lamp;
    std::vector<Variant> variants;
    // An afterglow below this share of the light counts as gone.
    static constexpr double lagLimit = 0.1;
};

// All of one variant; a number for each frame.
struct VariantResult {
    std::string name;
    // Squares are without the noise of the references, and may be negative.
    std::vector<double> milliseconds, mse, ssim, flip;
    std::vector<double> squaredFlicker;  // from the second frame on
    std::vector<double> afterglow;    // from the frame on in which the lamp is out
    metrics::Picture lastPicture;     // sRGB-encoded, 0..1
    metrics::Plane lastFlip;
};

struct Evaluation {
    std::vector<VariantResult> variants;
    std::vector<metrics::ReferenceNoise> noise;  // of each frame's references
    metrics::Picture lastReference;   // sRGB-encoded, 0..1
    double exposureEv = 0;
    std::string device;
    bool lampShows = true;            // in the reference
};

// Pictures are compared as they are shown: exposed, tone mapped, 8 bits, with textures and all;
// the reference is two pictures of half of the samples. Returns nothing when it was interrupted.
// Throws RunError.
std::optional<Evaluation> evaluateVariants(GpDevice device, const EvaluateSettings& settings);

// The mean of the frames that count; `first` is the number of the first value's frame.
double meanFrom(const std::vector<double>& values, std::uint32_t first, std::uint32_t skip);

// The roots of squares, one by one.
std::vector<double> rootsOf(const std::vector<double>& squares);

}  // namespace gp::tool
