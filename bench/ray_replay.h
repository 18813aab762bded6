// The rays of a render once more, by bare Embree: what the renderer's rate is measured against.
#pragma once

#include <array>
#include <vector>

#include <tbb/task_arena.h>

#include "backend/cpu/scene_view.h"

namespace gp::bench {

enum RayKind { cameraRays, bounceRays, shadowRays, rayKinds };
constexpr std::array<const char*, rayKinds> rayKindNames{"camera", "bounce", "shadow"};

struct RecordedRays {
    std::array<std::vector<cpu::RecordedRay>, rayKinds> rays;
    uint64_t total() const { return rays[0].size() + rays[1].size() + rays[2].size(); }
};

struct Replay {
    double seconds = 0, coreSeconds = 0;
    uint64_t met = 0;  // rays that met something (closest), or anything (shadow)
};

// One after the other by rtcIntersect1 (shadow rays: rtcOccluded1), on the threads of `arena`. The
// scene's own filter runs for transparent surfaces, as it does in the render.
Replay replay(const cpu::SceneView& view, RayKind kind, const std::vector<cpu::RecordedRay>& rays,
              tbb::task_arena& arena);

// Camera rays as coherent packets of 16 where the processor has AVX-512, else of 8.
Replay replayPackets(const cpu::SceneView& view, const std::vector<cpu::RecordedRay>& rays,
                     tbb::task_arena& arena);

}  // namespace gp::bench
