// The files of data/presets, which cmake/presets.cmake puts into the library.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gp::io {

struct PresetText {
    std::string name;
    std::string_view text;
};

std::span<const PresetText> presetTexts();

}  // namespace gp::io
