// Every option of a real-time frame, resolved before its first pass.
#pragma once

#include "frame/frame_plan.h"

namespace gp {

struct RealtimePlan {
    FramePlan frame;              // size of rays, camera, seed, bounces, exposure, ...
    uint32_t mirrorLimit = 4;     // reflections and refractions before the surface that is shown
    bool jitter = true;           // rays move within their pixel from frame to frame
    bool resetHistory = false;
};

// A pass that traces or shades; those that filter are in frame/denoise.h.
enum class RealtimePass : uint32_t {
#define X(name, size) name,
#include "frame/realtime_passes.def"
#undef X
    count
};

}  // namespace gp
