#pragma once

#include <pmmintrin.h>
#include <tbb/task_arena.h>
#include <xmmintrin.h>

#include "backend/cpu/cpu_scene.h"
#include "backend/cpu/denoise_kernels.h"
#include "backend/cpu/raster_view.h"

namespace gp::cpu {

// The scene as a render shows it: with the plan's sky in its environment's place.
SceneView viewFor(const BackendScene& scene, const FramePlan& plan);

// What a render is, for the kernels; `view` by viewFor.
shared::FrameConstants frameConstants(const SceneView& view, const FramePlan& plan);

// Embree wants both set on every thread that traces.
struct DenormalsOff {
    unsigned before = _mm_getcsr();
    DenormalsOff() {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~DenormalsOff() { _mm_setcsr(before); }
};

class CpuBackend final : public Backend {
public:
    explicit CpuBackend(const BackendOptions& options);

    std::string name() const override;
    std::unique_ptr<BackendScene> newScene() override;
    std::array<float, 3> estimateLightVisibility(const BackendScene& scene,
                                                 const FramePlan& plan) override;
    void traceSky(const BackendScene& scene, const FramePlan& plan, uint32_t samples,
                  CubeMap& cube) override;
    RayCounts tracePaths(const BackendScene& scene, const FramePlan& plan, uint32_t first,
                         uint32_t count, FrameImages& images,
                         const std::atomic<bool>& cancel) override;
    RayCounts runRealtimePass(const RealtimeJob& job, RealtimePass pass) override;
    void runDenoisePass(const RealtimeJob& job, const DenoisePass& pass) override;
    LuminanceHistogram luminanceHistogram(const RealtimeViews& images) override;
    void tonemapRealtime(const RealtimeViews& images, float exposureEv, Tonemap tonemap,
                         std::vector<glm::u8vec4>& display) override;
    void tonemap(float exposureEv, Tonemap tonemap, FrameImages& images) override;
    void rasterize(const DrawImages& images, const std::vector<PlacedDraw>& draws) override;

    // For the benchmark: rays are noted here as they are traced; one thread only. Null: no more.
    void setRecorder(RayRecorder* recorder) { recorder_ = recorder; }

private:
    const IsaKernels& kernels_;
    const LocalKernels& localKernels_;
    const RealtimeKernels& realtimeKernels_;
    const DenoiseKernels& denoiseKernels_;
    const RasterKernels& rasterKernels_;
    uint32_t threads_;
    tbb::task_arena arena_;
    std::atomic<int64_t> embreeBytes_{0};  // before the device, which reports to it to its end
    DevicePtr device_;
    RayRecorder* recorder_ = nullptr;
};

}  // namespace gp::cpu
