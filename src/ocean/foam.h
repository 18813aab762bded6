// Foam of one cascade: where the water is squeezed so much that it breaks, fading afterwards. It is
// a function of time alone, not of the frames that were shown: what is remembered are Jacobians at
// fixed ticks of time, which can be computed at any moment.
// Based on: Dupuy and Bruneton 2012, "Real-time Animation and Rendering of Ocean Whitecaps": foam
// is the chance that the Jacobian is below a threshold, given what is known of it. Here the other
// cascades are what is not known.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "ocean/wave_kernels.h"

namespace gp {

class Foam {
public:
    // others: standard deviation of the Jacobian by the waves of all other cascades.
    Foam(const OceanSettings& settings, float others);

    // Fills `codes` with the squeeze codes at a time, s.
    using Squeeze = std::function<void(double seconds, uint16_t* codes)>;
    // Writes OceanPoint::foam at a time; codes are those of that time. Ticks that are not known
    // yet, up to 16, are asked for.
    void update(double seconds, const uint16_t* codes, OceanPoint* points, const Squeeze& squeeze);

private:
    // Traces older than 16 / 3 decay times are below half a percent, and forgotten.
    static constexpr int ticks = 16;
    static constexpr double ticksPerDecay = 3.0;

    bool remember(int64_t now, double tick, const Squeeze& squeeze);
    void gather(int64_t now);

    size_t count_;
    double decay_;
    std::array<float, squeezeCodes> share_;  // of the surface that breaks, by code
    struct Tick {
        int64_t number = INT64_MIN;
        std::vector<uint16_t> codes;
    };
    std::array<Tick, ticks> history_;
    int64_t gathered_ = INT64_MIN;
    std::vector<float> trace_;  // of all ticks up to the gathered one, as it is then
};

}  // namespace gp
