#include "scene_setup.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "commands.h"
#include "material_setup.h"
#include "scene_description.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// Half the angle under which the sun is seen from here.
constexpr float kSunAngularRadius = 0.00465f;

// gpFrameScene looks from the front: this sun stands behind the viewer's left shoulder, so that
// shadows fall away to the right and forms show.
constexpr double kDefaultSunAzimuthDeg = 225;
constexpr double kDefaultSunElevationDeg = 40;

float radians(double degrees) {
    return static_cast<float>(degrees * kRadiansPerDegree);
}

void addSunLight(GpDevice device, GpScene scene, const SunSettings& sun) {
    const double azimuth = sun.azimuthDeg * kRadiansPerDegree;
    const double elevation = sun.elevationDeg * kRadiansPerDegree;
    GpLightDesc light{};
    light.kind = GP_LIGHT_DIRECTIONAL;
    light.unit = GP_UNIT_PHOTOMETRIC;
    light.intensity = static_cast<float>(sun.lux);
    // The light travels away from the sun.
    light.direction[0] = static_cast<float>(-std::sin(azimuth) * std::cos(elevation));
    light.direction[1] = static_cast<float>(-std::sin(elevation));
    light.direction[2] = static_cast<float>(std::cos(azimuth) * std::cos(elevation));
    light.angularRadius = kSunAngularRadius;
    light.name = "sun of the command line";
    GpLight handle = gpNewLight(scene, &light);
    if (handle == nullptr) {
        check(device, GP_ERROR_UNKNOWN);
    }
    check(device, gpReleaseLight(handle));
}

void addEnvironment(GpDevice device, GpScene scene, const RenderSettings& s) {
    GpEnvironmentDesc desc{};
    desc.rotation = radians(s.environmentRotationDeg);
    if (!s.environmentPath.empty()) {
        check(device, gpSetEnvironmentFromFile(scene, s.environmentPath.c_str(), &desc));
        return;
    }
    for (int c = 0; c < 3; ++c) {
        desc.color[c] = (*s.environmentColor)[static_cast<std::size_t>(c)];
    }
    check(device, gpSetEnvironment(scene, &desc));
}

}  // namespace

void addLight(GpDevice device, const RenderSettings& s, SceneSetup& setup) {
    const bool surrounded = !s.environmentPath.empty() || s.environmentColor;
    setup.skyAdded = !surrounded && !s.sun && isDark(device, setup.scene.get());
    setUpSurroundings(device, setup, s);
    if (surrounded && s.sun) {
        addSunLight(device, setup.scene.get(), *s.sun);
    }
    if (setup.skyAdded) {
        setup.notes.push_back(fmt::format(
            "the scene has no light: a clear sky is added (as by --sun {},{},0)",
            kDefaultSunAzimuthDeg, kDefaultSunElevationDeg));
    }
}

void addSceneChoice(CLI::App& app, GpLoadOptions& load) {
    const std::string group = "Content of the file";
    addWord(app, "--time", "S", "Seconds: where animations stand (default 0)",
            [&load](const std::string& word) { load.time = parseNumber("--time", word); })
        ->group(group);
    addWord(app, "--animation", "N|all",
            "Which animation plays, counted from 1, or all at once (default the first)",
            [&load](const std::string& word) {
                load.animation = word == "all" ? GP_ALL_ANIMATIONS
                                               : static_cast<std::uint32_t>(parseInteger(
                                                     "--animation", word, 1, 1u << 20));
            })->group(group);
    addWord(app, "--scene", "N", "Which of the file's scenes, counted from 1 (default the file's)",
            [&load](const std::string& word) {
                load.scene =
                    static_cast<std::uint32_t>(parseInteger("--scene", word, 1, 1u << 20));
            })->group(group);
}

void setUpSurroundings(GpDevice device, const SceneSetup& setup, const RenderSettings& s) {
    GpScene scene = setup.scene.get();
    if (!s.environmentPath.empty() || s.environmentColor) {
        addEnvironment(device, scene, s);
    } else if (s.sun) {
        check(device, gpSetSky(scene, radians(s.sun->azimuthDeg), radians(s.sun->elevationDeg),
                               static_cast<float>(s.sun->lux)));
    } else if (setup.skyAdded) {
        check(device, gpSetSky(scene, radians(kDefaultSunAzimuthDeg),
                               radians(kDefaultSunElevationDeg), 0.0f));
    } else {
        check(device, gpSetEnvironment(scene, nullptr));
    }
}

SceneSetup setUpScene(GpDevice device, const RenderSettings& settings) {
    const auto start = std::chrono::steady_clock::now();
    SceneSetup setup;
    setup.scene = newScene(device);
    check(device,
          gpLoadSceneFile(setup.scene.get(), settings.scenePath.c_str(), &settings.load));
    setup.notes = replaceMaterials(device, setup.scene.get(), settings.materials);
    addLight(device, settings, setup);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    setup.secondsLoad = taken.count();
    return setup;
}

}  // namespace gp::tool
