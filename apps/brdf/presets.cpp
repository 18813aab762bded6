// glitterpath brdf presets: materials by name.
#include <fmt/format.h>

#include <memory>

#include "brdf/brdf.h"
#include "output.h"
#include "reflectance.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

struct PresetSettings {
    std::string path;
    bool json = false;
};

// "disney" or "disney, 3 layers"
std::string madeOf(const Json& preset) {
    const Json& layers = preset.at("layers");
    const auto model = layers.at(0).at("model").get<std::string>();
    return layers.size() == 1 ? model : fmt::format("{}, {} layers", model, layers.size());
}

std::string listText(const Json& presets) {
    std::string text, group;
    for (const Json& preset : presets) {
        const auto its = preset.at("group").get<std::string>();
        if (its != group || text.empty()) {
            text += fmt::format("{}{}\n", text.empty() ? "" : "\n",
                                its.empty() ? "(no group)" : its);
            group = its;
        }
        text += fmt::format("    {:20} {} [{}]\n", preset.at("name").get<std::string>(),
                            preset.at("title").get<std::string>(), madeOf(preset));
    }
    return text;
}

int runPresets(const PresetSettings& settings) {
    const Device device = newModelDevice();
    const Json presets = describePresets(device.get(), settings.path);
    if (settings.json) {
        writeJson("-", presets);
    } else {
        writeText("-", listText(presets));
    }
    return kExitSuccess;
}

}  // namespace

Command addBrdfPresets(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("presets", "List the materials that have names");
    const auto settings = std::make_shared<PresetSettings>();
    app->add_option("FILE", settings->path, "A TOML file of presets (default: ours)");
    app->add_flag("--json", settings->json, "As JSON, with all parameters");
    app->footer("A preset stands wherever a MODEL does; those of a file are FILE.toml#NAME.\n\n"
                "Examples:\n"
                "  glitterpath brdf presets\n"
                "  glitterpath brdf presets mine.toml --json\n"
                "  glitterpath render cup.glb -o cup.png --material handle=mine.toml#rust");
    return {app, [settings] { return runPresets(*settings); }};
}

}  // namespace gp::tool
