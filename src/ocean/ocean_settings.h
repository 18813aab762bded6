// What a sea is made from: wind, place and the grids that it is computed on.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace gp {

enum class OceanSpectrum : uint8_t {
    jonswap,           // a wind sea of limited fetch over deep water
    tma,               // the same over water of limited depth
    phillips,          // Tessendorf's form, scaled to Phillips' equilibrium range; no fetch
    piersonMoskowitz,  // fully developed: the wind has blown for long and from far; no fetch
};

enum class OceanSpreading : uint8_t {
    hasselmann,      // |cos(theta / 2)|^2s
    donelanBanner,  // sech^2(beta theta), narrower at high frequencies
    cosineSquared,  // cos^2(theta) on the side downwind, as in Tessendorf's |k w|^2
};

constexpr uint32_t oceanMostCascades = 4;

// The frame: x and y horizontal, z up, metres and seconds. Ranges are checked by oceanFault.
struct OceanSettings {
    float windSpeed = 10.0f;     // m/s, 10 m above the water, 0..100; 0: a flat sea
    float windDirection = 0.0f;  // radians from +x to +y, to where it blows, -1000..1000
    float fetch = 100.0e3f;      // m over which the wind has blown, 1..1e8
    float depth = std::numeric_limits<float>::infinity();  // m, 0.01 or more
    float gravity = 9.81f;       // m/s^2, 0.1..100
    uint32_t seed = 1;           // of the waves' phases and amplitudes
    OceanSpectrum spectrum = OceanSpectrum::jonswap;
    OceanSpreading spreading = OceanSpreading::hasselmann;
    float swell = 0.0f;          // 0..1, narrows directions as waves from far away are
    float amplitude = 1.0f;      // scale of all heights, 0..10; 1: as the spectrum says
    float choppiness = 1.0f;     // scale of horizontal displacement, 0..2
    // Each cascade is a periodic square of size x size points. Its waves are those that the coarser
    // one leaves: from 3 periods in its length on. The last goes to its grid's limit.
    uint32_t size = 256;         // a power of two, 32..1024
    uint32_t cascades = 3;       // 1..oceanMostCascades
    // m, each 6 / (size - 1) to 0.9 of the one before it, 0.01..1e5
    std::array<float, oceanMostCascades> lengths = {701.0f, 61.3f, 5.23f, 0.0f};
    // Foam is where horizontal displacement squeezes the surface to less than this share.
    float foamThreshold = 0.55f;  // of the Jacobian, 0..1; 0: only where the surface folds over
    float foamDecay = 2.0f;       // s in which it fades to 1 / e, 0.01..60; 0: no trace stays
};

// Empty, or what is wrong: the field, its value and its range, as "depth is 0, not above 0".
std::string oceanFault(const OceanSettings& settings);

}  // namespace gp
