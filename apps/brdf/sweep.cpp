// glitterpath brdf sweep: a row of spheres for each parameter, from one end of its range to the
// other, as in figure 16 of [Burley 2012].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "brdf/brdf.h"
#include "brdf/spheres.h"
#include "gnuplot.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotes =
    "A number goes from --from to --to, which are the ends of its range; a range up to 1000 and\n"
    "more in steps of a factor, from 1 where it begins below. Of choices and switches every value\n"
    "is shown. All other parameters stay as MODEL and --set say.\n\n"
    "Examples:\n"
    "  glitterpath brdf sweep disney --param roughness --steps 6 -o roughness.png\n"
    "  glitterpath brdf sweep disney --param metallic specular roughness anisotropic sheen \\\n"
    "      clearcoat --steps 11 --size 96 -o figure16.png\n"
    "  glitterpath brdf sweep phong --param exponent --from 1 --to 1000 --steps 5 -o phong.png";

struct Settings {
    ModelOptions models;
    SphereSettings spheres;
    std::vector<std::string> parameters;
    std::optional<double> from, to;
    std::size_t steps = 6;
    std::string outputPath;
};

struct Row {
    std::string parameter;
    std::vector<std::string> values;
};

Json parameterOf(GpDevice device, const Model& model, const std::string& name) {
    for (const Json& known : describeModels(device)) {
        if (known.at("name") != model.description.at("model")) {
            continue;
        }
        for (const Json& parameter : known.at("parameters")) {
            if (parameter.at("name") == name) {
                return parameter;
            }
        }
    }
    // The library's own words, with the nearest name.
    try {
        variantOf(device, model, {{name, "0"}});
    } catch (const RunError& error) {
        throw UsageError(error.what());
    }
    throw UsageError(fmt::format("--param: {} has no range to sweep", name));
}

std::vector<std::string> numbers(const Settings& settings, const Json& parameter) {
    const auto name = parameter.at("name").get<std::string>();
    const double low = parameter.at("minimum").get<double>();
    const double high = parameter.at("maximum").get<double>();
    const bool byFactors = !settings.from && !settings.to && high >= 1000;
    const double from = settings.from.value_or(byFactors ? std::max(low, 1.0) : low);
    const double to = settings.to.value_or(high);
    if (!parameter.at("mayExceed").get<bool>() &&
        (std::min(from, to) < low || std::max(from, to) > high)) {
        throw UsageError(fmt::format("--from, --to: {} goes from {:g} to {:g}", name, low, high));
    }
    std::vector<std::string> values;
    for (std::size_t i = 0; i < settings.steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(settings.steps - 1);
        const double value = byFactors ? from * std::pow(to / from, t) : from + (to - from) * t;
        values.push_back(fmt::format("{:.4g}", value));
    }
    return values;
}

Row rowOf(GpDevice device, const Settings& settings, const Model& model, const std::string& name) {
    const Json parameter = parameterOf(device, model, name);
    const auto type = parameter.at("type").get<std::string>();
    Row row;
    row.parameter = name;
    if (type == "color") {
        throw UsageError(fmt::format("--param: {} is a colour, which has no order", name));
    }
    if (type != "number" && (settings.from || settings.to)) {
        throw UsageError(fmt::format("--from, --to: {} is no number", name));
    }
    if (type == "choice") {
        row.values = parameter.at("choices").get<std::vector<std::string>>();
    } else if (type == "boolean") {
        row.values = {"false", "true"};
    } else {
        row.values = numbers(settings, parameter);
    }
    return row;
}

// Rows of different lengths end in gaps.
PictureGrid sheetOf(const std::string& title, const std::vector<Row>& rows,
                    const std::vector<GridPicture>& pictures) {
    PictureGrid sheet;
    sheet.title = title;
    for (const Row& row : rows) {
        sheet.columns = std::max(sheet.columns, static_cast<unsigned>(row.values.size()));
        sheet.rowTitles.push_back(row.parameter);
    }
    auto next = pictures.begin();
    for (const Row& row : rows) {
        for (unsigned i = 0; i < sheet.columns; ++i) {
            sheet.pictures.emplace_back();
            if (i < row.values.size()) {
                sheet.pictures.back() = *next++;
                sheet.pictures.back().title = row.values[i];
            }
        }
    }
    return sheet;
}

int runSweep(const Settings& settings) {
    checkDrawable(settings.outputPath);
    const Device owner = newSphereDevice();
    GpDevice device = owner.get();
    const Model model = newModel(device, settings.models);
    std::vector<Row> rows;
    std::vector<Bsdf> variants;
    std::vector<GpBsdf> handles;
    for (const std::string& name : settings.parameters) {
        rows.push_back(rowOf(device, settings, model, name));
        for (const std::string& value : rows.back().values) {
            variants.push_back(variantOf(device, model, {{name, value}}));
            handles.push_back(variants.back().get());
        }
    }
    const std::vector<SpherePicture> spheres = renderSpheres(device, handles, settings.spheres);
    if (spheres.empty()) {
        fmt::print(stderr, "glitterpath: interrupted: nothing saved\n");
        return kExitInterrupted;
    }
    std::string title = model.label;
    for (const std::string& assignment : settings.models.assignments) {
        title += ", " + assignment;
    }
    drawPictureGrid(sheetOf(title, rows, displayed(spheres, settings.spheres)),
                    settings.outputPath);
    return kExitSuccess;
}

}  // namespace

Command addBrdfSweep(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("sweep", "Draw a row of spheres for each parameter");
    const auto settings = std::make_shared<Settings>();
    Settings& s = *settings;
    addModelOptions(*app, s.models);
    app->add_option("--param", s.parameters, "What changes; a row for each")
        ->type_name("NAME...")
        ->required()
        ->expected(1, -1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    addWord(*app, "--from", "VALUE", "Where to begin",
            [&s](const std::string& word) { s.from = parseNumber("--from", word); });
    addWord(*app, "--to", "VALUE", "Where to end",
            [&s](const std::string& word) { s.to = parseNumber("--to", word); });
    addWord(*app, "--steps", "N", "Spheres of a row; 6", [&s](const std::string& word) {
        s.steps = parseInteger("--steps", word, 2, 64);
    });
    addSphereOptions(*app, s.spheres);
    addWord(*app, "-o,--output", "FILE", "The picture, .png or .svg",
            [&s](const std::string& word) { s.outputPath = word; })
        ->required();
    app->footer(fmt::format("{}\n\n{}\n\n{}", kModelSyntax, kSphereNotes, kNotes));
    return {app, [settings] { return runSweep(*settings); }};
}

}  // namespace gp::tool
