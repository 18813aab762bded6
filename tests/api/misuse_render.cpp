#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr float nanf = std::numeric_limits<float>::quiet_NaN();

Row optionRow(const char* what, GpError expected, const char* message,
              void (*change)(GpRenderOptions&)) {
    return {"gpRender", what, expected, message, [change](World& w) {
                GpRenderOptions options = fewSamples();
                change(options);
                return gpRender(w.frame, w.scene, nullptr, &options);
            }};
}

// The same for a frame of GP_MODE_LOCAL.
Row localRow(const char* what, GpError expected, const char* message,
             void (*change)(World&, GpRenderOptions&)) {
    return {"gpRender", what, expected, message, [change](World& w) {
                GpFrameDesc desc{};
                desc.width = desc.height = 2;
                desc.mode = GP_MODE_LOCAL;
                GpRenderOptions options = fewSamples();
                change(w, options);
                return gpRender(gpNewFrame(w.device, &desc), w.scene, nullptr, &options);
            }};
}

// The same for a frame of GP_MODE_REALTIME.
Row realtimeRow(const char* what, GpError expected, const char* message,
                void (*change)(GpRenderOptions&)) {
    return {"gpRender", what, expected, message, [change](World& w) {
                GpFrameDesc desc{};
                desc.width = desc.height = 2;
                desc.mode = GP_MODE_REALTIME;
                GpRenderOptions options{};
                change(options);
                return gpRender(gpNewFrame(w.device, &desc), w.scene, nullptr, &options);
            }};
}

Row cameraRow(const char* what, GpError expected, const char* message,
              void (*change)(GpCameraDesc&)) {
    return {"gpRender", what, expected, message, [change](World& w) {
                const GpRenderOptions options = fewSamples();
                GpCameraDesc camera{};
                change(camera);
                return gpRender(w.frame, w.scene, &camera, &options);
            }};
}

Row accumulateRow(const char* what, GpError expected, const char* message,
                  GpError (*render)(World&, const GpRenderOptions&)) {
    return {"gpRender", what, expected, message, [render](World& w) {
                GpRenderOptions options = fewSamples();
                options.accumulate = 1;
                return render(w, options);
            }};
}

