// Presets: materials by name, as TOML. A table for each:
//
//   [rusty_iron]
//   title = "Iron, rusting"                     # for people; also group, reference
//   model = "disney"                            # of the registry, or
//   preset = "iron"                             # another preset, above or built in, or
//   set = { roughness = 0.4, base_color = [0.5, 0.5, 0.5] }
//   layers = [{ preset = "iron" }, { preset = "rust", weight = 0.6, mask = "rust.png" }]
//
// Layers lie bottom first, all of one model; `channel` ("r", "g", "b", "a") chooses the mask's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/bsdf_registry.h"

namespace gp::io {

struct PresetLayer {
    BsdfSettings bsdf;
    float weight = 1;
    std::string maskPath;  // relative to the file's folder, already put behind it; empty: none
    uint32_t channel = 0;
};

struct Preset {
    std::string name, title, group, reference;
    std::vector<PresetLayer> layers;  // bottom first, at least one
};

// Ours, made from data/presets when the library is built.
const std::vector<Preset>& builtInPresets();
// Throws FileError with file, line and thing.
std::vector<Preset> readPresets(const std::string& path);
std::vector<Preset> parsePresets(std::string_view text, const std::string& path);

// The parameters of a preset whose layers have no mask, blended. Throws BsdfError.
BsdfSettings flattened(const Preset& preset);

}  // namespace gp::io
