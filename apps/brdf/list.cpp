// glitterpath brdf list: which models there are, and what can be set on them.
#include <fmt/format.h>

#include <memory>

#include "brdf/brdf.h"
#include "output.h"
#include "reflectance.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

struct ListSettings {
    bool json = false;
};

std::string valueText(const Json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_array()) {
        std::string text;
        for (const Json& part : value) {
            text += (text.empty() ? "" : ",") + valueText(part);
        }
        return text;
    }
    // The library's numbers are floats; JSON's double would show digits that they do not have.
    return value.is_number() ? fmt::format("{}", value.get<float>()) : value.dump();
}

std::string rangeText(const Json& p) {
    if (p.contains("choices")) {
        std::string text;
        for (const Json& choice : p["choices"]) {
            text += (text.empty() ? "" : "|") + choice.get<std::string>();
        }
        return text;
    }
    if (!p.contains("minimum")) {
        return "true or false";
    }
    return fmt::format("{:g}..{:g}{}{}", p["minimum"].get<float>(), p["maximum"].get<float>(),
                       p.contains("unit") ? " " + p["unit"].get<std::string>() : "",
                       p["mayExceed"].get<bool>() ? ", or beyond" : "");
}

std::string flagsText(const Json& model) {
    std::string text;
    for (const char* flag : {"reciprocal", "conserving", "transmissive"}) {
        if (model.at(flag).get<bool>()) {
            text += fmt::format(", {}", flag);
        }
    }
    return text;
}

std::string listText(const Json& models) {
    std::string text;
    for (const Json& model : models) {
        text += fmt::format("{}\n    {} [{}{}]\n", model.at("name").get<std::string>(),
                            model.at("text").get<std::string>(),
                            model.at("reference").get<std::string>(), flagsText(model));
        for (const Json& p : model.at("parameters")) {
            text += fmt::format("    --set {}={}    {} ({})\n", p.at("name").get<std::string>(),
                                valueText(p.at("default")), p.at("text").get<std::string>(),
                                rangeText(p));
        }
    }
    return text;
}

int runList(const ListSettings& settings) {
    const Device device = newModelDevice();
    const Json models = describeModels(device.get());
    if (settings.json) {
        writeJson("-", models);
    } else {
        writeText("-", listText(models));
    }
    return kExitSuccess;
}

}  // namespace

Command addBrdfList(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("list", "List models, parameters, ranges and defaults");
    const auto settings = std::make_shared<ListSettings>();
    app->add_flag("--json", settings->json, "As JSON");
    app->footer("Examples:\n  glitterpath brdf list --json > models.json");
    return {app, [settings] { return runList(*settings); }};
}

}  // namespace gp::tool