void addRealtimeRows(Rows& rows) {
    const char* const refused = "is not for frames of GP_MODE_REALTIME";
    const Rows more = {
        optionRow("options of real time for the reference", GP_ERROR_INVALID_ARGUMENT,
                  "options.realtime is only for", [](GpRenderOptions& o) {
                      o.realtime.mirrorLimit = 2;
                  }),
        realtimeRow("several samples in real time", GP_ERROR_INVALID_ARGUMENT, refused,
                    [](GpRenderOptions& o) { o.samplesPerPixel = 2; }),
        realtimeRow("a time limit in real time", GP_ERROR_INVALID_ARGUMENT, refused,
                    [](GpRenderOptions& o) { o.timeLimit = 1; }),
        realtimeRow("a noise target in real time", GP_ERROR_INVALID_ARGUMENT, refused,
                    [](GpRenderOptions& o) { o.noiseTarget = 0.1; }),
        realtimeRow("a pixel filter in real time", GP_ERROR_INVALID_ARGUMENT, refused,
                    [](GpRenderOptions& o) { o.pixelFilter = GP_PIXEL_BOX; }),
        realtimeRow("a filter's radius in real time", GP_ERROR_INVALID_ARGUMENT, refused,
                    [](GpRenderOptions& o) { o.pixelFilterRadius = 1; }),
        realtimeRow("accumulation in real time", GP_ERROR_INVALID_ARGUMENT, refused,
                    [](GpRenderOptions& o) { o.accumulate = 1; }),
        realtimeRow("local lighting in real time", GP_ERROR_INVALID_ARGUMENT, "local.ambient",
                    [](GpRenderOptions& o) { o.local.ambient[0] = 1; }),
        realtimeRow("too many mirrors", GP_ERROR_OUT_OF_RANGE, "mirrorLimit is 17",
                    [](GpRenderOptions& o) { o.realtime.mirrorLimit = 17; }),
        realtimeRow("fewer than no mirrors", GP_ERROR_OUT_OF_RANGE, "mirrorLimit is -2",
                    [](GpRenderOptions& o) { o.realtime.mirrorLimit = -2; }),
        realtimeRow("too few rays", GP_ERROR_OUT_OF_RANGE, "renderScale is 0.4",
                    [](GpRenderOptions& o) { o.realtime.renderScale = 0.4f; }),
        realtimeRow("a scale that is no number", GP_ERROR_NOT_FINITE, "renderScale",
                    [](GpRenderOptions& o) { o.realtime.renderScale = nanf; }),
        realtimeRow("unknown denoiser", GP_ERROR_INVALID_ARGUMENT, "denoiser is 5",
                    [](GpRenderOptions& o) { o.realtime.denoiser = anyEnum<GpDenoiser>(5); }),
        realtimeRow("unknown light reuse", GP_ERROR_INVALID_ARGUMENT, "lightReuse is 3",
                    [](GpRenderOptions& o) { o.realtime.lightReuse = anyEnum<GpLightReuse>(3); }),
        realtimeRow("unknown indirect reuse", GP_ERROR_INVALID_ARGUMENT, "indirectReuse is 3",
                    [](GpRenderOptions& o) {
                        o.realtime.indirectReuse = anyEnum<GpLightReuse>(3);
                    }),
        realtimeRow("parameters that are not there", GP_ERROR_INVALID_ARGUMENT,
                    "parameters is NULL",
                    [](GpRenderOptions& o) { o.realtime.parameterCount = 1; }),
        realtimeRow("a parameter without name", GP_ERROR_INVALID_ARGUMENT,
                    "parameters[0].name is NULL", [](GpRenderOptions& o) {
                        static const GpDenoiserParameter nameless{};
                        o.realtime.parameters = &nameless, o.realtime.parameterCount = 1;
                    }),
        realtimeRow("an unknown parameter", GP_ERROR_INVALID_ARGUMENT,
                    "did you mean filter_depth?", [](GpRenderOptions& o) {
                        static const GpDenoiserParameter p{"filter_dept", 1};
                        o.realtime.parameters = &p, o.realtime.parameterCount = 1;
                    }),
        realtimeRow("a parameter out of range", GP_ERROR_OUT_OF_RANGE, "reuse_candidates, is 99",
                    [](GpRenderOptions& o) {
                        static const GpDenoiserParameter p{"reuse_candidates", 99};
                        o.realtime.parameters = &p, o.realtime.parameterCount = 1;
                    }),
        realtimeRow("time that runs back", GP_ERROR_OUT_OF_RANGE, "timeStep is -1",
                    [](GpRenderOptions& o) { o.realtime.timeStep = -1; }),
        realtimeRow("an eye that never adapts", GP_ERROR_NOT_FINITE, "eyeAdaptation.seconds",
                    [](GpRenderOptions& o) { o.realtime.eyeAdaptation.seconds = nanf; }),
        realtimeRow("an eye without range", GP_ERROR_OUT_OF_RANGE, "above evMax",
                    [](GpRenderOptions& o) { o.realtime.eyeAdaptation.evMin = 1; }),
        realtimeRow("unknown anti-aliasing", GP_ERROR_INVALID_ARGUMENT, "antiAliasing is 3",
                    [](GpRenderOptions& o) {
                        o.realtime.antiAliasing = anyEnum<GpAntiAliasing>(3);
                    }),
    };
    rows.insert(rows.end(), more.begin(), more.end());
}

