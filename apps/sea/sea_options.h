// Options that every command with a sea has.
#pragma once

#include <optional>

#include "render_settings.h"
#include "sea/sea_words.h"

namespace gp::tool {

// A camera over the sea, at x = z = 0.
struct SeaCamera {
    double height = 3;       // metres above the water at rest
    double pitchDeg = -6;    // above the horizontal
    double headingDeg = 0;   // from -Z towards +X

    GpCameraDesc over(const GpOceanDesc& sea, std::optional<double> fovDeg) const;
};

// The words as --NAME, in the group "Sea". The sea must outlive the parsing, here and below.
void addSeaOptions(CLI::App& app, const std::vector<SeaWord>& words, GpOceanDesc& sea);
// --camera-height, --pitch, --heading.
void addSeaCameraOptions(CLI::App& app, SeaCamera& camera);
inline constexpr const char* kSeaCameraOptions[] = {"--camera-height", "--pitch", "--heading"};

// The light of a sea alone, where none was asked for: a sun before the viewer.
void addSeaLight(RenderSettings& settings);

}  // namespace gp::tool
