// glitterpath make-scene: the scenes that we make ourselves.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "commands.h"
#include "make_scene/make_scene.h"
#include "output.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using make_scene::MakeSceneOptions;
using make_scene::SceneInfo;
using make_scene::SceneParameter;

constexpr const char* kExamples =
    "Examples:\n"
    "  glitterpath make-scene --list\n"
    "  glitterpath make-scene still-life -o still-life.glb\n"
    "  glitterpath make-scene closed-sphere -o sphere.glb --set albedo=0.8 --set emission=0.2";

struct MakeSceneSettings {
    std::string name, outputPath;
    std::vector<std::string> parameterWords;
    bool list = false;
};

std::string listText() {
    std::string text;
    for (const SceneInfo& scene : make_scene::listScenes()) {
        text += fmt::format("{}\n    {}\n", scene.name, scene.description);
        if (!scene.renderOptions.empty()) {
            text += fmt::format("    render with: {}\n", scene.renderOptions);
        }
        for (const SceneParameter& p : scene.parameters) {
            text += fmt::format("    --set {}={}    {} ({}{}..{})\n", p.name, p.defaultValue,
                                p.description, p.integer ? "whole, " : "", p.minimum, p.maximum);
        }
    }
    return text;
}

SceneInfo findScene(const std::string& name) {
    std::vector<std::string> names;
    for (const SceneInfo& scene : make_scene::listScenes()) {
        if (scene.name == name) {
            return scene;
        }
        names.push_back(scene.name);
    }
    failChoice("make-scene", name, names);
}

void addParameter(const SceneInfo& scene, const std::string& word, MakeSceneOptions& options) {
    const auto [name, valueWord] = parseAssignment("--set", word);
    std::vector<std::string> names;
    for (const SceneParameter& p : scene.parameters) {
        if (p.name == name) {
            const double value =
                parseNumber("--set " + name, valueWord, p.minimum, p.maximum);
            if (p.integer && value != std::floor(value)) {
                throw UsageError(
                    fmt::format("--set {}: {} is not a whole number", name, valueWord));
            }
            options.parameters[name] = value;
            return;
        }
        names.push_back(p.name);
    }
    if (names.empty()) {
        throw UsageError(fmt::format("--set: scene '{}' has no parameters", scene.name));
    }
    failChoice("--set", name, names);
}

int runMakeScene(const MakeSceneSettings& settings) {
    if (settings.list) {
        writeText("-", listText());
        return kExitSuccess;
    }
    if (settings.name.empty()) {
        throw UsageError("make-scene: which scene? (--list shows them)");
    }
    const SceneInfo scene = findScene(settings.name);
    MakeSceneOptions options;
    options.name = settings.name;
    options.outputPath = settings.outputPath;
    for (const std::string& word : settings.parameterWords) {
        addParameter(scene, word, options);
    }
    if (settings.outputPath.empty()) {
        throw UsageError("make-scene: where to? (-o FILE.glb)");
    }
    if (!settings.outputPath.ends_with(".glb")) {
        throw UsageError(fmt::format("--output: '{}' does not end in .glb", settings.outputPath));
    }
    checkWritable(settings.outputPath);
    make_scene::makeScene(options);
    return kExitSuccess;
}

}  // namespace

Command addMakeSceneCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("make-scene", "Write one of our own scenes as binary glTF");
    const auto settings = std::make_shared<MakeSceneSettings>();
    app->add_option("NAME", settings->name, "Which scene; --list shows them");
    addWord(*app, "-o,--output", "FILE.glb", "The file to write",
            [settings](const std::string& word) { settings->outputPath = word; });
    app->add_option("--set", settings->parameterWords,
                    "Set a parameter of the scene; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app->add_flag("--list", settings->list, "List the scenes and their parameters");
    app->footer(kExamples);
    return {app, [settings] { return runMakeScene(*settings); }};
}

}  // namespace gp::tool
