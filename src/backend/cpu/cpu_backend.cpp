// The CPU backend: Embree for rays, oneTBB for threads, one instruction set for the whole device.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/rasterizer.h"
#include "scene/bsdf_settings.h"
#include "scene/sea.h"
#include "scene/sky_pyramid.h"
#include "scene/water_light.h"
#include "shading/shading.h"

namespace gp::cpu {

extern const IsaKernels kernelsX86_64, kernelsAvx2, kernelsAvx512;
namespace local {
extern const LocalKernels kernelsX86_64, kernelsAvx2, kernelsAvx512;
}
namespace realtime {
extern const RealtimeKernels kernelsX86_64, kernelsAvx2, kernelsAvx512;
}
namespace raster {
extern const RasterKernels kernelsX86_64, kernelsAvx2, kernelsAvx512;
}

namespace {

constexpr uint32_t tileSize = 8;

struct InstructionSet {
    const IsaKernels* kernels;
    const LocalKernels* localKernels;
    const RealtimeKernels* realtimeKernels;
    const DenoiseKernels* denoiseKernels;
    const RasterKernels* rasterKernels;
    const char* embreeName;
    bool here;  // this processor has it
};

std::vector<InstructionSet> instructionSets() {
    __builtin_cpu_init();
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi2");
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512vl");
    return {{&kernelsAvx512, &local::kernelsAvx512, &realtime::kernelsAvx512,
             &denoise::kernelsAvx512, &raster::kernelsAvx512, "avx512", avx512},
            {&kernelsAvx2, &local::kernelsAvx2, &realtime::kernelsAvx2, &denoise::kernelsAvx2,
             &raster::kernelsAvx2, "avx2", avx2},
            {&kernelsX86_64, &local::kernelsX86_64, &realtime::kernelsX86_64,
             &denoise::kernelsX86_64, &raster::kernelsX86_64, "sse2", true}};
}

InstructionSet chooseInstructionSet(const std::string& wanted) {
    for (const InstructionSet& set : instructionSets()) {
        if (wanted.empty() && set.here) return set;
        if (wanted != set.kernels->name) continue;
        if (!set.here)
            throw std::runtime_error(fmt::format("this processor has no {} instructions", wanted));
        return set;
    }
    throw std::runtime_error(fmt::format(
        "unknown instruction set \"{}\": x86-64, avx2 and avx512 are there", wanted));
}

uint32_t filterOf(PixelFilter filter) {
    switch (filter) {
        case PixelFilter::box: return FILTER_BOX;
        case PixelFilter::tent: return FILTER_TENT;
        case PixelFilter::gaussian: return FILTER_GAUSSIAN;
        default: return FILTER_BLACKMAN_HARRIS;
    }
}

}  // namespace

SceneView viewFor(const BackendScene& scene, const FramePlan& plan) {
    SceneView view = static_cast<const CpuScene&>(scene).view();
    if (plan.sky) showEnvironment(view, plan.sky.get(), glm::vec3(1));
    return view;
}

// What kernels know of the sea beside its surface. Local lighting and plain-diffuse pictures show
// its surface alone.
static void setWater(shared::FrameConstants& f, const SceneView& view, const FramePlan& plan) {
    f.water_level = -std::numeric_limits<float>::max();
    f.water_ior = 1.333f;
    if (!view.sea || plan.mode == FrameMode::local || plan.shading == ShadingMode::diffuse) return;
    const SeaSettings& sea = view.sea->settings();
    f.water_attenuation = seaAttenuation(sea);
    f.water_level = sea.level, f.water_ior = sea.ior;
    if (view.sea->isBelow(plan.camera)) f.water |= WATER_CAMERA;
    if (plan.mode == FrameMode::realtime) f.water |= WATER_BENDS;
    // Wider than the waves: a guide that is narrower than what it guides to would miss some of it,
    // which then comes seldom and bright. The least is what ocean_surface.glsl adds to any cone.
    constexpr float wider = 2, least = 1.5e-4f;
    const OceanMoments waves = view.sea->ocean().momentsAbove(0);
    f.water_var_x = wider * waves.xx + least, f.water_var_y = wider * waves.yy + least;
    f.water_cov = wider * waves.xy;
    f.water_guided = view.directionalLights ? 0.5f : 0.0f;
    const EnvironmentView& sky = view.environment;
    const WaterLight light =
        waterLight(sea, view.lights, view.directionalLights,
                   {sky.rowMeans, sky.rowMeans ? sky.height : 0, view.environmentColor});
    f.water_radiance = light.radiance, f.water_stretch = light.stretch;
}

shared::FrameConstants frameConstants(const SceneView& view, const FramePlan& plan) {
    shared::FrameConstants f{};
    f.width = plan.width, f.height = plan.height;
    f.seed = uint32_t(plan.seed) ^ (uint32_t(plan.seed >> 32) * 0x9E3779B9u);
    f.max_bounces = plan.maxBounces;
    f.diffuse_shading = plan.shading == ShadingMode::diffuse;
    f.russian_roulette = plan.russianRoulette;
    f.pixel_filter = filterOf(plan.pixelFilter), f.pixel_filter_radius = plan.pixelFilterRadius;
    f.clamp_indirect = plan.clampIndirect;
    f.directional_lights = view.directionalLights;
    f.tree_nodes = view.lightTreeNodes;
    f.environment_visibility = plan.lightVisibility[0];
    f.directional_visibility = plan.lightVisibility[1];
    f.tree_visibility = plan.lightVisibility[2];
    f.only_environment = view.lightCount == 0;
    f.environment_power = view.environmentPower;
    f.environment_color = view.environmentColor;
    f.environment_cos = view.environmentCos, f.environment_sin = view.environmentSin;
    f.environment_cells = view.environment.side;
    f.last_by_lights = plan.lastByLights;
    f.ray_length = plan.rayLength;
    if (plan.sky) f.sky = (view.sky ? SKY_TRACED : 0u) | (plan.skyDrawn ? SKY_DRAWN : 0u);
    if (plan.hideBackground) f.sky |= SKY_HIDDEN;
    f.sky_viewer = plan.skyViewer;
    f.background_color = view.backgroundColor;
    f.background_image = view.background.side != 0;
    setWater(f, view, plan);
    return f;
}

namespace {

static_assert(FREQUENCY_VERTEX == uint32_t(ShadingFrequency::vertex) &&
              FREQUENCY_TRIANGLE == uint32_t(ShadingFrequency::triangle) &&
              FALLOFF_INVERSE == uint32_t(Falloff::inverse) &&
              FALLOFF_NONE == uint32_t(Falloff::none) &&
              NDF_FILTER_DEFERRED == uint32_t(NdfFilter::deferred));

shared::LocalLightingConstants localConstants(const CpuScene& scene, const SceneView& view,
                                              const FramePlan& plan) {
    shared::LocalLightingConstants c{};
    c.ambient = plan.local.ambient;
    if (plan.surroundings) {
        c.sky_nodes = plan.local.environmentNodes;
        const float finest = float(plan.surroundings->levels.front().size);
        c.sky_texel = 4.0f / (finest * finest);
    } else {
        c.ambient += view.environmentMean;
    }
    c.sky_mean = view.environmentMean;
    c.frequency = uint32_t(plan.local.frequency);
    c.falloff = uint32_t(plan.local.falloff);
    c.lamps = view.lightCount - uint32_t(scene.emissiveTriangles());
    c.replaces_materials = plan.local.model != nullptr;
    c.ndf_filter = uint32_t(plan.local.ndfFilter);
    c.parallel_view = plan.camera.kind == CameraKind::orthographic;
    return c;
}

SkyPyramidView skyPyramidView(const SkyPyramid& sky) {
    const auto viewOf = [](const SkyLevel& level) {
        return SkyLevelView{level.texels.data(), level.size};
    };
    SkyPyramidView view{};
    view.levelCount = uint32_t(sky.levels.size());
    for (size_t i = 0; i < sky.levels.size(); ++i) view.levels[i] = viewOf(sky.levels[i]);
    view.irradiance = viewOf(sky.irradiance);
    return view;
}

}  // namespace

CpuBackend::CpuBackend(const BackendOptions& options)
    : kernels_(*chooseInstructionSet(options.instructionSet).kernels),
      localKernels_(*chooseInstructionSet(options.instructionSet).localKernels),
      realtimeKernels_(*chooseInstructionSet(options.instructionSet).realtimeKernels),
      denoiseKernels_(*chooseInstructionSet(options.instructionSet).denoiseKernels),
      rasterKernels_(*chooseInstructionSet(options.instructionSet).rasterKernels),
      threads_(options.threads ? options.threads
                               : std::max(1u, std::thread::hardware_concurrency())),
      arena_(int(threads_)) {
    const InstructionSet set = chooseInstructionSet(options.instructionSet);
    const std::string config = options.instructionSet.empty()
        ? "set_affinity=0" : fmt::format("set_affinity=0,isa={}", set.embreeName);
    device_.reset(rtcNewDevice(config.c_str()));
    if (!device_) throw std::runtime_error("Embree could not make a device");
    rtcSetDeviceMemoryMonitorFunction(device_.get(), [](void* bytes, ssize_t change, bool) {
        *static_cast<std::atomic<int64_t>*>(bytes) += change;
        return true;
    }, &embreeBytes_);
}

std::string CpuBackend::name() const {
    const long version = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_VERSION);
    return fmt::format("CPU (Embree {}.{}.{}, {}, {} thread{})", version / 10000,
                       version / 100 % 100, version % 100, kernels_.name, threads_,
                       threads_ == 1 ? "" : "s");
}

