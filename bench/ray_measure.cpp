#include "ray_measure.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "backend/cpu/cpu_backend.h"
#include "frame/render.h"

namespace gp::bench {
namespace {

using Json = nlohmann::ordered_json;

// A benchmark of a broken renderer is worth nothing.
void checkPicture(const FrameImages& images) {
    double sum = 0;
    for (const PixelSums& s : images.sums)
        sum += double(s.color.x) + double(s.color.y) + double(s.color.z);
    if (!std::isfinite(sum) || sum <= 0)
        throw std::runtime_error("the picture is black or not finite");
}

FramePlan planOf(const RaySettings& s, const Scene& scene, const SceneOptions& options) {
    FramePlan plan;
    plan.width = options.width, plan.height = options.height;
    plan.camera = chooseCamera(scene, options);
    plan.samplesPerPixel = s.samples;
    plan.maxBounces = s.bounces;
    plan.shading = s.diffuse ? ShadingMode::diffuse : ShadingMode::full;
    return plan;
}

struct Rendered {
    RayCounts rays;
    double seconds, coreSeconds;
};

Rendered render(Backend& backend, const BackendScene& scene, const FramePlan& plan) {
    FrameImages images;
    images.width = plan.width, images.height = plan.height;
    std::atomic<bool> cancel{false};
    const std::function<bool(const RenderProgress&)> silent;
    const Stopwatch watch;
    const RenderResult result = renderFrame(backend, scene, plan, images, cancel, silent);
    const double core = watch.core();
    checkPicture(images);
    return {result.rays, result.secondsRender, core};
}

// One thread, whole samples: the rays of the render, in its own order and proportions.
RecordedRays record(const Scene& scene, FramePlan plan, uint32_t samples) {
    cpu::CpuBackend backend({1, ""});
    const auto target = backend.newScene();
    target->update(scene);
    plan.samplesPerPixel = samples;
    // Each surface sends at most one bounce ray and one shadow ray.
    const size_t capacity = size_t(plan.width) * plan.height * samples * (plan.maxBounces + 2);
    RecordedRays recorded;
    cpu::RayRecorder recorder{};
    recorder.capacity = capacity;
    for (size_t kind = 0; kind < rayKinds; ++kind) {
        recorded.rays[kind].resize(capacity);
        recorder.rays[kind] = recorded.rays[kind].data();
    }
    backend.setRecorder(&recorder);
    const RayCounts counts = render(backend, *target, plan).rays;
    const uint64_t wanted[rayKinds] = {counts.camera, counts.bounce, counts.shadow};
    for (size_t kind = 0; kind < rayKinds; ++kind) {
        if (recorder.count[kind] != wanted[kind])
            throw std::runtime_error(fmt::format("{} of {} {} rays were recorded",
                                                 recorder.count[kind], wanted[kind],
                                                 rayKindNames[kind]));
        recorded.rays[kind].resize(recorder.count[kind]);
        recorded.rays[kind].shrink_to_fit();
    }
    return recorded;
}

// Mrays/s by the wall's clock; the last three by the seconds that threads computed.
struct Measured {
    Spread renderer, mixed, ratio, packets;
    Spread rendererCore, mixedCore, ratioCore;
    std::array<Spread, rayKinds> embree;
    std::array<double, rayKinds> met{};
    RayCounts rays;  // of one render
};

void measureOnce(Backend& backend, const cpu::CpuScene& scene, const FramePlan& plan,
                 const RecordedRays& recorded, tbb::task_arena& arena, Measured& m) {
    const Rendered rendered = render(backend, scene, plan);
    m.rays = rendered.rays;
    m.renderer.add(double(m.rays.total()) / rendered.seconds * 1e-6);
    m.rendererCore.add(double(m.rays.total()) / rendered.coreSeconds * 1e-6);
    Replay all;
    for (size_t kind = 0; kind < rayKinds; ++kind) {
        const auto& rays = recorded.rays[kind];
        if (rays.empty()) continue;
        const Replay r = replay(scene.view(), RayKind(kind), rays, arena);
        all.seconds += r.seconds, all.coreSeconds += r.coreSeconds;
        m.embree[kind].add(double(rays.size()) / r.seconds * 1e-6);
        m.met[kind] = double(r.met) / double(rays.size());
    }
    m.mixed.add(double(recorded.total()) / all.seconds * 1e-6);
    m.mixedCore.add(double(recorded.total()) / all.coreSeconds * 1e-6);
    m.ratio.add(m.renderer.last() / m.mixed.last());
    m.ratioCore.add(m.rendererCore.last() / m.mixedCore.last());
    const auto& camera = recorded.rays[cameraRays];
    const Replay p = replayPackets(scene.view(), camera, arena);
    m.packets.add(double(camera.size()) / p.seconds * 1e-6);
    // Packets and single rays must see the same scene; along edges they may round differently.
    if (std::abs(double(p.met) / double(camera.size()) - m.met[cameraRays]) > 1e-3)
        throw std::runtime_error("packets and single rays disagree about what they met");
}

Json report(const Measured& m, const RecordedRays& recorded) {
    Json json;
    json["rays"] = {{"camera", m.rays.camera}, {"bounce", m.rays.bounce},
                    {"shadow", m.rays.shadow}, {"total", m.rays.total()}};
    json["rays_replayed"] = recorded.total();
    json["renderer_mrays_per_second"] = m.renderer.json();
    for (size_t kind = 0; kind < rayKinds; ++kind)
        if (!recorded.rays[kind].empty()) {
            json["embree_mrays_per_second"][rayKindNames[kind]] = m.embree[kind].json();
            json["part_that_met_something"][rayKindNames[kind]] = m.met[kind];
        }
    json["embree_mrays_per_second"]["mixed"] = m.mixed.json();
    json["embree_mrays_per_second"]["camera_packets"] = m.packets.json();
    json["ratio"] = m.ratio.json();
    json["renderer_mrays_per_core_second"] = m.rendererCore.json();
    json["embree_mrays_per_core_second"] = m.mixedCore.json();
    json["ratio_of_core_seconds"] = m.ratioCore.json();
    return json;
}

}  // namespace

Json measureRays(Backend& backend, const BackendScene& target, const Scene& scene,
                 const SceneOptions& options, const RaySettings& settings) {
    const FramePlan plan = planOf(settings, scene, options);
    const RecordedRays recorded = record(scene, plan, settings.recordedSamples);
    tbb::task_arena arena{int(settings.threads)};
    Measured m;
    for (int i = 0; i < settings.runs; ++i)
        measureOnce(backend, static_cast<const cpu::CpuScene&>(target), plan, recorded, arena, m);
    return report(m, recorded);
}

}  // namespace gp::bench
