// The hot code of the sea, once for each instruction set (isa/): from waves to the surface by
// inverse FFTs, several columns or rows at once, one in each lane of a vector; and what a pixel
// reads of it.
#pragma once

#include <cstdint>

#include "ocean/breaking.h"
#include "ocean/ocean_table.h"
#include "ocean/wave_spectrum.h"

namespace gp {

// What one cascade's transform reads and writes. Tasks are size / lanes groups of neighbouring
// columns, all of them, then as many groups of rows; each may run on any thread.
struct WaveTask {
    const Waves* waves = nullptr;
    const void* plan = nullptr;   // by WaveKernels::newPlan
    float* between = nullptr;     // 8 size * size floats at a multiple of 64 bytes, 0 at first
    double seconds = 0.0;
    float choppiness = 1.0f;
    bool squeezeOnly = false;     // only `squeeze` is wanted: half of the fields
    OceanPoint* points = nullptr; // size * size, rows of y; foam stays as it is
    BreakingLaw breaking;
    uint16_t* squeeze = nullptr;  // size * size breakingMargins as codes
};

// Margins from -squeezeMost to squeezeMost in 1,024 steps, for tables of foam.
constexpr float squeezeMost = 6.0f;
constexpr int squeezeCodes = 1024;

struct WaveKernels {
    const char* name;
    uint32_t lanes;
    void* (*newPlan)(uint32_t size);  // size: a power of two from 32 on
    void (*freePlan)(void* plan);
    void (*columns)(const WaveTask& task, uint32_t group);
    void (*rows)(const WaveTask& task, uint32_t group);
    OceanSlopes (*slopes)(const OceanTable& table, glm::vec2 rest, glm::vec2 d0, glm::vec2 d1);
};

namespace waves {
extern const WaveKernels kernelsX86_64;
extern const WaveKernels kernelsAvx2;
extern const WaveKernels kernelsAvx512;
}  // namespace waves

// The widest that this processor has.
const WaveKernels& waveKernels();

}  // namespace gp
