// What `glitterpath render` was asked for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "library.h"
#include "local_settings.h"
#include "parse.h"

namespace CLI {
class App;
}

namespace gp::tool {

// page: what holds opaque pictures, a video or a sheet of several.
enum class PictureFormat { png, exr, hdr, page };

struct SunSettings {
    double azimuthDeg = 0;    // from -Z towards +X
    double elevationDeg = 0;  // above the horizon
    double lux = 0;           // on a plane that faces it
};

// --tune: numbers of the real-time mode, with what their names are kept in.
struct Tuning {
    std::vector<std::string> words;  // NAME=VALUE, as written
    std::vector<std::string> names;
    std::vector<GpDenoiserParameter> parameters;
};

struct RenderSettings {
    std::string scenePath, outputPath, jsonPath;
    GpLoadOptions load{};
    std::vector<std::string> materials;  // --material, as written
    Size size{1280, 720};
    bool sizeGiven = false, quiet = false;

    // light
    std::string environmentPath;
    double environmentRotationDeg = 0;
    std::optional<std::array<float, 3>> environmentColor;
    std::optional<SunSettings> sun;

    // camera
    std::string camera;
    std::optional<std::array<float, 3>> from, lookAt;
    std::optional<double> fovDeg;

    // quality; zeros are the library's defaults
    GpRenderOptions options{};
    std::uint32_t bounces = 16;

    // real time
    Tuning tuning;
    std::uint32_t frames = 16;  // of `render --mode realtime`

    // --mode, and what belongs to local lighting
    LocalSettings local;

    // the picture
    std::optional<double> exposureEv;  // none: automatic
    bool exposureGiven = false, tonemapGiven = false;
    bool everyLayer = false;  // --aov all
    GpSaveOptions save{};

    GpDeviceDesc device{};
    std::string instructionSet;
};

// All options of `render`. The settings must outlive the parsing, here and below.
void addRenderOptions(CLI::App& app, RenderSettings& settings);

// Groups of them, which other commands have too.
void addSceneOptions(CLI::App& app, RenderSettings& settings);    // the file, and what of it
void addCameraOptions(CLI::App& app, RenderSettings& settings);
void addLightOptions(CLI::App& app, RenderSettings& settings);
void addQualityOptions(CLI::App& app, RenderSettings& settings);
void addPictureOptions(CLI::App& app, RenderSettings& settings);
void addMachineOptions(CLI::App& app, RenderSettings& settings);

// "AZ,EL" or "AZ,EL,LUX", of --sun, at `lowest` degrees or higher; throws UsageError.
SunSettings parseSun(const std::string& word, double lowest);

// By the ending of the name; throws UsageError.
PictureFormat pictureFormat(const std::string& path);

// What no single option can know by itself; throws UsageError. `app` is that of
// addRenderOptions. The options of real time point into the settings then.
void checkSettings(const CLI::App& app, RenderSettings& settings);
// The parts of it that belong to the groups. format: of what is written.
void checkLightSettings(const RenderSettings& settings);
void checkPictureSettings(const RenderSettings& settings, PictureFormat format);

}  // namespace gp::tool
