// The sea.
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

Row seaRow(const char* what, GpError expected, const char* message,
           void (*change)(GpOceanDesc&)) {
    return {"gpSetOcean", what, expected, message, [change](World& w) {
                GpOceanDesc desc{};
                change(desc);
                return gpSetOcean(w.scene, &desc);
            }};
}

// Most worlds have no sea; a row that needs one gives its own scene to the world's device.
GpScene sceneWithSea(World& w) {
    const GpScene scene = gpNewScene(w.device);
    GpOceanDesc desc{};
    desc.cascades = 1;
    gpSetOcean(scene, &desc);
    return scene;
}

Row sampleRow(const char* what, GpError expected, const char* message, size_t count,
              const float* points, bool hasSamples) {
    return {"gpSampleOcean", what, expected, message, [=](World& w) {
                static GpOceanSample samples[2];
                return gpSampleOcean(sceneWithSea(w), count, points,
                                     hasSamples ? samples : nullptr);
            }};
}

Row timeRow(const char* what, GpError expected, const char* message, double seconds) {
    return {"gpSetOceanTime", what, expected, message,
            [=](World& w) { return gpSetOceanTime(sceneWithSea(w), seconds); }};
}

Rows seaRows() {
    return {
        seaRow("unknown bits", GP_ERROR_INVALID_ARGUMENT, "given is 0x80000000",
               [](GpOceanDesc& d) { d.given = 0x80000000u; }),
        seaRow("unknown spectrum", GP_ERROR_INVALID_ARGUMENT, "spectrum is 9",
               [](GpOceanDesc& d) { d.spectrum = anyEnum<GpOceanSpectrum>(9); }),
        seaRow("wind is NaN", GP_ERROR_NOT_FINITE, "wind is nan",
               [](GpOceanDesc& d) { d.wind = nan; }),
        seaRow("a wind that blows nowhere", GP_ERROR_OUT_OF_RANGE, "wind is -1",
               [](GpOceanDesc& d) { d.wind = -1; }),
        seaRow("no direction", GP_ERROR_NOT_FINITE, "windDirection is inf",
               [](GpOceanDesc& d) { d.windDirection = inf; }),
        seaRow("a short fetch", GP_ERROR_OUT_OF_RANGE, "fetch is 1",
               [](GpOceanDesc& d) { d.fetch = 1; }),
        seaRow("negative depth", GP_ERROR_OUT_OF_RANGE, "depth is -3",
               [](GpOceanDesc& d) { d.depth = -3; }),
        seaRow("shallow without a depth", GP_ERROR_INVALID_ARGUMENT, "needs a depth",
               [](GpOceanDesc& d) { d.spectrum = GP_SPECTRUM_TMA; }),
        seaRow("swell above 1", GP_ERROR_OUT_OF_RANGE, "swell is 2",
               [](GpOceanDesc& d) { d.swell = 2; }),
        seaRow("too choppy", GP_ERROR_OUT_OF_RANGE, "choppiness is 3",
               [](GpOceanDesc& d) { d.choppiness = 3; }),
        seaRow("too many cascades", GP_ERROR_OUT_OF_RANGE, "cascades is 5",
               [](GpOceanDesc& d) { d.cascades = 5; }),
        seaRow("a sea on the moon", GP_ERROR_OUT_OF_RANGE, "level is",
               [](GpOceanDesc& d) { d.level = 3.8e8f; }),
        seaRow("two cells", GP_ERROR_OUT_OF_RANGE, "resolution is 2",
               [](GpOceanDesc& d) { d.resolution = 2; }),
        seaRow("absorption is NaN", GP_ERROR_NOT_FINITE, "absorption[1] is nan",
               [](GpOceanDesc& d) { d.absorption[1] = nan; }),
        seaRow("negative scattering", GP_ERROR_OUT_OF_RANGE, "scattering[0] is -1",
               [](GpOceanDesc& d) { d.scattering[0] = -1; }),
        seaRow("water like vacuum", GP_ERROR_OUT_OF_RANGE, "ior is 1",
               [](GpOceanDesc& d) { d.ior = 1; }),
        seaRow("foam above 1", GP_ERROR_OUT_OF_RANGE, "foam is 2",
               [](GpOceanDesc& d) { d.foam = 2; }),
        seaRow("glints that nobody knows", GP_ERROR_INVALID_ARGUMENT, "glints is 3",
               [](GpOceanDesc& d) { d.glints = anyEnum<GpOceanGlints>(3); }),
        seaRow("negative facets", GP_ERROR_OUT_OF_RANGE, "glintDensity is -5",
               [](GpOceanDesc& d) { d.glintDensity = -5; }),
        seaRow("masking that nobody knows", GP_ERROR_INVALID_ARGUMENT, "masking is 7",
               [](GpOceanDesc& d) { d.masking = anyEnum<GpOceanMasking>(7); }),
        timeRow("never", GP_ERROR_NOT_FINITE, "seconds is nan", double(nan)),
        timeRow("for ever", GP_ERROR_OUT_OF_RANGE, "seconds is", 1e9),
    };
}

}  // namespace

