// Every option of a real-time frame, resolved before its first pass.
#pragma once

#include <glm/glm.hpp>

#include "frame/denoise.h"
#include "frame/denoiser_parameters.h"
#include "frame/eye_adaptation.h"
#include "frame/frame_plan.h"

namespace gp {

enum class AntiAliasing : uint32_t { temporal, none, jitter };

enum class LightReuse : uint32_t { none, biased, unbiased };

struct RealtimePlan {
    FramePlan frame;              // size of rays, camera, seed, bounces, exposure, ...
    glm::uvec2 outputSize{0};
    uint32_t mirrorLimit = 4;     // reflections and refractions before the surface that is shown
    AntiAliasing antiAliasing = AntiAliasing::temporal;
    LightReuse lightReuse = LightReuse::none;
    LightReuse indirectReuse = LightReuse::none;
    Denoiser denoiser = Denoiser::asvgf;
    DenoiserParameters parameters;
    bool resetHistory = false;
    bool heatMaps = false;
    float timeStep = 1.0f / 60;   // seconds since the last frame
    EyeAdaptation eye;
};

// A pass that traces or shades; those that filter are in frame/denoise.h.
enum class RealtimePass : uint32_t {
#define X(name, size) name,
#include "frame/realtime_passes.def"
#undef X
    count
};

}  // namespace gp
