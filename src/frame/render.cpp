#include "frame/render.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "frame/compose.h"

namespace gp {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Batches long enough that their borders cost nothing, short enough that a person who waits, or a
// limit, is served within about a quarter of a second.
constexpr double batchSeconds = 0.25;
// The estimate of the noise reads every pixel: it must not be what the time goes into.
constexpr double noiseSeconds = 0.5;

class RenderLoop {
public:
    RenderLoop(Backend& backend, const BackendScene& scene, FramePlan plan,
               FrameImages& images, std::atomic<bool>& cancel,
               const std::function<bool(const RenderProgress&)>& progress)
        : backend_(backend),
          scene_(scene),
          plan_(plan),
          images_(images),
          cancel_(cancel),
          progress_(progress) {}

    RenderResult run() {
        if (plan_.mode == FrameMode::reference)
            plan_.lightVisibility = backend_.estimateLightVisibility(scene_, plan_);
        first_ = plan_.accumulate ? samplesOfAll() : 0;
        const uint32_t begin = first_;
        uint32_t batch = 1;
        while (!result_.cancelled && !finished(first_ - begin)) {
            const uint32_t left = plan_.samplesPerPixel - (first_ - begin);
            const uint32_t count = std::min(batch, left);
            const auto start = Clock::now();
            const RayCounts rays =
                backend_.tracePaths(scene_, plan_, first_, count, images_, cancel_);
            const double seconds = secondsSince(start);
            result_.rays.camera += rays.camera, result_.rays.bounce += rays.bounce;
            result_.rays.shadow += rays.shadow;
            first_ += count;
            result_.cancelled = cancel_.load();
            if (!report(first_ - begin)) result_.cancelled = true;
            batch = nextBatch(count, seconds);
        }
        result_.secondsRender = secondsSince(start_);
        result_.samplesPerPixel = result_.cancelled ? samplesOfAll() : first_;
        result_.noise = noiseNow();
        finishPicture(backend_, plan_, plan_.exposureEv, tracedPicture(backend_, plan_, images_),
                      images_);
        return result_;
    }

private:
    // Cancelled tiles leave pixels with different counts: what all have, and the next sample that
    // is missing.
    uint32_t samplesOfAll() const {
        uint32_t least = images_.sums.empty() ? 0 : std::numeric_limits<uint32_t>::max();
        for (const PixelSums& s : images_.sums) least = std::min(least, s.samples);
        return least;
    }

    bool finished(uint32_t done) {
        if (done >= plan_.samplesPerPixel) return true;
        if (done == 0) return false;
        if (plan_.timeLimit > 0 && secondsSince(start_) >= plan_.timeLimit) return true;
        if (plan_.noiseTarget > 0 && done >= 4) {
            updateNoise(plan_.samplesPerPixel == std::numeric_limits<uint32_t>::max()
                            ? batchSeconds
                            : noiseSeconds);
            return noise_ >= 0 && noise_ <= plan_.noiseTarget;
        }
        return false;
    }

    // Of one sample there is no error to be seen, and reading all pixels takes its time.
    double noiseNow() const {
        return first_ < 2 && !plan_.accumulate ? -1 : estimateNoise(images_);
    }

    void updateNoise(double interval) {
        if (noise_ >= 0 && secondsSince(lastNoise_) < interval) return;
        noise_ = noiseNow();
        lastNoise_ = Clock::now();
    }

    uint32_t nextBatch(uint32_t count, double seconds) const {
        double wanted = batchSeconds;
        if (plan_.timeLimit > 0) wanted = std::min(wanted, plan_.timeLimit - secondsSince(start_));
        const double ideal = seconds > 0 ? double(count) * wanted / seconds : 2.0 * count;
        return uint32_t(std::clamp(ideal, 1.0, 2.0 * count));
    }

    bool report(uint32_t done) {
        if (!progress_) return true;
        updateNoise(noiseSeconds);
        RenderProgress p;
        p.secondsElapsed = secondsSince(start_);
        p.samplesPerPixel = first_;
        p.raysPerSecond = double(result_.rays.total()) / std::max(p.secondsElapsed, 1e-9);
        p.noise = noise_;
        double fraction = 0;
        if (plan_.samplesPerPixel != std::numeric_limits<uint32_t>::max())
            fraction = double(done) / plan_.samplesPerPixel;
        if (plan_.timeLimit > 0) fraction = std::max(fraction, p.secondsElapsed / plan_.timeLimit);
        // The error falls with the square root of the samples.
        if (plan_.noiseTarget > 0 && noise_ > 0)
            fraction =
                std::max(fraction, plan_.noiseTarget * plan_.noiseTarget / (noise_ * noise_));
        p.fraction = std::min(fraction, 1.0);
        if (p.fraction > 0) p.secondsRemaining = p.secondsElapsed * (1 - p.fraction) / p.fraction;
        return progress_(p);
    }

    Backend& backend_;
    const BackendScene& scene_;
    FramePlan plan_;
    FrameImages& images_;
    std::atomic<bool>& cancel_;
    const std::function<bool(const RenderProgress&)>& progress_;
    RenderResult result_;
    uint32_t first_ = 0;
    Clock::time_point start_ = Clock::now(), lastNoise_ = start_;
    double noise_ = -1;
};

}  // namespace

RenderResult renderFrame(Backend& backend, const BackendScene& scene, const FramePlan& plan,
                         FrameImages& images, std::atomic<bool>& cancel,
                         const std::function<bool(const RenderProgress&)>& progress) {
    if (!plan.accumulate) images.sums.assign(images.pixelCount(), {});
    return RenderLoop(backend, scene, plan, images, cancel, progress).run();
}

}  // namespace gp
