// glitterpath brdf eval: the values of a model for two directions, or of a whole table.
#include <fmt/format.h>

#include <memory>

#include "brdf/brdf.h"
#include "brdf/models.h"
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
    ModelOptions models;
    std::string outputPath = "-", csvPath, wi, wo;
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

std::string valueLines(const GpBsdfValue& value) {
    return fmt::format("f {} {} {}\npdf {}\n", value.f[0], value.f[1], value.f[2], value.pdf);
}

int runEval(const EvalSettings& settings) {
    const bool table = !settings.csvPath.empty();
    if (table && (!settings.models.words.empty() || !settings.models.assignments.empty() ||
                  !settings.wi.empty() || !settings.wo.empty() || settings.json)) {
        throw UsageError("--csv brings models, parameters and directions: it takes only --dialect "
                         "and --output");
    }
    if (table) {
        evaluateTable({settings.csvPath, settings.outputPath, settings.models.dialect});
        return kExitSuccess;
    }
    if (!settings.models.words.empty() && (settings.wi.empty() || settings.wo.empty())) {
        throw UsageError(fmt::format("brdf eval: {} is missing",
                                     settings.wi.empty() ? "--wi" : "--wo"));
    }
    checkWritable(settings.outputPath);
    const Device device = newModelDevice();
    const Model model = newModel(device.get(), settings.models);
    const Direction wi = directionOf("--wi", settings.wi), wo = directionOf("--wo", settings.wo);
    const GpBsdfValue value = evaluate(device.get(), model.bsdf, wi, wo);
    Json json = model.description;
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
    addModelOptions(*app, settings->models);
    addWord(*app, "--wi", "X,Y,Z", "The direction to the light", into(settings->wi));
    addWord(*app, "--wo", "X,Y,Z", "The direction to the viewer", into(settings->wo));
    addWord(*app, "--csv", "FILE", "Evaluate every row of a table", into(settings->csvPath));
    addWord(*app, "-o,--output", "FILE", "Where to write; - is stdout, the default",
            into(settings->outputPath));
    addWord(*app, "--dialect", "NAME",
            "Whose names of models and parameters: own, wdas (Disney's BRDF Explorer) or bbm",
            [settings](const std::string& word) { settings->models.dialect = parseDialect(word); });
    app->add_flag("--json", settings->json, "Values, parameters and notices as JSON");
    app->footer(std::string(kModelSyntax) + "\n\n" + kNotes);
    return {app, [settings] { return runEval(*settings); }};
}

}  // namespace gp::tool
