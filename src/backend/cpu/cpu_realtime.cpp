// A pass of a real-time frame: its tiles over the threads.
#include <algorithm>
#include <chrono>
#include <vector>

#include <immintrin.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include "backend/cpu/cpu_backend.h"

namespace gp::cpu {
namespace {

constexpr RealtimeSize sizes[] = {
#define X(name, size) RealtimeSize::size,
#include "frame/realtime_passes.def"
#undef X
};

constexpr uint32_t tileSize = 8;

// The time that pixels take is counted in ticks of the processor, which cost little to ask for; how
// long one is, the whole pass tells.
class PixelClock {
public:
    explicit PixelClock(size_t pixels) : ticks_(pixels) {}  // 0: nobody asked
    uint64_t* ticks() { return ticks_.empty() ? nullptr : ticks_.data(); }
    void addTo(float* microseconds) const {
        if (ticks_.empty()) return;
        const std::chrono::duration<double, std::micro> passed = Clock::now() - start_;
        const double tick = passed.count() / double(std::max<uint64_t>(1, __rdtsc() - first_));
        for (size_t i = 0; i < ticks_.size(); ++i)
            microseconds[i] += float(double(ticks_[i]) * tick);
    }

private:
    using Clock = std::chrono::steady_clock;
    std::vector<uint64_t> ticks_;
    Clock::time_point start_ = Clock::now();
    uint64_t first_ = __rdtsc();
};

}  // namespace

RayCounts CpuBackend::runRealtimePass(const RealtimeJob& job, RealtimePass pass) {
    const SceneView view = viewFor(job.scene, job.frame);
    const shared::FrameConstants frame = frameConstants(view, job.frame);
    RealtimeTileJob all{};
    all.tile.scene = &view, all.tile.frame = &frame, all.tile.camera = &job.frame.camera;
    all.realtime = &job.constants, all.previousCamera = &job.previousCamera;
    all.images = &job.images;
    all.previousInstances = job.motion.instances().data();
    all.previousPositions = job.motion.positions().data();
    all.currentOfPrevious = job.motion.currentOfPrevious().data();
    all.currentLightOfPrevious = job.motion.currentLightOfPrevious().data();
    all.pass = pass;

    const glm::uvec2 size = job.images.size[size_t(sizes[size_t(pass)])];
    const bool measured =
        job.heat.rays != nullptr && sizes[size_t(pass)] == RealtimeSize::FULL;
    PixelClock clock(measured ? size_t(size.x) * size.y : 0);
    all.pixelTicks = clock.ticks();
    all.pixelRays = measured ? job.heat.rays : nullptr;
    const glm::uvec2 tiles = (size + (tileSize - 1)) / tileSize;
    tbb::combinable<RayCounts> counts;
    arena_.execute([&] {
        tbb::parallel_for(0u, tiles.x * tiles.y, [&](uint32_t i) {
            const DenormalsOff denormalsOff;
            RealtimeTileJob one = all;
            TileJob& t = one.tile;
            t.x0 = i % tiles.x * tileSize, t.y0 = i / tiles.x * tileSize;
            t.x1 = std::min(t.x0 + tileSize, size.x), t.y1 = std::min(t.y0 + tileSize, size.y);
            const TileCounts c = realtimeKernels_.runTile(one);
            RayCounts& sum = counts.local();
            sum.camera += c.camera, sum.bounce += c.bounce, sum.shadow += c.shadow;
        });
    });
    clock.addTo(job.heat.microseconds);
    return counts.combine([](RayCounts a, const RayCounts& b) {
        return RayCounts{a.camera + b.camera, a.bounce + b.bounce, a.shadow + b.shadow};
    });
}

void CpuBackend::runDenoisePass(const RealtimeJob& job, const DenoisePass& pass) {
    constexpr int rowsAtOnce = 4;
    const int rows = job.images.size[size_t(denoiseSize(pass.kernel))].y;
    arena_.execute([&] {
        tbb::parallel_for(0, (rows + rowsAtOnce - 1) / rowsAtOnce, [&](int i) {
            const DenormalsOff denormalsOff;
            const int first = i * rowsAtOnce;
            denoiseKernels_.run[size_t(pass.kernel)](
                {&job.images, &job.constants, &job.frame.camera, &job.previousCamera,
                 pass.parameter, first, std::min(first + rowsAtOnce, rows)});
        });
    });
}

LuminanceHistogram CpuBackend::luminanceHistogram(const RealtimeViews& images) {
    LuminanceHistogram histogram{};
    realtimeKernels_.luminanceHistogram(images, histogram.data());
    return histogram;
}

void CpuBackend::tonemapRealtime(const RealtimeViews& images, float exposureEv, Tonemap tonemap,
                                 std::vector<glm::u8vec4>& display) {
    constexpr size_t run = 4096;
    arena_.execute([&] {
        tbb::parallel_for(size_t(0), (display.size() + run - 1) / run, [&](size_t i) {
            const size_t begin = i * run;
            realtimeKernels_.tonemap(images, display.data(), begin,
                                     std::min(run, display.size() - begin), exposureEv,
                                     uint32_t(tonemap));
        });
    });
}

}  // namespace gp::cpu
