// What a backend is: it keeps a scene in its own form, and runs passes over a frame's images.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "frame/denoise.h"
#include "frame/eye_adaptation.h"
#include "frame/frame_images.h"
#include "frame/frame_plan.h"
#include "frame/heat_maps.h"
#include "frame/realtime_images.h"
#include "frame/realtime_plan.h"
#include "frame/scene_motion.h"
#include "scene/cube_map.h"
#include "scene/light_table.h"
#include "scene/scene.h"

namespace gp {

struct RayCounts {
    uint64_t camera = 0, bounce = 0, shadow = 0;
    uint64_t total() const { return camera + bounce + shadow; }
};

// A scene in a backend's own form.
class BackendScene {
public:
    virtual ~BackendScene() = default;
    // Brings it up to date with `scene`; cheap when nothing changed. Throws std::bad_alloc.
    virtual void update(const Scene& scene) = 0;
    virtual uint64_t accelerationBytes() const = 0;
    virtual uint64_t emissiveTriangles() const = 0;
    // The lights under the numbers that its passes use; the same until the next update.
    virtual const LightTable& lights() const = 0;
    // Whether a material reflects by slopes (the model `glint`, the sea).
    virtual bool hasSlopes() const = 0;
};

// One real-time frame, as its passes see it.
struct RealtimeJob {
    const BackendScene& scene;
    const FramePlan& frame;
    const Camera& previousCamera;
    const shared::RealtimeConstants& constants;
    const SceneMotion& motion;
    const RealtimeViews& images;
    HeatViews heat;
};

class Backend {
public:
    virtual ~Backend() = default;
    virtual std::string name() const = 0;  // for people
    virtual std::unique_ptr<BackendScene> newScene() = 0;
    // FramePlan::lightVisibility of a scene and camera; the same for the same plan. It only guides
    // the choice of lights: a wrong one costs noise, never light.
    virtual std::array<float, 3> estimateLightVisibility(const BackendScene& scene,
                                                         const FramePlan& plan) = 0;
    // What rays that leave the scene see, sky geometry and the environment, samples * samples of
    // them a texel, into `cube`, whose size and texels are there.
    virtual void traceSky(const BackendScene& scene, const FramePlan& plan, uint32_t samples,
                          CubeMap& cube) = 0;
    // The path pass, or that of local lighting by plan.mode: adds samples [first, first + count) to
    // every pixel's sums. Tiles not begun when `cancel` turns true are left out.
    virtual RayCounts tracePaths(const BackendScene& scene, const FramePlan& plan, uint32_t first,
                                 uint32_t count, FrameImages& images,
                                 const std::atomic<bool>& cancel) = 0;
    // One pass of a real-time frame, over the whole of its images.
    virtual RayCounts runRealtimePass(const RealtimeJob& job, RealtimePass pass) = 0;
    // The same of a denoiser.
    virtual void runDenoisePass(const RealtimeJob& job, const DenoisePass& pass) = 0;
    // How bright the output of a real-time frame is; a part of its pixels, evenly spread.
    virtual LuminanceHistogram luminanceHistogram(const RealtimeViews& images) = 0;
    // The tone-mapping pass of a real-time frame: `display` from its output.
    virtual void tonemapRealtime(const RealtimeViews& images, float exposureEv, Tonemap tonemap,
                                 std::vector<glm::u8vec4>& display) = 0;
    // The tone-mapping pass: images.display from images.drawn, or images.sums where that is
    // empty.
    virtual void tonemap(float exposureEv, Tonemap tonemap, FrameImages& images) = 0;
    // Rasterised geometry into color or display, in this order; the same bits on any number of
    // threads.
    virtual void rasterize(const DrawImages& images, const std::vector<PlacedDraw>& draws) = 0;
};

struct BackendOptions {
    uint32_t threads = 0;          // 0: all processors
    std::string instructionSet;    // "": the best; "x86-64", "avx2", "avx512"
};

std::unique_ptr<Backend> newCpuBackend(const BackendOptions& options);  // throws std::runtime_error
std::unique_ptr<Backend> newNullBackend();

}  // namespace gp
