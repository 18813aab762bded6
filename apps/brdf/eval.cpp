// glitterpath brdf eval: the values of a model for two directions, or of a whole table.
#include <fmt/format.h>

#include <memory>

#include "brdf/brdf.h"
#include "brdf/table.h"
#include "output.h"
#include "parse.h"
#include "reflectance.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotes =
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

struct EvalSettings {
    std::string model, outputPath = "-", csvPath, wi, wo;
    std::vector<std::string> parameterWords;
    GpBsdfDialect dialect = GP_DIALECT_OWN;
    bool json = false;
};

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

}  // namespace

Command addBrdfEval(CLI::App& brdf) {
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
    app->footer(kNotes);
    return {app, [settings] { return runEval(*settings); }};
}

}  // namespace gp::tool
