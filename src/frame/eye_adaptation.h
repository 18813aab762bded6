// The exposure that follows what a real-time frame shows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace gp {

constexpr uint32_t exposureBins = 64;
using LuminanceHistogram = std::array<uint32_t, exposureBins>;

struct EyeAdaptation {
    float seconds = 0;              // 0: off
    float evMin = -10, evMax = 10;  // of the exposure that is found
};

// The exposure, in stops, at which the mean of the middle tones is a middle grey. The darkest half
// and the brightest 5 % do not count: what is black stays black, and lamps may glare. 0 for a
// picture without light.
float exposureEvFor(const LuminanceHistogram& histogram, const EyeAdaptation& eye);

// What the eye has got used to.
class Eye {
public:
    void reset() { ev_.reset(); }
    // One frame, `seconds` after the last: its exposure. The first is met at once.
    float see(const LuminanceHistogram& histogram, const EyeAdaptation& eye, float seconds);

private:
    std::optional<float> ev_;
};

}  // namespace gp
