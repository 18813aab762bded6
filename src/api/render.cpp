// gpRender: options into a plan, the scene into the backend's form, then the frame's passes.
#include <chrono>
#include <climits>

#include "api/check.h"
#include "api/frames.h"
#include "api/realtime.h"
#include "api/scenes.h"
#include "frame/render.h"
#include "scene/sea.h"
#include "scene/sky.h"

namespace gp::api {

float checkExposure(float ev) {
    constexpr double widest = 100;
    checkRange(ev, -widest, widest, "exposureEv");
    return ev;
}

namespace {

static_assert(GP_TONEMAP_ACES == int(Tonemap::aces) &&
              GP_TONEMAP_REINHARD == int(Tonemap::reinhard) &&
              GP_TONEMAP_NONE == int(Tonemap::none));
static_assert(GP_PIXEL_BOX == int(PixelFilter::box) && GP_PIXEL_TENT == int(PixelFilter::tent) &&
              GP_PIXEL_GAUSSIAN == int(PixelFilter::gaussian));
static_assert(GP_SHADING_DIFFUSE == int(ShadingMode::diffuse));
static_assert(GP_FREQUENCY_VERTEX == int(ShadingFrequency::vertex) &&
              GP_FREQUENCY_TRIANGLE == int(ShadingFrequency::triangle));
static_assert(GP_FALLOFF_INVERSE == int(Falloff::inverse) &&
              GP_FALLOFF_NONE == int(Falloff::none));
static_assert(GP_NDF_FILTER_KAPLANYAN == int(NdfFilter::kaplanyan) &&
              GP_NDF_FILTER_TOKUYOSHI == int(NdfFilter::tokuyoshi) &&
              GP_NDF_FILTER_DEFERRED == int(NdfFilter::deferred));

constexpr double widestFilter = 16;  // pixels

float filterRadius(PixelFilter filter) {
    switch (filter) {
        case PixelFilter::box: return 0.5f;
        case PixelFilter::tent: return 1;
        case PixelFilter::blackmanHarris:
        case PixelFilter::gaussian: break;
    }
    return 1.5f;
}

void readLimits(FramePlan& plan, const GpRenderOptions& o) {
    checkNotNegative(o.timeLimit, "options.timeLimit");
    checkNotNegative(o.noiseTarget, "options.noiseTarget");
    plan.timeLimit = o.timeLimit;
    plan.noiseTarget = o.noiseTarget;
    const bool otherLimit = o.timeLimit > 0 || o.noiseTarget > 0;
    if (o.samplesPerPixel != 0)
        plan.samplesPerPixel = o.samplesPerPixel;
    else if (otherLimit)
        plan.samplesPerPixel = UINT32_MAX;
    if (o.maxBounces < GP_NO_BOUNCES)
        fail(GP_ERROR_OUT_OF_RANGE, "options.maxBounces is {}", o.maxBounces);
    if (o.maxBounces != 0) plan.maxBounces = o.maxBounces < 0 ? 0 : uint32_t(o.maxBounces);
}

// What only the path tracer has, or only local lighting.
void checkMode(const FrameObject& frame, const GpRenderOptions& o) {
    const auto refuse = [](const char* field, const char* mode) {
        fail(GP_ERROR_INVALID_ARGUMENT, "options.{} is only for frames of {}", field, mode);
    };
    if (frame.mode != FrameMode::realtime && !isDefault(o.realtime))
        refuse("realtime", "GP_MODE_REALTIME");
    if (frame.mode == FrameMode::local) {
        if (o.maxBounces != 0) refuse("maxBounces", "GP_MODE_REFERENCE or REALTIME");
        if (o.clamp != 0) refuse("clamp", "GP_MODE_REFERENCE or REALTIME");
        if (o.noRussianRoulette != 0) refuse("noRussianRoulette", "GP_MODE_REFERENCE or REALTIME");
        return;
    }
    if (o.local.model) refuse("local.model", "GP_MODE_LOCAL");
    if (checkEnum(o.local.frequency, 3, "options.local.frequency") != 0)
        refuse("local.frequency", "GP_MODE_LOCAL");
    if (checkEnum(o.local.falloff, 3, "options.local.falloff") != 0)
        refuse("local.falloff", "GP_MODE_LOCAL");
    if (checkEnum(o.local.ndfFilter, 4, "options.local.ndfFilter") != 0)
        refuse("local.ndfFilter", "GP_MODE_LOCAL");
    if (!allZero(o.local.ambient, 3)) refuse("local.ambient", "GP_MODE_LOCAL");
    if (o.local.environmentFacets != 0) refuse("local.environmentFacets", "GP_MODE_LOCAL");
}

// Facets along each axis of the sum, of which there are the square.
uint32_t environmentNodes(uint32_t facets) {
    for (const uint32_t nodes : {0u, 3u, 4u, 5u})
        if (facets == nodes * nodes) return nodes;
    fail(GP_ERROR_INVALID_ARGUMENT, "options.local.environmentFacets is {}, not 0, 9, 16 or 25",
         facets);
}

LocalLighting localLightingFrom(const GpRenderOptions& o, const BsdfSettings* model,
                                ShadingMode shading) {
    LocalLighting local;
    local.model = model;
    local.frequency =
        ShadingFrequency(checkEnum(o.local.frequency, 3, "options.local.frequency"));
    local.falloff = Falloff(checkEnum(o.local.falloff, 3, "options.local.falloff"));
    local.ndfFilter = NdfFilter(checkEnum(o.local.ndfFilter, 4, "options.local.ndfFilter"));
    if (local.ndfFilter != NdfFilter::none && local.frequency != ShadingFrequency::pixel)
        fail(GP_ERROR_INVALID_ARGUMENT,
             "options.local.ndfFilter filters over pixels: only with GP_FREQUENCY_PIXEL");
    checkNotNegative(o.local.ambient, 3, "options.local.ambient");
    local.ambient = vec3From(o.local.ambient);
    local.environmentNodes = environmentNodes(o.local.environmentFacets);
    if (model && shading == ShadingMode::diffuse)
        fail(GP_ERROR_INVALID_ARGUMENT,
             "options.local.model replaces all materials, as GP_SHADING_DIFFUSE does: not both");
    return local;
}

FramePlan planFrom(const GpRenderOptions& o) {
    FramePlan plan;
    readLimits(plan, o);
    plan.seed = o.seed;
    plan.shading = ShadingMode(checkEnum(o.shading, 2, "options.shading"));
    plan.pixelFilter = PixelFilter(checkEnum(o.pixelFilter, 4, "options.pixelFilter"));
    checkRange(o.pixelFilterRadius, 0, widestFilter, "options.pixelFilterRadius");
    plan.pixelFilterRadius =
        o.pixelFilterRadius == 0 ? filterRadius(plan.pixelFilter) : o.pixelFilterRadius;
    checkNotNegative(o.clamp, "options.clamp");
    plan.clampIndirect = o.clamp;
    plan.russianRoulette = o.noRussianRoulette == 0;
    checkNotNegative(o.rayLength, "options.rayLength");
    if (o.rayLength > 0) plan.rayLength = o.rayLength;
    checkFinite(o.skyViewerPosition, 3, "options.skyViewerPosition");
    checkFinite(o.skyScale, "options.skyScale");
    plan.exposureEv = checkExposure(o.exposureEv);
    plan.tonemap = Tonemap(checkEnum(o.tonemap, 4, "options.tonemap"));
    plan.accumulate = o.accumulate != 0;
    plan.hideBackground = o.hideBackground != 0;
    return plan;
}

Camera chooseCamera(const Scene& scene, const GpCameraDesc* desc, const FrameImages& images) {
    if (desc) return cameraFrom(*desc);
    if (!scene.cameras.empty()) return scene.cameras.front();
    return frameScene(scene, float(images.width) / float(images.height));
}

bool sameView(const Camera& a, const Camera& b) {
    return a.kind == b.kind && a.position == b.position && a.target == b.target && a.up == b.up &&
           a.verticalFov == b.verticalFov && a.orthographicHeight == b.orthographicHeight &&
           a.apertureRadius == b.apertureRadius && a.focusDistance == b.focusDistance;
}

// Where the camera stands in the small world of the sky.
glm::vec3 skyViewerOf(const GpRenderOptions& o, const Camera& camera) {
    const glm::vec3 viewer = vec3From(o.skyViewerPosition) + o.skyScale * camera.position;
    if (!std::isfinite(viewer.x) || !std::isfinite(viewer.y) || !std::isfinite(viewer.z))
        fail(GP_ERROR_OUT_OF_RANGE, "options.skyScale is {}: the sky's viewer would be nowhere",
             o.skyScale);
    return viewer;
}

void checkAccumulation(const FrameObject& frame, const SceneObject& scene, const FramePlan& plan) {
    if (!plan.accumulate || !frame.rendered) return;
    if (frame.scene.lock().get() != &scene || frame.sceneRevision != scene.scene.revision)
        fail(GP_ERROR_INVALID_OPERATION, "options.accumulate: the frame shows another scene");
    if (!sameView(frame.camera, plan.camera))
        fail(GP_ERROR_INVALID_OPERATION, "options.accumulate: the frame shows another view");
    if (frame.skyViewer != plan.skyViewer)
        fail(GP_ERROR_INVALID_OPERATION, "options.accumulate: the frame shows another sky");
    if (frame.backgroundHidden != plan.hideBackground)
        fail(GP_ERROR_INVALID_OPERATION,
             "options.accumulate: the frame was rendered with another hideBackground");
    const uint32_t held = frame.statistics.samplesPerPixel;
    if (plan.samplesPerPixel != UINT32_MAX && plan.samplesPerPixel > UINT32_MAX - 1 - held)
        fail(GP_ERROR_TOO_LARGE, "options.samplesPerPixel is {}, added to {}", plan.samplesPerPixel,
             held);
}

// The callback of C, as the frame's loop wants it.
std::function<bool(const RenderProgress&)> progressOf(const GpRenderOptions& options) {
    if (!options.progress) return [](const RenderProgress&) { return true; };
    return [&options](const RenderProgress& p) {
        GpProgress progress{};
        progress.fraction = p.fraction;
        progress.secondsElapsed = p.secondsElapsed;
        progress.secondsRemaining = p.secondsRemaining;
        progress.samplesPerPixel = p.samplesPerPixel;
        progress.raysPerSecond = p.raysPerSecond;
        progress.noise = p.noise;
        return options.progress(options.progressUser, &progress) == 0;
    };
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Brings the backend's scene up to date; returns the seconds that it took.
double build(SceneObject& scene, const FramePlan& plan) {
    const auto start = std::chrono::steady_clock::now();
    // The sea is where the camera is, and has its motion from the frame before in real time.
    const auto& sea = scene.scene.sea;
    if (sea && sea->place(plan.camera, plan.mode == FrameMode::realtime))
        ++scene.scene.seaPlacement;
    if (!scene.backendScene) scene.backendScene = scene.device->backend->newScene();
    try {
        scene.backendScene->update(scene.scene);
    } catch (...) {
        // Half updated, it would show something that never was: made anew by the next render.
        scene.backendScene.reset();
        throw;
    }
    return secondsSince(start);
}

void note(FrameObject& frame, const SceneObject& scene, const RenderResult& result, double build,
          float exposureEv) {
    GpFrameStatistics& s = frame.statistics;
    s.samplesPerPixel = result.samplesPerPixel;
    s.cameraRays = result.rays.camera;
    s.bounceRays = result.rays.bounce;
    s.shadowRays = result.rays.shadow;
    s.secondsBuild = build;
    s.secondsRender = result.secondsRender;
    s.exposureEv = exposureEv;
    s.noise = result.noise;
    s.accelerationBytes = scene.backendScene->accelerationBytes();
}

// What was drawn is drawn; the overlay alone may be wanted again.
void useUpDraws(FrameObject& frame) {
    frame.overlay.clear();
    for (DrawCommand& draw : frame.draws)
        if (draw.target == DrawTarget::overlay) frame.overlay.push_back(std::move(draw));
    frame.draws.clear();
    frame.drawElements = 0;
    frame.statistics.frameBytes =
        frame.images.bytes() + (frame.realtime ? frame.realtime->bytes() : 0);
}

// An exception in the middle leaves some pixels with more samples than others: empties the frame.
void discard(FrameObject& frame) noexcept {
    std::fill(frame.images.sums.begin(), frame.images.sums.end(), PixelSums{});
    frame.images.drawn = {};
    frame.overlay.clear();
    const uint64_t bytes = frame.statistics.frameBytes;
    frame.statistics = {};
    frame.statistics.noise = -1;
    frame.statistics.frameBytes = bytes;
    frame.rendered = false;
}

void render(FrameObject& frame, const std::shared_ptr<SceneObject>& scene,
            const GpCameraDesc* camera, const GpRenderOptions& options) {
    checkMode(frame, options);
    FramePlan plan = planFrom(options);
    plan.mode = frame.mode;
    std::shared_ptr<BsdfObject> model;  // lives until the picture is there
    if (options.local.model)
        model = resolve(*frame.device, options.local.model, "options.local.model");
    plan.local =
        localLightingFrom(options, model ? model->settings.get() : nullptr, plan.shading);
    plan.width = frame.images.width;
    plan.height = frame.images.height;
    plan.camera = chooseCamera(scene->scene, camera, frame.images);
    plan.skyViewer = skyViewerOf(options, plan.camera);
    checkAccumulation(frame, *scene, plan);
    plan.draws = &frame.draws;

    std::atomic<bool>& cancel = *frame.device->cancel;
    cancel.store(false);
    if (frame.mode == FrameMode::realtime) {
        RealtimePlan realtime = realtimePlanFrom(options);
        // Waves show in waves: ending at the second surface would draw their troughs black.
        if (options.maxBounces == 0) plan.maxBounces = scene->scene.sea ? 2 : 1;
        plan.lastByLights = true;
        realtime.frame = plan;
        setSizes(realtime, options, {plan.width, plan.height});
        // Another scene may have the same ids for other things.
        realtime.resetHistory |= frame.scene.lock() != scene;
        frame.scene = scene;
        frame.statistics.secondsBuild = build(*scene, plan);
        const RealtimeResult result = renderRealtime(frame, *scene, realtime);
        frame.camera = plan.camera;
        frame.shownEv = result.exposureEv, frame.shownTonemap = plan.tonemap;
        useUpDraws(frame);
        if (result.cancelled) fail(GP_ERROR_CANCELLED, "stopped in the middle of a frame");
        return;
    }
    const double secondsBuild = build(*scene, plan);
    if (frame.scene.lock() != scene) frame.sky.forget(), frame.surroundings.forget();
    RenderResult result;
    try {
        frame.sky.update(*frame.device->backend, *scene->backendScene, scene->scene, plan);
        frame.surroundings.update(*frame.device->backend, *scene->backendScene, scene->scene, plan);
        result = renderFrame(*frame.device->backend, *scene->backendScene, plan, frame.images,
                             cancel, progressOf(options));
    } catch (...) {
        discard(frame);
        throw;
    }
    frame.rendered = true;
    frame.scene = scene;
    frame.sceneRevision = scene->scene.revision;
    frame.camera = plan.camera;
    frame.skyViewer = plan.skyViewer;
    frame.backgroundHidden = plan.hideBackground;
    frame.shownEv = plan.exposureEv, frame.shownTonemap = plan.tonemap;
    useUpDraws(frame);
    note(frame, *scene, result, secondsBuild, plan.exposureEv);
    if (result.cancelled)
        fail(GP_ERROR_CANCELLED, "stopped at {} samples a pixel", result.samplesPerPixel);
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" GpError gpRender(GpFrame frame, GpScene scene, const GpCameraDesc* camera,
                            const GpRenderOptions* options) {
    return enter("gpRender", "frame", frame, [&](FrameObject& f) {
        render(f, resolve(*f.device, scene, "scene"), camera,
               options ? *options : GpRenderOptions{});
    });
}
