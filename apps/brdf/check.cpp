// glitterpath brdf check: reciprocity, energy and sampling of a model as numbers, with verdicts.
#include <fmt/format.h>

#include <memory>

#include "brdf/brdf.h"
#include "brdf/checks.h"
#include "output.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotes =
    "reciprocity         light and viewer exchanged, 20,000 pairs; of refractions the squared index\n"
    "positivity          no value below 0, none that is not finite\n"
    "albedo              the largest share of light that leaves again, over angles\n"
    "white furnace       the same with the reflectance set to white; below 1 light gets lost\n"
    "weak white furnace  microfacet with Smith's masking: do the visible facets cover the surface?\n"
    "sampling            chi-square test of samples against their density, over views\n\n"
    "A model is held to what it claims in `glitterpath brdf list`: what it does not claim cannot\n"
    "fail. Exit code 1 where something failed, 0 otherwise.\n\n"
    "Examples:\n"
    "  glitterpath brdf check ward:alpha_x=0.3,alpha_y=0.1\n"
    "  glitterpath brdf check microfacet --set distribution=beckmann masking=v_cavity --json";

struct CheckSettings {
    ModelOptions models;
    std::string outputPath = "-";
    std::size_t samples = 300'000;
    bool json = false;
};

Claims claimsOf(GpDevice device, const Model& model) {
    for (const Json& known : describeModels(device)) {
        if (known.at("name") == model.description.at("model")) {
            return {known.at("reciprocal").get<bool>(), known.at("conserving").get<bool>()};
        }
    }
    return {};
}

const char* wordOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::ok: return "ok";
    case Verdict::failed: return "failed";
    case Verdict::notClaimed: return "not claimed";
    case Verdict::notApplicable: break;
    }
    return "not applicable";
}

std::string textOf(const Model& model, const std::vector<Check>& checks) {
    std::string text = model.label + "\n";
    for (const Check& check : checks) {
        text += fmt::format("  {:19} {:15} {}\n", check.name, wordOf(check.verdict), check.text);
    }
    return text;
}

Json jsonOf(const Model& model, const std::vector<Check>& checks, bool passed) {
    Json json = model.description;
    json["passed"] = passed;
    for (const Check& check : checks) {
        Json entry = {{"name", check.name}, {"verdict", wordOf(check.verdict)}};
        entry.update(check.json);
        json["checks"].push_back(entry);
    }
    return json;
}

int runCheck(const CheckSettings& settings) {
    checkWritable(settings.outputPath);
    const Device owner = newModelDevice();
    GpDevice device = owner.get();
    const Model model = newModel(device, settings.models);
    const Claims claims = claimsOf(device, model);
    const std::vector<Check> checks = {checkReciprocity(device, model, claims),
                                       checkPositivity(device, model),
                                       checkAlbedo(device, model, claims),
                                       checkWhiteFurnace(device, model, claims),
                                       checkWeakWhiteFurnace(device, model),
                                       checkSampling(device, model, settings.samples)};
    bool passed = true;
    for (const Check& check : checks) {
        passed = passed && check.verdict != Verdict::failed;
    }
    if (settings.json) {
        writeJson(settings.outputPath, jsonOf(model, checks, passed));
    } else {
        writeText(settings.outputPath, textOf(model, checks));
    }
    return passed ? kExitSuccess : kExitFailure;
}

}  // namespace

Command addBrdfCheck(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("check", "Check reciprocity, energy and sampling");
    const auto settings = std::make_shared<CheckSettings>();
    CheckSettings& s = *settings;
    addModelOptions(*app, s.models);
    addWord(*app, "-o,--output", "FILE", "Where to write; - is stdout, the default",
            [&s](const std::string& word) { s.outputPath = word; });
    addWord(*app, "--samples", "N", "Of each chi-square test; 300000", [&s](const std::string& w) {
        s.samples = parseInteger("--samples", w, 10'000, 1u << 26);
    });
    app->add_flag("--json", s.json, "As JSON");
    app->footer(std::string(kModelSyntax) + "\n\n" + kNotes);
    return {app, [settings] { return runCheck(*settings); }};
}

}  // namespace gp::tool
