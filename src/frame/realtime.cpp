#include "frame/realtime.h"

#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

#include "frame/compose.h"
#include "frame/realtime_read.h"

namespace gp {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Where in the pixels the rays of a frame go: evenly after any number of frames.
// [Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", the R2 sequence]
glm::vec2 jitterOf(uint32_t frame) {
    const double n = double(frame) + 1;
    const auto fraction = [](double x) { return float(x - std::floor(x)); };
    return {fraction(0.5 + n * 0.7548776662466927) - 0.5f,
            fraction(0.5 + n * 0.5698402909980532) - 0.5f};
}

const char* const passNames[] = {
#define X(name, size) #name,
#include "frame/realtime_passes.def"
#undef X
};

}  // namespace

shared::RealtimeConstants RealtimeFrame::constants(const RealtimePlan& plan, bool hasPrevious,
                                                   bool sceneChanged) const {
    const RealtimeViews& views = images_.views();
    shared::RealtimeConstants c{};
    c.size = views.size[size_t(RealtimeSize::FULL)];
    c.output_size = views.size[size_t(RealtimeSize::OUTPUT)];
    c.jitter = jitter_;
    c.frame_index = index_;
    c.has_previous = hasPrevious;
    c.mirror_limit = plan.mirrorLimit;
    c.repeats_draws = usesGradients(plan.denoiser) && hasPrevious;
    c.relights = images_.filtered;
    c.resolves = plan.antiAliasing == AntiAliasing::temporal || c.size != c.output_size;
    c.light_reuse = uint32_t(plan.lightReuse);
    c.indirect_reuse = uint32_t(plan.indirectReuse);
    c.scene_changed = sceneChanged;
    c.suns_apart = images_.sunsApart;
    c.previous_lights = uint32_t(motion_.currentLightOfPrevious().size());
    c.sea = motion_.sea();
    c.previous_instances = uint32_t(motion_.currentOfPrevious().size());
#define X(name, initial, minimum, maximum, text) c.name = plan.parameters.name;
#include "shared/denoiser_parameters.def"
#undef X
    return c;
}

bool RealtimeFrame::resize(glm::ivec2 full, glm::ivec2 output, ReuseImages reuse) {
    const RealtimeViews& views = images_.views();
    const bool sameSize = views.size[size_t(RealtimeSize::FULL)] == full;
    // Suns set, and glitter comes into scenes and goes: an image more is no reason to forget, and
    // once it is there it stays.
    ReuseImages had = images_.reuse();
    reuse.suns |= had.suns;
    const bool onlySuns = std::exchange(had.suns, reuse.suns) != reuse.suns;
    const bool same = views.size[size_t(RealtimeSize::OUTPUT)] == output && had == reuse;
    if (same && sameSize && !onlySuns) return false;
    if (same && previousCamera_) {
        images_.rescale(full, reuse);
        return !sameSize;
    }
    cut();
    images_.resize(full, output, reuse);
    return true;
}

