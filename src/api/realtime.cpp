#include "api/realtime.h"

#include <algorithm>
#include <cmath>

#include "api/check.h"
#include "api/scenes.h"
#include "frame/realtime_read.h"
#include "nearest_word.h"

namespace gp::api {

namespace {

constexpr uint32_t mirrorsAtMost = 16;

void refuse(const char* field) {
    fail(GP_ERROR_INVALID_ARGUMENT, "options.{} is not for frames of GP_MODE_REALTIME", field);
}

void checkOthers(const GpRenderOptions& o) {
    if (o.samplesPerPixel > 1) refuse("samplesPerPixel");
    if (o.timeLimit != 0) refuse("timeLimit");
    if (o.noiseTarget != 0) refuse("noiseTarget");
    if (o.pixelFilter != 0) refuse("pixelFilter");
    if (o.pixelFilterRadius != 0) refuse("pixelFilterRadius");
    if (o.accumulate != 0) refuse("accumulate");
}

}  // namespace

RealtimePlan realtimePlanFrom(const GpRenderOptions& o) {
    checkOthers(o);
    RealtimePlan plan;
    plan.resetHistory = o.realtime.resetHistory != 0;
    plan.antiAliasing =
        AntiAliasing(checkEnum(o.realtime.antiAliasing, 3, "options.realtime.antiAliasing"));
    const int32_t mirrors = o.realtime.mirrorLimit;
    if (mirrors < GP_NO_BOUNCES || mirrors > int32_t(mirrorsAtMost))
        fail(GP_ERROR_OUT_OF_RANGE, "options.realtime.mirrorLimit is {}, not in -1..{}", mirrors,
             mirrorsAtMost);
    if (mirrors != 0) plan.mirrorLimit = mirrors < 0 ? 0 : uint32_t(mirrors);
    return plan;
}

void setSizes(RealtimePlan& plan, const GpRenderOptions& o, glm::uvec2 output) {
    const float scale = o.realtime.renderScale == 0 ? 1 : o.realtime.renderScale;
    checkRange(scale, 0.5, 1, "options.realtime.renderScale");
    plan.outputSize = output;
    plan.frame.width = std::max(1u, uint32_t(std::lround(scale * float(output.x))));
    plan.frame.height = std::max(1u, uint32_t(std::lround(scale * float(output.y))));
}

void renderRealtime(FrameObject& frame, SceneObject& scene, const RealtimePlan& plan) {
    std::atomic<bool>& cancel = *frame.device->cancel;
    const RealtimeResult result =
        frame.realtime->render(*frame.device->backend, *scene.backendScene, scene.scene, plan,
                               frame.images.display, cancel);
    GpFrameStatistics& s = frame.statistics;
    s.samplesPerPixel = 1;
    s.cameraRays = result.rays.camera;
    s.bounceRays = result.rays.bounce;
    s.shadowRays = result.rays.shadow;
    s.secondsRender = result.secondsRender;
    s.accelerationBytes = scene.backendScene->accelerationBytes();
    frame.passes = result.passes;
    frame.rendered = !result.cancelled;
    if (result.cancelled) fail(GP_ERROR_CANCELLED, "stopped in the middle of a frame");
}

void readImage(const FrameObject& frame, FrameImage which, void* pixels) {
    if (!frame.realtime || which == FrameImage::display) {
        readFrameImage(frame.images, which, pixels);
        return;
    }
    if (which == FrameImage::variance)
        fail(GP_ERROR_INVALID_OPERATION, "frames of GP_MODE_REALTIME have no variance image");
    readRealtimeImage(frame.realtime->images(), which, pixels);
}

namespace {

RealtimeImage layerNamed(const char* name) {
    std::vector<std::string> names;
    for (size_t i = 0; i < realtimeImageCount; ++i) {
        names.emplace_back(realtimeImageInfo(RealtimeImage(i)).name);
        if (names.back() == name) return RealtimeImage(i);
    }
    const std::string nearest = nearestWord(name, names);
    fail(GP_ERROR_INVALID_ARGUMENT, "no layer has the name \"{}\"{}", name,
         nearest.empty() ? "" : " (did you mean " + nearest + "?)");
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpGetPassTimes(GpFrame frame, GpPassTime* times, uint32_t capacity, uint32_t* count) {
    return enter("gpGetPassTimes", "frame", frame, [&](FrameObject& f) {
        if (capacity > 0) checkPointer(times, "times");
        checkPointer(count, "count");
        for (size_t i = 0; i < std::min<size_t>(capacity, f.passes.size()); ++i)
            times[i] = {f.passes[i].name, f.passes[i].milliseconds};
        *count = uint32_t(f.passes.size());
    });
}

GpError gpReadFrameLayer(GpFrame frame, const char* name, float* pixels, size_t size) {
    return enter("gpReadFrameLayer", "frame", frame, [&](FrameObject& f) {
        checkPointer(name, "name");
        checkPointer(pixels, "pixels");
        if (!f.realtime)
            fail(GP_ERROR_INVALID_OPERATION, "only frames of GP_MODE_REALTIME have layers");
        checkRendered(f);
        const gp::RealtimeImage which = layerNamed(name);
        const size_t needed = f.images.pixelCount() * sizeof(glm::vec4);
        if (size < needed)
            fail(GP_ERROR_INVALID_OPERATION, "size is {}, but the layer has {} bytes", size,
                 needed);
        std::vector<glm::vec4> values(f.images.pixelCount());
        gp::readRealtimeLayer(f.realtime->images(), which, values.data());
        std::memcpy(pixels, values.data(), needed);
    });
}

GpError gpGetFrameLayerInfo(uint32_t index, const char** name, const char** meaning) {
    auto body = [&](Object*) {
        checkPointer(name, "name");
        checkPointer(meaning, "meaning");
        if (index >= gp::realtimeImageCount)
            fail(GP_ERROR_OUT_OF_RANGE, "index is {}, but there are {} layers", index,
                 gp::realtimeImageCount);
        const gp::RealtimeImageInfo& info = gp::realtimeImageInfo(gp::RealtimeImage(index));
        *name = info.name;
        *meaning = info.meaning;
    };
    return enterFree("gpGetFrameLayerInfo", BodyRef(body));
}

}  // extern "C"