Rows oceanRows() {
    static const float points[4] = {1, 2, 3, nan};
    Rows rows = seaRows();
    rows.push_back({"gpSetOceanTime", "no sea", GP_ERROR_INVALID_OPERATION, "has no sea",
                    [](World& w) { return gpSetOceanTime(w.scene, 1); }});
    rows.push_back({"gpSampleOcean", "no sea", GP_ERROR_INVALID_OPERATION, "has no sea",
                    [](World& w) {
                        GpOceanSample sample;
                        return gpSampleOcean(w.scene, 1, points, &sample);
                    }});
    rows.push_back(sampleRow("no points", GP_ERROR_INVALID_ARGUMENT, "points is NULL", 1, nullptr,
                             true));
    rows.push_back(sampleRow("nowhere to write", GP_ERROR_INVALID_ARGUMENT, "samples is NULL", 1,
                             points, false));
    rows.push_back(sampleRow("a point that is NaN", GP_ERROR_NOT_FINITE, "points[3] is nan", 2,
                             points, true));
    rows.push_back(sampleRow("too many", GP_ERROR_TOO_LARGE, "count is 16777217",
                             (size_t(1) << 24) + 1, points, true));
    rows.push_back({"gpSaveOceanMaps", "no sea", GP_ERROR_INVALID_OPERATION, "has no sea",
                    [](World& w) { return gpSaveOceanMaps(w.scene, w.folder.c_str()); }});
    rows.push_back({"gpSaveOceanMaps", "no folder", GP_ERROR_INVALID_ARGUMENT, "path is NULL",
                    [](World& w) { return gpSaveOceanMaps(sceneWithSea(w), nullptr); }});
    rows.push_back({"gpSaveOceanMaps", "a folder that is not there", GP_ERROR_FILE_WRITE,
                    "not-there", [](World& w) {
                        const std::string folder = w.folder + "not-there";
                        return gpSaveOceanMaps(sceneWithSea(w), folder.c_str());
                    }});
    addHandleRows<GpScene>(rows, "gpSaveOceanMaps", "scene",
                           [](World&, GpScene s) { return gpSaveOceanMaps(s, "."); });
    addHandleRows<GpScene>(rows, "gpSetOcean", "scene", [](World&, GpScene s) {
        const GpOceanDesc zeros{};
        return gpSetOcean(s, &zeros);
    });
    addHandleRows<GpScene>(rows, "gpSetOceanTime", "scene",
                           [](World&, GpScene s) { return gpSetOceanTime(s, 1); });
    addHandleRows<GpScene>(rows, "gpSampleOcean", "scene", [](World&, GpScene s) {
        GpOceanSample sample;
        return gpSampleOcean(s, 1, points, &sample);
    });
    return rows;
}

}  // namespace gp::test