// The frame from top to bottom.
RealtimeResult RealtimeFrame::render(Backend& backend, const BackendScene& backendScene,
                                     const Scene& scene, const RealtimePlan& plan,
                                     FrameImages& picture, std::atomic<bool>& cancel) {
    const auto start = Clock::now();
    RealtimeResult result;
    const bool sunsApart =
        backendScene.hasSlopes() && backendScene.lights().directionalCount > 0;
    const bool resized = resize(
        {int(plan.frame.width), int(plan.frame.height)}, glm::ivec2(plan.outputSize),
        {plan.lightReuse != LightReuse::none, plan.indirectReuse != LightReuse::none,
         plan.denoiser == Denoiser::bmfr, sunsApart});
    if (plan.resetHistory) cut();
    // What another denoiser left, or frames without reuse did not write, is no history.
    if (plan.denoiser != denoiser_ || plan.lightReuse != lightReuse_ ||
        plan.indirectReuse != indirectReuse_)
        previousCamera_.reset();
    denoiser_ = plan.denoiser;
    lightReuse_ = plan.lightReuse, indirectReuse_ = plan.indirectReuse;
    FramePlan frame = plan.frame;
    const auto skyStart = Clock::now();
    sky_.update(backend, backendScene, scene, frame);
    if (frame.sky) result.passes.push_back({"sky", millisecondsSince(skyStart)});
    // Whatever ends this frame early leaves images that are half of it.
    const std::optional<Camera> previous = std::exchange(previousCamera_, std::nullopt);
    const bool hasPrevious = previous.has_value();
    if (!hasPrevious) {
        motion_.forget();
        lightVisibility_ = backend.estimateLightVisibility(backendScene, frame);
    }
    motion_.compare(scene, backendScene.lights());
    jitter_ = plan.antiAliasing == AntiAliasing::none ? glm::vec2(0) : jitterOf(index_);
    images_.swap();
    heat_.begin(plan.heatMaps, images_.views().size[size_t(RealtimeSize::FULL)]);
    images_.filtered = filtersIndirect(plan.denoiser);
    images_.sunsApart = sunsApart;

    const bool sceneChanged = std::exchange(sceneRevision_, scene.revision) != scene.revision;
    shared::RealtimeConstants c = constants(plan, hasPrevious, sceneChanged);
    if (resized) c.repeats_draws = 0;  // draws go by pixels, and those are others
    frame.lightVisibility = lightVisibility_;
    const RealtimeJob job{backendScene, frame, previous ? *previous : frame.camera, c, motion_,
                          images_.views(), heat_.views()};
    const auto run = [&](RealtimePass pass) {
        if (cancel.load()) return;
        const auto passStart = Clock::now();
        const RayCounts rays = backend.runRealtimePass(job, pass);
        result.rays.camera += rays.camera, result.rays.bounce += rays.bounce;
        result.rays.shadow += rays.shadow;
        result.passes.push_back({passNames[size_t(pass)], millisecondsSince(passStart)});
    };
    const auto filter = [&](const DenoisePass& pass) {
        if (cancel.load()) return;
        const auto passStart = Clock::now();
        backend.runDenoisePass(job, pass);
        const double time = millisecondsSince(passStart);
        for (PassTime& earlier : result.passes)
            if (std::string_view(earlier.name) == pass.name) {
                earlier.milliseconds += time;
                return;
            }
        result.passes.push_back({pass.name, time});
    };

    run(RealtimePass::primary);       // what each pixel shows
    if (c.repeats_draws != 0)
        run(RealtimePass::gradient_reproject);  // pixels that will tell what has changed
    run(RealtimePass::lighting);      // three noisy channels
    for (const DenoisePass& pass : denoisePasses(plan.denoiser)) filter(pass);  // less noisy ones
    filter(compositePass);            // together again
    filter(resolvePass);              // smooth edges, output size

    const auto displayStart = Clock::now();
    result.exposureEv = frame.exposureEv;
    if (plan.eye.seconds > 0)
        result.exposureEv += eye_.see(backend.luminanceHistogram(images_.views()), plan.eye,
                                      plan.timeStep);
    // What is drawn is no part of what the next frame goes on from.
    finishPicture(backend, frame, result.exposureEv,
                  {[&](FrameImage which, void* pixels) {
                       readRealtimeImage(images_, which, pixels);
                   },
                   [&](float ev) {
                       backend.tonemapRealtime(images_.views(), ev, frame.tonemap,
                                               picture.display);
                   }},
                  picture);
    result.passes.push_back({"display", millisecondsSince(displayStart)});

    result.cancelled = cancel.load();
    if (!result.cancelled) {
        motion_.remember(scene, backendScene.lights());
        previousCamera_ = frame.camera;
        ++index_;
    }
    result.secondsRender = millisecondsSince(start) * 1e-3;
    return result;
}

}  // namespace gp
