// The denoisers' kernels on the CPU: rows of one pass, compiled for each instruction set.
#pragma once

#include "frame/denoise.h"
#include "shared/realtime_structs.h"

namespace gp {
struct Camera;
}

namespace gp::cpu {

// Rows [y0, y1) of a pass. Any number of threads, each with rows of its own.
struct DenoiseJob {
    const RealtimeViews* images;
    const shared::RealtimeConstants* constants;
    const Camera* camera;
    const Camera* previousCamera;  // `camera` where has_previous is 0
    int32_t parameter;
    int32_t y0, y1;
};

struct DenoiseKernels {
    void (*plain[denoiseKernelCount])(const DenoiseJob&);  // pixel by pixel, for comparison
    void (*run[denoiseKernelCount])(const DenoiseJob&);    // the same, as fast as there is
};

namespace denoise {
extern const DenoiseKernels kernelsX86_64, kernelsAvx2, kernelsAvx512;
}

}  // namespace gp::cpu
