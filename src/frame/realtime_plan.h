// Every option of a real-time frame, resolved before its first pass.
#pragma once

#include <glm/glm.hpp>

#include "frame/frame_plan.h"

namespace gp {

enum class AntiAliasing : uint32_t { temporal, none, jitter };

struct RealtimePlan {
    FramePlan frame;              // size of rays, camera, seed, bounces, exposure, ...
    glm::uvec2 outputSize{0};
    uint32_t mirrorLimit = 4;     // reflections and refractions before the surface that is shown
    AntiAliasing antiAliasing = AntiAliasing::temporal;
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