void addOptionRows(Rows& rows) {
    const Rows more = {
        optionRow("time limit below 0", GP_ERROR_OUT_OF_RANGE, "options.timeLimit is -1",
                  [](GpRenderOptions& o) { o.timeLimit = -1; }),
        optionRow("time limit is NaN", GP_ERROR_NOT_FINITE, "options.timeLimit",
                  [](GpRenderOptions& o) { o.timeLimit = nan; }),
        optionRow("noise target below 0", GP_ERROR_OUT_OF_RANGE, "options.noiseTarget",
                  [](GpRenderOptions& o) { o.noiseTarget = -0.5; }),
        optionRow("noise target is infinite", GP_ERROR_NOT_FINITE, "options.noiseTarget is inf",
                  [](GpRenderOptions& o) { o.noiseTarget = inf; }),
        optionRow("bounces below none", GP_ERROR_OUT_OF_RANGE, "options.maxBounces is -2",
                  [](GpRenderOptions& o) { o.maxBounces = -2; }),
        optionRow("unknown shading", GP_ERROR_INVALID_ARGUMENT, "options.shading",
                  [](GpRenderOptions& o) { o.shading = anyEnum<GpShading>(2); }),
        optionRow("unknown filter", GP_ERROR_INVALID_ARGUMENT, "options.pixelFilter",
                  [](GpRenderOptions& o) { o.pixelFilter = anyEnum<GpPixelFilter>(4); }),
        optionRow("filter too wide", GP_ERROR_OUT_OF_RANGE, "options.pixelFilterRadius is 17",
                  [](GpRenderOptions& o) { o.pixelFilterRadius = 17; }),
        optionRow("filter below 0", GP_ERROR_OUT_OF_RANGE, "options.pixelFilterRadius",
                  [](GpRenderOptions& o) { o.pixelFilterRadius = -1; }),
        optionRow("clamp below 0", GP_ERROR_OUT_OF_RANGE, "options.clamp",
                  [](GpRenderOptions& o) { o.clamp = -1; }),
        optionRow("clamp is NaN", GP_ERROR_NOT_FINITE, "options.clamp",
                  [](GpRenderOptions& o) { o.clamp = nanf; }),
        optionRow("exposure out of range", GP_ERROR_OUT_OF_RANGE, "exposureEv",
                  [](GpRenderOptions& o) { o.exposureEv = -200; }),
        optionRow("rays shorter than nothing", GP_ERROR_OUT_OF_RANGE, "options.rayLength is -1",
                  [](GpRenderOptions& o) { o.rayLength = -1; }),
        optionRow("ray length is NaN", GP_ERROR_NOT_FINITE, "options.rayLength",
                  [](GpRenderOptions& o) { o.rayLength = nanf; }),
        optionRow("the sky's viewer is NaN", GP_ERROR_NOT_FINITE, "options.skyViewerPosition[1]",
                  [](GpRenderOptions& o) { o.skyViewerPosition[1] = nanf; }),
        optionRow("the sky's scale is infinite", GP_ERROR_NOT_FINITE, "options.skyScale",
                  [](GpRenderOptions& o) { o.skyScale = float(inf); }),
        realtimeRow("a sky cube that is too small", GP_ERROR_OUT_OF_RANGE,
                    "options.realtime.skyCubeSize is 8",
                    [](GpRenderOptions& o) { o.realtime.skyCubeSize = 8; }),
        realtimeRow("a sky cube that is too large", GP_ERROR_OUT_OF_RANGE,
                    "options.realtime.skyCubeSize is 2048",
                    [](GpRenderOptions& o) { o.realtime.skyCubeSize = 2048; }),
        optionRow("a sky cube in another mode", GP_ERROR_INVALID_ARGUMENT,
                  "options.realtime is only for",
                  [](GpRenderOptions& o) { o.realtime.skyCubeSize = 64; }),
        optionRow("unknown tone map", GP_ERROR_INVALID_ARGUMENT, "options.tonemap",
                  [](GpRenderOptions& o) { o.tonemap = anyEnum<GpTonemap>(99); }),
    };
    rows.insert(rows.end(), more.begin(), more.end());
}