std::unique_ptr<BackendScene> CpuBackend::newScene() {
    return std::make_unique<CpuScene>(device_.get(), kernels_, embreeBytes_, arena_);
}

// A picture of a few thousand pixels, whose shadow rays are counted. In one thread and in order, so
// that the result has the same bits everywhere.
std::array<float, 3> CpuBackend::estimateLightVisibility(const BackendScene& scene,
                                                         const FramePlan& plan) {
    const SceneView view = viewFor(scene, plan);
    if (view.lightCount == 0) return {1, 1, 1};
    FramePlan small = plan;
    const double scale = std::sqrt(2048.0 / (double(plan.width) * plan.height));
    small.width = std::max(1u, uint32_t(std::lround(scale * plan.width)));
    small.height = std::max(1u, uint32_t(std::lround(scale * plan.height)));
    small.seed = plan.seed + 0x5EED;
    small.lightVisibility = {1, 1, 1};
    const shared::FrameConstants frame = frameConstants(view, small);
    std::vector<PixelSums> sums(size_t(small.width) * small.height);
    double sent[3] = {}, arrived[3] = {};
    const DenormalsOff denormalsOff;
    for (uint32_t y = 0; y < small.height; y += tileSize)
        for (uint32_t x = 0; x < small.width; x += tileSize) {
            const TileJob job{&view, &frame, &plan.camera, sums.data(), x, y,
                              std::min(x + tileSize, small.width),
                              std::min(y + tileSize, small.height), 0, 1, nullptr};
            const TileCounts c = kernels_.traceTile(job);
            for (int i = 0; i < 3; ++i) sent[i] += c.lightSent[i], arrived[i] += c.lightArrived[i];
        }
    std::array<float, 3> visibility;
    // Never trusted to be nothing: what was hidden from a few thousand rays may still matter.
    for (size_t i = 0; i < 3; ++i) {
        const double share = sent[i] > 0 ? arrived[i] / sent[i] : 1.0;
        visibility[i] = share > 0.02 ? float(std::min(share, 1.0)) : 0.02f;
    }
    return visibility;
}

