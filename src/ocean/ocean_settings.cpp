#include "ocean/ocean_settings.h"

#include <fmt/format.h>

namespace gp {

namespace {

std::string numberFault(const char* field, float value, float least, float most) {
    if (value >= least && value <= most) return {};
    return fmt::format("{} is {}, not {}..{}", field, value, least, most);
}

// Infinite depth is deep water; a NaN is at least nothing.
std::string depthFault(float depth) {
    if (depth >= 0.01f) return {};
    return fmt::format("depth is {}, not 0.01 or more", depth);
}

std::string cascadeFault(const OceanSettings& s) {
    if (s.size < 32 || s.size > 1024 || (s.size & (s.size - 1)) != 0) {
        return fmt::format("size is {}, not a power of two from 32 to 1024", s.size);
    }
    if (s.cascades < 1 || s.cascades > oceanMostCascades) {
        return fmt::format("cascades is {}, not 1..{}", s.cascades, oceanMostCascades);
    }
    for (uint32_t i = 0; i < s.cascades; ++i) {
        const std::string name = fmt::format("lengths[{}]", i);
        if (auto fault = numberFault(name.c_str(), s.lengths[i], 0.01f, 1.0e5f); !fault.empty()) {
            return fault;
        }
        // Each ends where the next begins, which its grid must still resolve: no gap.
        const float least = 6.0f * s.lengths[i] / float(s.size - 1u);
        if (i + 1 < s.cascades
            && !(s.lengths[i + 1] >= least && s.lengths[i + 1] < 0.9f * s.lengths[i])) {
            return fmt::format("lengths[{}] is {}, not {} to {}: between 6 / (size - 1) and 0.9 of "
                               "the one before it", i + 1, s.lengths[i + 1], least,
                               0.9f * s.lengths[i]);
        }
    }
    return {};
}

}  // namespace

std::string oceanFault(const OceanSettings& s) {
    const std::string faults[] = {
        numberFault("windSpeed", s.windSpeed, 0.0f, 100.0f),
        numberFault("windDirection", s.windDirection, -1.0e3f, 1.0e3f),
        numberFault("fetch", s.fetch, 1.0f, 1.0e8f),
        depthFault(s.depth),
        numberFault("gravity", s.gravity, 0.1f, 100.0f),
        numberFault("swell", s.swell, 0.0f, 1.0f),
        numberFault("amplitude", s.amplitude, 0.0f, 10.0f),
        numberFault("choppiness", s.choppiness, 0.0f, 2.0f),
        numberFault("foamThreshold", s.foamThreshold, 0.0f, 1.0f),
        s.foamDecay == 0.0f ? "" : numberFault("foamDecay", s.foamDecay, 0.01f, 60.0f),
        s.spectrum <= OceanSpectrum::piersonMoskowitz
            ? "" : fmt::format("spectrum is {}, which is none", int(s.spectrum)),
        s.spreading <= OceanSpreading::cosineSquared
            ? "" : fmt::format("spreading is {}, which is none", int(s.spreading)),
        cascadeFault(s),
    };
    for (const std::string& fault : faults) {
        if (!fault.empty()) return fault;
    }
    return {};
}

}  // namespace gp
