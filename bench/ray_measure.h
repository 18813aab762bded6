// The whole renderer and bare Embree over the same rays, in turns.
#pragma once

#include "backend/backend.h"
#include "bench_scene.h"
#include "ray_replay.h"
#include "spread.h"

namespace gp::bench {

struct RaySettings {
    uint32_t samples = 16, recordedSamples = 4, bounces = 2, threads = 0;
    int runs = 3;
    bool diffuse = false;
};

// Renders, records, replays; every rate with its spread. Throws std::runtime_error where the
// picture is black or not finite, or where rays and hits do not add up.
nlohmann::ordered_json measureRays(Backend& backend, const BackendScene& target, const Scene& scene,
                                   const SceneOptions& options, const RaySettings& settings);

}  // namespace gp::bench