void addLocalRows(Rows& rows) {
    const Rows more = {
        optionRow("a falloff for the path tracer", GP_ERROR_INVALID_ARGUMENT,
                  "options.local.falloff is only for frames of GP_MODE_LOCAL",
                  [](GpRenderOptions& o) { o.local.falloff = GP_FALLOFF_NONE; }),
        optionRow("a filter of highlights for the path tracer", GP_ERROR_INVALID_ARGUMENT,
                  "options.local.ndfFilter is only for frames of GP_MODE_LOCAL",
                  [](GpRenderOptions& o) { o.local.ndfFilter = GP_NDF_FILTER_TOKUYOSHI; }),
        optionRow("facets for the path tracer", GP_ERROR_INVALID_ARGUMENT,
                  "options.local.environmentFacets is only for frames of GP_MODE_LOCAL",
                  [](GpRenderOptions& o) { o.local.environmentFacets = 9; }),
        localRow("another number of facets", GP_ERROR_INVALID_ARGUMENT,
                 "options.local.environmentFacets is 10, not 0, 9, 16 or 25",
                 [](World&, GpRenderOptions& o) { o.local.environmentFacets = 10; }),
        optionRow("a frequency for the path tracer", GP_ERROR_INVALID_ARGUMENT,
                  "options.local.frequency is only for frames of GP_MODE_LOCAL",
                  [](GpRenderOptions& o) { o.local.frequency = GP_FREQUENCY_VERTEX; }),
        optionRow("ambient light for the path tracer", GP_ERROR_INVALID_ARGUMENT,
                  "options.local.ambient is only for frames of GP_MODE_LOCAL",
                  [](GpRenderOptions& o) { o.local.ambient[2] = 1; }),
        {"gpRender", "a lighting model for the path tracer", GP_ERROR_INVALID_ARGUMENT,
         "options.local.model is only for frames of GP_MODE_LOCAL",
         [](World& w) {
             GpRenderOptions options = fewSamples();
             options.local.model = w.bsdf;
             return gpRender(w.frame, w.scene, nullptr, &options);
         }},
        localRow("bounces of a local frame", GP_ERROR_INVALID_ARGUMENT,
                 "options.maxBounces is only for frames of GP_MODE_REFERENCE",
                 [](World&, GpRenderOptions& o) { o.maxBounces = 3; }),
        localRow("clamp of a local frame", GP_ERROR_INVALID_ARGUMENT, "options.clamp is only",
                 [](World&, GpRenderOptions& o) { o.clamp = 3; }),
        localRow("roulette of a local frame", GP_ERROR_INVALID_ARGUMENT,
                 "options.noRussianRoulette is only",
                 [](World&, GpRenderOptions& o) { o.noRussianRoulette = 1; }),
        localRow("unknown frequency", GP_ERROR_INVALID_ARGUMENT, "options.local.frequency is 3",
                 [](World&, GpRenderOptions& o) {
                     o.local.frequency = anyEnum<GpShadingFrequency>(3);
                 }),
        localRow("unknown falloff", GP_ERROR_INVALID_ARGUMENT, "options.local.falloff is 7",
                 [](World&, GpRenderOptions& o) { o.local.falloff = anyEnum<GpFalloff>(7); }),
        localRow("unknown filter of highlights", GP_ERROR_INVALID_ARGUMENT,
                 "options.local.ndfFilter is 4",
                 [](World&, GpRenderOptions& o) { o.local.ndfFilter = anyEnum<GpNdfFilter>(4); }),
        localRow("highlights filtered at corners", GP_ERROR_INVALID_ARGUMENT,
                 "only with GP_FREQUENCY_PIXEL",
                 [](World&, GpRenderOptions& o) {
                     o.local.frequency = GP_FREQUENCY_VERTEX;
                     o.local.ndfFilter = GP_NDF_FILTER_DEFERRED;
                 }),
        localRow("ambient below 0", GP_ERROR_OUT_OF_RANGE, "options.local.ambient[1] is -1",
                 [](World&, GpRenderOptions& o) { o.local.ambient[1] = -1; }),
        localRow("ambient is NaN", GP_ERROR_NOT_FINITE, "options.local.ambient[0]",
                 [](World&, GpRenderOptions& o) { o.local.ambient[0] = nanf; }),
        localRow("model was released", GP_ERROR_INVALID_HANDLE,
                 "options.local.model was released",
                 [](World& w, GpRenderOptions& o) { o.local.model = w.released.bsdf; }),
        localRow("model of another device", GP_ERROR_INVALID_HANDLE,
                 "options.local.model belongs to another device",
                 [](World& w, GpRenderOptions& o) { o.local.model = w.foreign.bsdf; }),
        localRow("two ways to replace materials", GP_ERROR_INVALID_ARGUMENT, "not both",
                 [](World& w, GpRenderOptions& o) {
                     o.local.model = w.bsdf;
                     o.shading = GP_SHADING_DIFFUSE;
                 }),
    };
    rows.insert(rows.end(), more.begin(), more.end());
}

