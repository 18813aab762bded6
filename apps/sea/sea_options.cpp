#include "sea/sea_options.h"

#include <cmath>
#include <numbers>

#include "commands.h"

namespace gp::tool {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kStandardFovDeg = 45;

}  // namespace

GpCameraDesc SeaCamera::over(const GpOceanDesc& sea, std::optional<double> fovDeg) const {
    const double up = pitchDeg * kRadiansPerDegree;
    const double right = headingDeg * kRadiansPerDegree;
    const double y = static_cast<double>(sea.level) + height;
    GpCameraDesc camera{};
    camera.position[1] = static_cast<float>(y);
    camera.target[0] = static_cast<float>(std::cos(up) * std::sin(right));
    camera.target[1] = static_cast<float>(y + std::sin(up));
    camera.target[2] = static_cast<float>(-std::cos(up) * std::cos(right));
    camera.verticalFov =
        static_cast<float>(fovDeg.value_or(kStandardFovDeg) * kRadiansPerDegree);
    return camera;
}

void addSeaOptions(CLI::App& app, const std::vector<SeaWord>& words, GpOceanDesc& sea) {
    for (const SeaWord& word : words) {
        const std::string option = std::string("--") + word.name;
        addWord(app, option, word.type, word.help,
                [&word, &sea, option](const std::string& value) { word.set(sea, option, value); })
            ->group("Sea");
    }
}

void addSeaCameraOptions(CLI::App& app, SeaCamera& camera) {
    const std::string group = "Camera";
    addWord(app, "--camera-height", "M", "Metres above the water at rest, 0.1..100000 (default 3)",
            [&camera](const std::string& word) {
                camera.height = parseNumber("--camera-height", word, 0.1, 1e5);
            })->group(group);
    addWord(app, "--pitch", "DEG", "Where it looks, above the horizontal, -89..89 (default -6)",
            [&camera](const std::string& word) {
                camera.pitchDeg = parseNumber("--pitch", word, -89, 89);
            })->group(group);
    addWord(app, "--heading", "DEG", "Where it looks, from -Z towards +X (default 0)",
            [&camera](const std::string& word) {
                camera.headingDeg = parseNumber("--heading", word);
            })->group(group);
}

void addSeaLight(RenderSettings& settings) {
    constexpr SunSettings sunBeforeTheViewer{0, 20, 0};
    if (!settings.sun && settings.environmentPath.empty() && !settings.environmentColor) {
        settings.sun = sunBeforeTheViewer;
    }
}

}  // namespace gp::tool
