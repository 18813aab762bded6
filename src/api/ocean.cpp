#include <limits>
#include <numbers>

#include <tbb/parallel_for.h>

#include "api/check.h"
#include "io/image_file.h"
#include "scene/sea.h"

namespace gp::api {

namespace {

static_assert(GP_SPECTRUM_JONSWAP == int(OceanSpectrum::jonswap) &&
              GP_SPECTRUM_TMA == int(OceanSpectrum::tma) &&
              GP_SPECTRUM_PHILLIPS == int(OceanSpectrum::phillips) &&
              GP_SPECTRUM_PIERSON_MOSKOWITZ == int(OceanSpectrum::piersonMoskowitz));
static_assert(GP_GLINTS_OFF == int(SeaGlints::smooth) &&
              GP_GLINTS_ON == int(SeaGlints::dictionary) &&
              GP_GLINTS_COUNTING == int(SeaGlints::counting) &&
              GP_MASKING_SMITH == int(SeaMasking::smith));

// A number in its range, or its default where it is zero and not given.
float numberOr(float value, float fallback, bool given, double lo, double hi, const char* field) {
    if (value == 0 && !given) return fallback;
    // 1.01f is below 1.01, and is in the range that begins there.
    checkRange(value, double(float(lo)), double(float(hi)), field);
    return value;
}

glm::vec3 coefficientsOr(const float (&values)[3], glm::vec3 fallback, bool given,
                         const char* field) {
    constexpr double most = 1000;
    checkRange(values, 3, 0, most, field);
    return !given && allZero(values, 3) ? fallback : vec3From(values);
}

OceanSettings wavesFrom(const GpOceanDesc& d) {
    OceanSettings waves;
    waves.spectrum = OceanSpectrum(checkEnum(d.spectrum, 4, "spectrum"));
    waves.windSpeed = numberOr(d.wind, 10, d.given & GP_GIVEN_WIND, 0, 100, "wind");
    checkFinite(d.windDirection, "windDirection");
    // From -Z towards +X here, from x (+X) towards y (-Z) there.
    waves.windDirection = float(std::remainder(std::numbers::pi / 2 - double(d.windDirection),
                                               2 * std::numbers::pi));
    waves.fetch = numberOr(d.fetch, 1.0e5f, false, 100, 1e7, "fetch");
    waves.depth = numberOr(d.depth, std::numeric_limits<float>::infinity(), false, 0.1, 1e4,
                           "depth");
    if (waves.spectrum == OceanSpectrum::tma && d.depth == 0)
        fail(GP_ERROR_INVALID_ARGUMENT, "spectrum is GP_SPECTRUM_TMA, which needs a depth");
    checkRange(d.swell, 0, 1, "swell");
    waves.swell = d.swell;
    waves.choppiness =
        numberOr(d.choppiness, 1, d.given & GP_GIVEN_CHOPPINESS, 0, 2, "choppiness");
    waves.seed = d.seed;
    if (d.cascades > oceanMostCascades)
        fail(GP_ERROR_OUT_OF_RANGE, "cascades is {}, more than {}", d.cascades,
             oceanMostCascades);
    if (d.cascades != 0) waves.cascades = d.cascades;
    // Of the fourth, which the waves' own defaults leave out: down to ripples of 5 mm.
    constexpr float finest = 0.613f;
    if (waves.cascades == oceanMostCascades) waves.lengths.back() = finest;
    return waves;
}

// [Pope and Fry 1997, "Absorption spectrum (380-700 nm) of pure water", Applied Optics 36(33)] at
// 610, 550 and 465 nm: 0.264, 0.0565 and 0.0101; the rest is what lives and is dissolved in it.
const glm::vec3 seaAbsorption{0.27f, 0.065f, 0.03f};
// [Morel 1974, "Optical properties of pure water and pure sea water"]: half of the scattering of
// sea water, 0.0006, 0.001 and 0.002, and 0.001 of particles.
const glm::vec3 seaBackscattering{0.0016f, 0.002f, 0.003f};

SeaSettings settingsFrom(const GpOceanDesc& d) {
    if (d.given & ~uint32_t(GP_GIVEN_ALL_OCEAN))
        fail(GP_ERROR_INVALID_ARGUMENT, "given is {:#x}, which has unknown bits", d.given);
    SeaSettings s;
    s.waves = wavesFrom(d);
    constexpr double highest = 1e6;
    checkRange(d.level, -highest, highest, "level");
    s.level = d.level;
    if (d.resolution != 0) {
        checkRange(d.resolution, seaSectorsLeast, seaSectorsMost, "resolution");
        s.sectors = d.resolution;
    }
    s.absorption = coefficientsOr(d.absorption, seaAbsorption, d.given & GP_GIVEN_ABSORPTION,
                                  "absorption");
    s.backscattering = coefficientsOr(d.scattering, seaBackscattering,
                                      d.given & GP_GIVEN_SCATTERING, "scattering");
    s.glints = SeaGlints(checkEnum(d.glints, 3, "glints"));
    s.facetDensity = numberOr(d.glintDensity, 1e6f, false, 1, 1e12, "glintDensity");
    s.masking = SeaMasking(checkEnum(d.masking, 2, "masking"));
    s.foam = numberOr(d.foam, 1, d.given & GP_GIVEN_FOAM, 0, 1, "foam");
    s.clear = d.transparent != 0;
    s.ior = numberOr(d.ior, 1.333f, false, 1.01, 3, "ior");
    if (const std::string fault = oceanFault(s.waves); !fault.empty())
        fail(GP_ERROR_OUT_OF_RANGE, "{}", fault);
    return s;
}

void replaceSea(Scene& scene, std::shared_ptr<Sea> sea) {
    if (sea) scene.instances.reserve(scene.instances.size() + 1);  // the last step that can fail
    std::erase_if(scene.instances, [](const auto& instance) { return instance->ofSea; });
    if (sea) scene.instances.push_back(sea->instance());
    scene.sea = std::move(sea);
    ++scene.revision;
}

Sea& seaOf(const SceneObject& s) {
    if (!s.scene.sea) fail(GP_ERROR_INVALID_OPERATION, "the scene has no sea (gpSetOcean)");
    return *s.scene.sea;
}

// Each map that was written before one that fails stays.
void saveMaps(const Ocean& ocean, const std::string& folder) {
    constexpr std::string_view letters = "RGBAXYZW";
    for (const OceanMap& map : ocean.maps()) {
        // One channel alone is luminance by name, as readers of pictures want it.
        const std::string names(map.channels == 1 ? "Y" : letters.substr(0, map.channels));
        const io::ImageLayer layer{"", names,
                                   map.texels.data()};
        io::saveExr(folder + "/" + map.name + ".exr", map.size, map.size, {&layer, 1},
                    io::ExrPixel::float32);
    }
}

GpOceanSample sampleFrom(const SeaPoint& point) {
    return {point.height, {point.normal.x, point.normal.y, point.normal.z}, point.foam};
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpSetOcean(GpScene scene, const GpOceanDesc* desc) {
    return enter("gpSetOcean", "scene", scene, [&](SceneObject& s) {
        if (!desc && !s.scene.sea) return;
        replaceSea(s.scene, desc ? std::make_shared<gp::Sea>(settingsFrom(*desc)) : nullptr);
    });
}

GpError gpSetOceanTime(GpScene scene, double seconds) {
    return enter("gpSetOceanTime", "scene", scene, [&](SceneObject& s) {
        constexpr double longest = 1e6;
        gp::Sea& sea = seaOf(s);
        checkRange(seconds, -longest, longest, "seconds");
        sea.setTime(seconds);
        ++s.scene.revision;
    });
}

GpError gpSampleOcean(GpScene scene, size_t count, const float* points, GpOceanSample* samples) {
    return enter("gpSampleOcean", "scene", scene, [&](SceneObject& s) {
        const gp::Sea& sea = seaOf(s);
        constexpr size_t most = size_t(1) << 24;
        if (count == 0) return;
        if (count > most) fail(GP_ERROR_TOO_LARGE, "count is {}, more than 2^24", count);
        checkPointer(points, "points");
        checkPointer(samples, "samples");
        checkFinite(points, 2 * count, "points");
        tbb::parallel_for(size_t(0), count, [&](size_t i) {
            samples[i] = sampleFrom(sea.at(points[2 * i], points[2 * i + 1]));
        });
    });
}

GpError gpSaveOceanMaps(GpScene scene, const char* folder) {
    return enter("gpSaveOceanMaps", "scene", scene, [&](SceneObject& s) {
        checkPath(folder);
        saveMaps(seaOf(s).ocean(), folder);
    });
}

}  // extern "C"