void addCameraRows(Rows& rows) {
    const Rows more = {
        cameraRow("unknown camera", GP_ERROR_INVALID_ARGUMENT, "camera.kind",
                  [](GpCameraDesc& c) { c.kind = anyEnum<GpCameraKind>(2); }),
        cameraRow("position is NaN", GP_ERROR_NOT_FINITE, "camera.position[0]",
                  [](GpCameraDesc& c) { c.position[0] = nanf; }),
        cameraRow("target is NaN", GP_ERROR_NOT_FINITE, "camera.target[2]",
                  [](GpCameraDesc& c) { c.target[2] = nanf; }),
        cameraRow("too far away to see anything", GP_ERROR_OUT_OF_RANGE, "no direction",
                  [](GpCameraDesc& c) { c.position[2] = c.target[2] = 1e20f; }),
        cameraRow("up is NaN", GP_ERROR_NOT_FINITE, "camera.up[1]",
                  [](GpCameraDesc& c) { c.up[1] = nanf; }),
        cameraRow("up along the view", GP_ERROR_OUT_OF_RANGE, "camera.up is parallel",
                  [](GpCameraDesc& c) { c.up[2] = 2; }),
        cameraRow("field of view below 0", GP_ERROR_OUT_OF_RANGE, "camera.verticalFov",
                  [](GpCameraDesc& c) { c.verticalFov = -1; }),
        cameraRow("field of view of pi", GP_ERROR_OUT_OF_RANGE, "camera.verticalFov",
                  [](GpCameraDesc& c) { c.verticalFov = 3.14159274f; }),
        cameraRow("height below 0", GP_ERROR_OUT_OF_RANGE, "camera.orthographicHeight",
                  [](GpCameraDesc& c) { c.orthographicHeight = -2; }),
        cameraRow("aperture below 0", GP_ERROR_OUT_OF_RANGE, "camera.apertureRadius",
                  [](GpCameraDesc& c) { c.apertureRadius = -1; }),
        cameraRow("focus is NaN", GP_ERROR_NOT_FINITE, "camera.focusDistance",
                  [](GpCameraDesc& c) { c.focusDistance = nanf; }),
    };
    rows.insert(rows.end(), more.begin(), more.end());
}

}  // namespace

Rows renderRows() {
    Rows rows = {
        {"gpRender", "scene of another device", GP_ERROR_INVALID_HANDLE,
         "scene belongs to another device",
         [](World& w) { return gpRender(w.frame, w.foreign.scene, nullptr, nullptr); }},
        accumulateRow("onto another scene", GP_ERROR_INVALID_OPERATION, "another scene",
                      [](World& w, const GpRenderOptions& options) {
                          const GpScene empty = gpNewScene(w.device);
                          return gpRender(w.frame, empty, nullptr, &options);
                      }),
        accumulateRow("onto another view", GP_ERROR_INVALID_OPERATION, "another view",
                      [](World& w, const GpRenderOptions& options) {
                          GpCameraDesc camera{};
                          camera.position[0] = 5;
                          return gpRender(w.frame, w.scene, &camera, &options);
                      }),
        accumulateRow("onto what shows a background", GP_ERROR_INVALID_OPERATION,
                      "another hideBackground", [](World& w, const GpRenderOptions& options) {
                          GpRenderOptions hidden = options;
                          hidden.hideBackground = 1;
                          return gpRender(w.frame, w.scene, nullptr, &hidden);
                      }),
        accumulateRow("more samples than can be counted", GP_ERROR_TOO_LARGE, "added to 2",
                      [](World& w, const GpRenderOptions& options) {
                          GpRenderOptions many = options;
                          many.samplesPerPixel = 4294967294u;
                          return gpRender(w.frame, w.scene, nullptr, &many);
                      }),
    };
    addOptionRows(rows);
    addLocalRows(rows);
    addRealtimeRows(rows);
    addCameraRows(rows);
    addHandleRows<GpFrame>(rows, "gpRender", "frame", [](World& w, GpFrame f) {
        return gpRender(f, w.scene, nullptr, nullptr);
    });
    addHandleRows<GpScene>(rows, "gpRender", "scene", [](World& w, GpScene s) {
        return gpRender(w.frame, s, nullptr, nullptr);
    });
    return rows;
}

}  // namespace gp::test
