// glitterpath brdf: the reflectance models, one by one.
#include <fmt/format.h>

#include <memory>

#include "brdf_table.h"
#include "commands.h"
#include "output.h"
#include "parse.h"
#include "reflectance.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExamples =
    "Examples:\n"
    "  glitterpath brdf list\n"
    "  glitterpath brdf eval ward --set alpha_x=0.3 alpha_y=0.1 --wi 0.5,0,1 --wo -0.5,0,1\n"
    "  glitterpath brdf eval --csv directions.csv -o values.csv\n\n"
    "`glitterpath brdf list --help` and `glitterpath brdf eval --help` tell the rest.";

constexpr const char* kEvalNotes =
    "Prints f (1/sr, without the cosine) for red, green and blue, and the density (1/sr) with\n"
    "which wi is sampled for this wo. Directions leave the surface and may have any length but 0;\n"
    "the normal is +Z, the tangent +X.\n\n"
    "--csv: a table with the columns model, params (a JSON object), lx, ly, lz (to the light) and\n"
    "vx, vy, vz (to the viewer) is written out again with r, g, b and pdf added.\n\n"
    "Examples:\n"
    "  glitterpath brdf eval lambert --wi 0,0,1 --wo 1,0,1\n"
    "  glitterpath brdf eval oren_nayar --set sigma=0.7 form=qualitative \\\n"
    "      --wi 0.5,0.2,1 --wo -1,0,0.3 --json\n"
    "  glitterpath brdf eval --csv golden_brdf.csv --dialect wdas -o values.csv";

struct ListSettings {
    bool json = false;
};

struct EvalSettings {
    std::string model, outputPath = "-", csvPath, wi, wo;
    std::vector<std::string> parameterWords;
    GpBsdfDialect dialect = GP_DIALECT_OWN;
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

Direction directionOf(const char* option, const std::string& word) {
    const std::array<float, 3> triple = parseTriple(option, word);
    const Direction d = {triple[0], triple[1], triple[2]};
    if (d == Direction{}) {
        throw UsageError(fmt::format("{}: 0,0,0 is no direction", option));
    }
    return d;
}

Bsdf bsdfOf(GpDevice device, const EvalSettings& settings) {
    ParameterWords words;
    for (const std::string& word : settings.parameterWords) {
        words.push_back(parseAssignment("--set", word));
    }
    try {
        return newBsdf(device, settings.model, settings.dialect, words);
    } catch (const RunError& error) {
        throw UsageError(error.what());  // what it names stands on the command line
    }
}

void printNotices(const Json& description) {
    for (const Json& notice : description.at("notices")) {
        fmt::print(stderr, "glitterpath: note: {}\n", notice.get<std::string>());
    }
}

std::string valueLines(const GpBsdfValue& value) {
    return fmt::format("f {} {} {}\npdf {}\n", value.f[0], value.f[1], value.f[2], value.pdf);
}

int runEval(const EvalSettings& settings) {
    const bool table = !settings.csvPath.empty();
    if (table && (!settings.model.empty() || !settings.parameterWords.empty() ||
                  !settings.wi.empty() || !settings.wo.empty() || settings.json)) {
        throw UsageError("--csv brings models, parameters and directions: it takes only --dialect "
                         "and --output");
    }
    if (table) {
        evaluateTable({settings.csvPath, settings.outputPath, settings.dialect});
        return kExitSuccess;
    }
    if (settings.model.empty()) {
        throw UsageError("brdf eval: which MODEL? (`glitterpath brdf list` shows them)");
    }
    if (settings.wi.empty() || settings.wo.empty()) {
        throw UsageError(fmt::format("brdf eval: {} is missing",
                                     settings.wi.empty() ? "--wi" : "--wo"));
    }
    const Direction wi = directionOf("--wi", settings.wi), wo = directionOf("--wo", settings.wo);
    checkWritable(settings.outputPath);
    const Device device = newModelDevice();
    const Bsdf bsdf = bsdfOf(device.get(), settings);
    const GpBsdfValue value = evaluate(device.get(), bsdf, wi, wo);
    Json json = describeBsdf(device.get(), bsdf);
    printNotices(json);
    if (!settings.json) {
        writeText(settings.outputPath, valueLines(value));
        return kExitSuccess;
    }
    json["wi"] = wi;
    json["wo"] = wo;
    json["f"] = {value.f[0], value.f[1], value.f[2]};
    json["pdf"] = value.pdf;
    writeJson(settings.outputPath, json);
    return kExitSuccess;
}

Command addList(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("list", "List models, parameters, ranges and defaults");
    const auto settings = std::make_shared<ListSettings>();
    app->add_flag("--json", settings->json, "As JSON");
    app->footer("Examples:\n  glitterpath brdf list --json > models.json");
    return {app, [settings] { return runList(*settings); }};
}

Command addEval(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("eval", "Evaluate a model, or a table of models");
    const auto settings = std::make_shared<EvalSettings>();
    const auto into = [](std::string& target) {
        return [&target](const std::string& word) { target = word; };
    };
    app->add_option("MODEL", settings->model, "A model's name; `glitterpath brdf list` shows them");
    app->add_option("--set", settings->parameterWords, "Set parameters; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1, -1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    addWord(*app, "--wi", "X,Y,Z", "The direction to the light", into(settings->wi));
    addWord(*app, "--wo", "X,Y,Z", "The direction to the viewer", into(settings->wo));
    addWord(*app, "--csv", "FILE", "Evaluate every row of a table", into(settings->csvPath));
    addWord(*app, "-o,--output", "FILE", "Where to write; - is stdout, the default",
            into(settings->outputPath));
    addWord(*app, "--dialect", "NAME",
            "Whose names of models and parameters: own, wdas (Disney's BRDF Explorer) or bbm",
            [settings](const std::string& word) { settings->dialect = parseDialect(word); });
    app->add_flag("--json", settings->json, "Values, parameters and notices as JSON");
    app->footer(kEvalNotes);
    return {app, [settings] { return runEval(*settings); }};
}

}  // namespace

Command addBrdfCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("brdf", "Look at reflectance models: list, eval");
    app->footer(kExamples);
    const std::vector<Command> commands = {addList(*app), addEval(*app)};
    return {app, [commands] {
                for (const Command& command : commands) {
                    if (command.app->parsed()) {
                        return command.run();
                    }
                }
                throw UsageError("brdf: a subcommand is missing: list or eval");
            }};
}

}  // namespace gp::tool
