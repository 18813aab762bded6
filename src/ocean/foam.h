// Foam of one cascade: where the water is squeezed so much that it breaks, fading afterwards. It is
// a function of time alone, not of the frames that were shown: what is remembered are Jacobians at
// fixed ticks of time, which can be computed at any moment.
// Foam is the chance of breaking given the waves of the cascade (breaking.h). What the others do is
// another thing at each tick: the trace that is expected of ticks is that of independent events,
// and so of about the same mean in all cascades.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "ocean/wave_kernels.h"

namespace gp {

class Foam {
public:
    explicit Foam(const OceanSettings& settings);

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
    Tick& tickOf(int64_t number) {
        return history_[size_t(((number % ticks) + ticks) % ticks)];
    }
    std::array<Tick, ticks> history_;
    int64_t gathered_ = INT64_MIN;
    std::vector<float> trace_;  // of all ticks up to the gathered one, as is expected then
};

}  // namespace gp
