// Any text must give presets that can be flattened and looked at, or a FileError.
#include <cstdint>
#include <cstdlib>

#include "io/file_error.h"
#include "io/presets.h"
#include "scene/bsdf_evaluate.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    int looks = 8;  // some models take milliseconds to prepare
    try {
        for (const gp::io::Preset& preset : gp::io::parsePresets(text, "fuzz.toml")) {
            if (preset.layers.empty()) std::abort();
            for (const gp::io::PresetLayer& layer : preset.layers)
                if (looks-- > 0) gp::evaluateBsdf(layer.bsdf, {0.6f, 0, 0.8f}, {0, 0, 1});
        }
    } catch (const gp::io::FileError&) {
    }
    return 0;
}
