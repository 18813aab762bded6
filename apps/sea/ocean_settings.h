// What `glitterpath ocean` was asked for.
#pragma once

#include <string>

#include "animate/animate_settings.h"
#include "sea/sea_options.h"

namespace gp::tool {

struct OceanSettings {
    // The picture, its light, quality and files; frames > 0: a moving picture.
    AnimateSettings picture;
    bool modeGiven = false;

    GpOceanDesc sea{};
    double timeSeconds = 0;
    std::string mapFolder;             // --maps; empty: none

    SeaCamera camera;

    bool moves() const { return picture.frames > 0; }
};

// All options of `ocean`. The settings must outlive the parsing.
void addOceanOptions(CLI::App& app, OceanSettings& settings);

// What no single option can know by itself; throws UsageError. The options of real time point into
// the settings then.
void checkOceanSettings(const CLI::App& app, OceanSettings& settings);

}  // namespace gp::tool
