// The inside of an Ocean; ocean.cpp computes it, ocean_read.cpp and ocean_maps.cpp read it.
#pragma once

#include <cstdlib>
#include <memory>
#include <vector>

#include "ocean/foam.h"
#include "ocean/ocean.h"
#include "ocean/slope_pyramid.h"
#include "ocean/wave_kernels.h"

namespace gp {

struct OceanCascade {
    struct Free {
        void operator()(float* p) const { std::free(p); }
    };

    OceanCascade(const OceanSettings& settings, uint32_t cascade);

    const OceanPoint& point(int ix, int iy) const {
        const uint32_t n = waves.size;
        return points[size_t(uint32_t(iy) & (n - 1)) * n + (uint32_t(ix) & (n - 1))];
    }

    Waves waves;
    std::unique_ptr<float, Free> between;  // of WaveTask
    std::vector<OceanPoint> points;        // rows of y, and one that is only read along with others
    BreakingLaw breaking;                  // of these waves; Parts sets it
    std::vector<uint16_t> squeeze;
    Foam foam;
    SlopePyramid slopes;
};

struct Ocean::Parts {
    explicit Parts(const OceanSettings& settings);

    void update(double seconds);
    // One cascade at one time: its points, or only the codes of breaking.
    void transform(OceanCascade& cascade, double when, uint16_t* squeeze, bool squeezeOnly);

    OceanSettings settings;
    const WaveKernels& kernels;
    std::unique_ptr<void, void (*)(void*)> plan;
    SpectrumTable spectrum;
    std::vector<OceanCascade> cascades;
    OceanTable table;                      // of what stands in the cascades
    double time = 0.0;
};

}  // namespace gp
