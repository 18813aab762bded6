#include "api/realtime.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "api/check.h"
#include "api/scenes.h"
#include "frame/realtime_read.h"
#include "nearest_word.h"

namespace gp::api {

namespace {

static_assert(GP_DENOISER_SVGF == int(Denoiser::svgf) &&
              GP_DENOISER_ATROUS == int(Denoiser::atrous) &&
              GP_DENOISER_NONE == int(Denoiser::none) &&
              GP_DENOISER_BMFR == int(Denoiser::bmfr));
static_assert(GP_REUSE_UNBIASED == int(LightReuse::unbiased) &&
              GP_AA_JITTER == int(AntiAliasing::jitter));

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

namespace {

EyeAdaptation eyeFrom(const GpEyeAdaptation& e) {
    constexpr double longest = 3600, widest = 100;
    EyeAdaptation eye;
    checkRange(e.seconds, 0, longest, "options.realtime.eyeAdaptation.seconds");
    checkRange(e.evMin, -widest, widest, "options.realtime.eyeAdaptation.evMin");
    checkRange(e.evMax, -widest, widest, "options.realtime.eyeAdaptation.evMax");
    eye.seconds = e.seconds;
    if (e.evMin == 0 && e.evMax == 0) return eye;
    if (e.evMin > e.evMax)
        fail(GP_ERROR_OUT_OF_RANGE, "options.realtime.eyeAdaptation.evMin is {}, above evMax, {}",
             e.evMin, e.evMax);
    eye.evMin = e.evMin, eye.evMax = e.evMax;
    return eye;
}

DenoiserParameters parametersFrom(const GpRealtimeOptions& o) {
    DenoiserParameters parameters;
    if (o.parameterCount > 0) checkPointer(o.parameters, "options.realtime.parameters");
    std::vector<std::string> names;
    for (const DenoiserParameterInfo& info : denoiserParameters()) names.emplace_back(info.name);
    for (uint32_t i = 0; i < o.parameterCount; ++i) {
        const std::string field = fmt::format("options.realtime.parameters[{}]", i);
        checkPointer(o.parameters[i].name, (field + ".name").c_str());
        const auto found = std::find(names.begin(), names.end(), o.parameters[i].name);
        if (found == names.end()) {
            const std::string nearest = nearestWord(o.parameters[i].name, names);
            fail(GP_ERROR_INVALID_ARGUMENT, "{}: no denoiser has a parameter \"{}\"{}", field,
                 o.parameters[i].name,
                 nearest.empty() ? "" : " (did you mean " + nearest + "?)");
        }
        const DenoiserParameterInfo& info =
            denoiserParameters()[size_t(found - names.begin())];
        checkRange(o.parameters[i].value, double(info.minimum), double(info.maximum),
                   (field + ", " + info.name + ",").c_str());
        parameters.*info.member = o.parameters[i].value;
    }
    return parameters;
}

}  // namespace

bool isDefault(const GpRealtimeOptions& o) {
    return o.resetHistory == 0 && o.antiAliasing == 0 && o.renderScale == 0 &&
           o.mirrorLimit == 0 && o.skyCubeSize == 0 && o.timeStep == 0 && o.lightReuse == 0 &&
           o.indirectReuse == 0 &&
           o.denoiser == 0 && o.parameterCount == 0 && o.eyeAdaptation.seconds == 0 &&
           o.eyeAdaptation.evMin == 0 && o.eyeAdaptation.evMax == 0 && o.heatMaps == 0;
}

RealtimePlan realtimePlanFrom(const GpRenderOptions& o) {
    checkOthers(o);
    RealtimePlan plan;
    plan.resetHistory = o.realtime.resetHistory != 0;
    plan.heatMaps = o.realtime.heatMaps != 0;
    plan.antiAliasing =
        AntiAliasing(checkEnum(o.realtime.antiAliasing, 3, "options.realtime.antiAliasing"));
    plan.lightReuse =
        LightReuse(checkEnum(o.realtime.lightReuse, 3, "options.realtime.lightReuse"));
    plan.indirectReuse =
        LightReuse(checkEnum(o.realtime.indirectReuse, 3, "options.realtime.indirectReuse"));
    plan.denoiser = Denoiser(checkEnum(o.realtime.denoiser, denoiserCount,
                                       "options.realtime.denoiser"));
    plan.parameters = parametersFrom(o.realtime);
    constexpr double longestStep = 3600;
    checkRange(o.realtime.timeStep, 0, longestStep, "options.realtime.timeStep");
    if (o.realtime.timeStep > 0) plan.timeStep = o.realtime.timeStep;
    plan.eye = eyeFrom(o.realtime.eyeAdaptation);
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
    if (const uint32_t size = o.realtime.skyCubeSize; size != 0) {
        checkRange(size, 16, 1024, "options.realtime.skyCubeSize");
        plan.frame.skyCubeSize = size;
    }
    plan.frame.width = std::max(1u, uint32_t(std::lround(scale * float(output.x))));
    plan.frame.height = std::max(1u, uint32_t(std::lround(scale * float(output.y))));
}

RealtimeResult renderRealtime(FrameObject& frame, SceneObject& scene,
                              const RealtimePlan& plan) {
    std::atomic<bool>& cancel = *frame.device->cancel;
    const RealtimeResult result =
        frame.realtime->render(*frame.device->backend, *scene.backendScene, scene.scene, plan,
                               frame.images, cancel);
    GpFrameStatistics& s = frame.statistics;
    s.samplesPerPixel = 1;
    s.cameraRays = result.rays.camera;
    s.bounceRays = result.rays.bounce;
    s.shadowRays = result.rays.shadow;
    s.secondsRender = result.secondsRender;
    s.exposureEv = result.exposureEv;
    s.accelerationBytes = scene.backendScene->accelerationBytes();
    frame.passes = result.passes;
    frame.rendered = !result.cancelled;
    return result;
}

void readImage(const FrameObject& frame, FrameImage which, void* pixels) {
    const bool drawn = which == FrameImage::color && !frame.images.drawn.empty();
    if (!frame.realtime || which == FrameImage::display || drawn) {
        readFrameImage(frame.images, which, pixels);
        return;
    }
    if (which == FrameImage::variance)
        fail(GP_ERROR_INVALID_OPERATION, "frames of GP_MODE_REALTIME have no variance image");
    readRealtimeImage(frame.realtime->images(), which, pixels);
}

namespace {

constexpr size_t layerCount = realtimeLayerCount + heatLayerCount;

// Heat maps stand behind the images.
HeatLayer heatLayer(size_t layer) { return HeatLayer(layer - realtimeLayerCount); }

const char* layerName(size_t layer) {
    return layer < realtimeLayerCount ? realtimeImageInfo(RealtimeImage(layer)).name
                                      : heatLayerInfo(heatLayer(layer)).name;
}

const char* layerMeaning(size_t layer) {
    return layer < realtimeLayerCount ? realtimeImageInfo(RealtimeImage(layer)).meaning
                                      : heatLayerInfo(heatLayer(layer)).meaning;
}

size_t layerNamed(const char* name) {
    std::vector<std::string> names;
    for (size_t i = 0; i < layerCount; ++i) {
        names.emplace_back(layerName(i));
        if (names.back() == name) return i;
    }
    const std::string nearest = nearestWord(name, names);
    fail(GP_ERROR_INVALID_ARGUMENT, "no layer has the name \"{}\"{}", name,
         nearest.empty() ? "" : " (did you mean " + nearest + "?)");
}

void readLayer(const RealtimeFrame& frame, size_t layer, glm::vec4* pixels) {
    if (layer < realtimeLayerCount) {
        if (!frame.images().holds(RealtimeImage(layer)))
            fail(GP_ERROR_INVALID_OPERATION,
                 "the frame has no layer \"{}\": neither its options (lightReuse, indirectReuse, "
                 "denoiser) nor its scene (suns over surfaces of slopes) make one",
                 layerName(layer));
        readRealtimeLayer(frame.images(), RealtimeImage(layer), pixels);
        return;
    }
    if (!hasHeatLayer(frame.heat(), frame.images(), heatLayer(layer)))
        fail(GP_ERROR_INVALID_OPERATION, "the frame has no layer {}: {}", layerName(layer),
             heatLayer(layer) == HeatLayer::variance
                 ? "its denoiser estimates none"
                 : "it was rendered without options.realtime.heatMaps");
    readHeatLayer(frame.heat(), frame.images(), heatLayer(layer), pixels);
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
        const size_t which = layerNamed(name);
        const size_t needed = f.images.pixelCount() * sizeof(glm::vec4);
        if (size < needed)
            fail(GP_ERROR_INVALID_OPERATION, "size is {}, but the layer has {} bytes", size,
                 needed);
        std::vector<glm::vec4> values(f.images.pixelCount());
        readLayer(*f.realtime, which, values.data());
        std::memcpy(pixels, values.data(), needed);
    });
}

GpError gpGetFrameLayerInfo(uint32_t index, const char** name, const char** meaning) {
    auto body = [&](Object*) {
        checkPointer(name, "name");
        checkPointer(meaning, "meaning");
        if (index >= layerCount)
            fail(GP_ERROR_OUT_OF_RANGE, "index is {}, but there are {} layers", index,
                 layerCount);
        *name = layerName(index);
        *meaning = layerMeaning(index);
    };
    return enterFree("gpGetFrameLayerInfo", BodyRef(body));
}

GpError gpDescribeDenoisers(GpDevice device, char* text, size_t size, size_t* needed) {
    return enter("gpDescribeDenoisers", "device", device, [&](DeviceObject&) {
        nlohmann::ordered_json all;
        for (size_t i = 0; i < gp::denoiserCount; ++i)
            all["denoisers"].push_back(gp::denoiserName(gp::Denoiser(i)));
        for (const gp::DenoiserParameterInfo& p : gp::denoiserParameters())
            all["parameters"].push_back({{"name", p.name},
                                         {"default", p.initial},
                                         {"minimum", p.minimum},
                                         {"maximum", p.maximum},
                                         {"meaning", p.text},
                                         {"used_by", gp::usersOf(p)}});
        giveText(all.dump(2), text, size, needed);
    });
}

}  // extern "C"
