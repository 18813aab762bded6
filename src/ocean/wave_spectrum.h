// From settings to waves: which cascade holds which wave numbers, how high each wave is, and the
// moments of the spectrum by themselves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ocean/breaking.h"
#include "ocean/ocean_settings.h"

namespace gp {

// Wave numbers of a cascade, rad/m: from first to end.
struct WaveBand {
    float first;
    float end;
};

WaveBand waveBand(const OceanSettings& settings, uint32_t cascade);

// Waves of one cascade. Bin (ix, iy) is at ix * size + iy; the amplitude of wave vector k is
//   H(k, t) = (cosRe + i cosIm) cos(2 pi turns t) + (sinRe + i sinIm) sin(2 pi turns t),
// and the height sum H e^(i k x). Bins outside the band, and those at the grid's limit, are 0.
struct Waves {
    uint32_t size = 0;
    float length = 0.0f;
    int reach = 0;  // |ix|, |iy| of the farthest bin that is not 0
    std::vector<float> cosRe, cosIm, sinRe, sinIm;  // m
    std::vector<double> turns;                      // a second
};

Waves makeWaves(const OceanSettings& settings, uint32_t cascade);

// Of the displacement's derivatives by these waves, as they are on average over time.
StretchCovariance stretchCovariance(const Waves& waves, float choppiness);

// Variance of the spectrum in bin (mx, my), m^2: its integral over the bin's square, inside of the
// cascade's band.
double waveBinVariance(const OceanSettings& settings, uint32_t cascade, int mx, int my);

// Moments of all waves of a wave number above that of a node: of the height, m^2, and of slopes
// along and across the wind. Nodes are even in the logarithm of k.
struct SpectrumTable {
    struct Node {
        double variance = 0.0, along = 0.0, across = 0.0;
    };
    double firstLog = 0.0, step = 1.0;
    std::vector<Node> nodes;

    Node above(double k) const;
};

SpectrumTable makeSpectrumTable(const OceanSettings& settings);

}  // namespace gp
