// A whole render: the loop over batches of samples, its limits, its progress.
#pragma once

#include <atomic>
#include <functional>

#include "backend/backend.h"

namespace gp {

struct RenderProgress {
    double fraction = 0;
    double secondsElapsed = 0, secondsRemaining = -1;
    uint32_t samplesPerPixel = 0;
    double raysPerSecond = 0;
    double noise = -1;
};

struct RenderResult {
    RayCounts rays;
    double secondsRender = 0;
    double noise = -1;
    uint32_t samplesPerPixel = 0;  // in the frame now
    bool cancelled = false;
};

// `progress` returns false to stop. Tone maps at the end.
RenderResult renderFrame(Backend& backend, const BackendScene& scene, const FramePlan& plan,
                         FrameImages& images, std::atomic<bool>& cancel,
                         const std::function<bool(const RenderProgress&)>& progress);

}  // namespace gp