void CpuBackend::traceSky(const BackendScene& scene, const FramePlan& plan, uint32_t samples,
                          CubeMap& cube) {
    const SceneView view = viewFor(scene, plan);
    shared::FrameConstants frame = frameConstants(view, plan);
    frame.sky = view.sky ? SKY_TRACED : 0u;
    arena_.execute([&] {
        tbb::parallel_for(0u, 6 * cube.size, [&](uint32_t i) {
            const DenormalsOff denormalsOff;
            kernels_.traceSkyRow({&view, &frame, i / cube.size, i % cube.size, cube.size, samples,
                                  &cube.texels[size_t(i) * cube.size]});
        });
    });
}

RayCounts CpuBackend::tracePaths(const BackendScene& scene, const FramePlan& plan, uint32_t first,
                                 uint32_t count, FrameImages& images,
                                 const std::atomic<bool>& cancel) {
    const SceneView view = viewFor(scene, plan);
    const shared::FrameConstants frame = frameConstants(view, plan);
    const bool isLocal = plan.mode == FrameMode::local;
    const auto local = localConstants(static_cast<const CpuScene&>(scene), view, plan);
    shading::BsdfParams model{};
    if (plan.local.model) model = bsdfParamsFrom(*plan.local.model);
    SkyPyramidView sky{};
    if (plan.surroundings) sky = skyPyramidView(*plan.surroundings);
    const uint32_t tilesX = (plan.width + tileSize - 1) / tileSize;
    const uint32_t tilesY = (plan.height + tileSize - 1) / tileSize;
    tbb::combinable<RayCounts> counts;
    arena_.execute([&] {
        tbb::parallel_for(0u, tilesX * tilesY, [&](uint32_t tile) {
            if (cancel.load(std::memory_order_relaxed)) return;
            const DenormalsOff denormalsOff;
            TileJob job{};
            job.scene = &view, job.frame = &frame, job.camera = &plan.camera,
            job.sums = images.sums.data();
            job.x0 = tile % tilesX * tileSize, job.y0 = tile / tilesX * tileSize;
            job.x1 = std::min(job.x0 + tileSize, plan.width),
            job.y1 = std::min(job.y0 + tileSize, plan.height);
            job.firstSample = first, job.sampleCount = count;
            job.recorder = recorder_;
            const TileCounts c = isLocal ? localKernels_.lightTile({job, &local, &model, &sky})
                                         : kernels_.traceTile(job);
            RayCounts& sum = counts.local();
            sum.camera += c.camera, sum.bounce += c.bounce, sum.shadow += c.shadow;
        }, tbb::simple_partitioner());
    });
    return counts.combine([](RayCounts a, const RayCounts& b) {
        return RayCounts{a.camera + b.camera, a.bounce + b.bounce, a.shadow + b.shadow};
    });
}

void CpuBackend::tonemap(float exposureEv, Tonemap tonemap, FrameImages& images) {
    images.display.resize(images.pixelCount());
    constexpr size_t run = 4096;
    arena_.execute([&] {
        tbb::parallel_for(size_t(0), (images.pixelCount() + run - 1) / run, [&](size_t i) {
            const size_t begin = i * run, n = std::min(run, images.pixelCount() - begin);
            if (images.drawn.empty())
                kernels_.tonemap(&images.sums[begin], &images.display[begin], n, exposureEv,
                                 uint32_t(tonemap));
            else
                rasterKernels_.tonemapColors(&images.drawn[begin], &images.display[begin], n,
                                             exposureEv, uint32_t(tonemap));
        });
    });
}

void CpuBackend::rasterize(const DrawImages& images, const std::vector<PlacedDraw>& draws) {
    rasterizeDraws(rasterKernels_, arena_, images, draws);
}

}  // namespace gp::cpu

namespace gp {

std::unique_ptr<Backend> newCpuBackend(const BackendOptions& options) {
    return std::make_unique<cpu::CpuBackend>(options);
}

}  // namespace gp
