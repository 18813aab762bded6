// glitterpath brdf plot: curves and lobes of models in one picture.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <set>

#include "brdf/brdf.h"
#include "brdf/plot_script.h"
#include "output.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kNotes =
    "Kinds, and the angles (degrees) that each takes; f is without the cosine unless --times-cos:\n"
    "  polar, theta-v  f over the view's angle in the plane --phi-v, for lights at --theta-i and\n"
    "                  --phi-i (opposite to --phi-v, so that +theta-i is the mirror's direction)\n"
    "  theta-h         f over the half vector's angle, for --theta-d and --phi-d, --phi-h\n"
    "  theta-d         f over the difference angle, for --theta-h and --phi-d, --phi-h\n"
    "  albedo          share of the light from theta_o and --phi-v that leaves again, by --samples\n"
    "                  samples; the legend has the average albedo, the table the errors\n"
    "  3d              f as the radius of a surface over all views, for --theta-i and --phi-i\n"
    "Gaps are directions below the horizon. --log: a logarithmic axis; in polar and 3d the radius\n"
    "is log10(1 + f).\n\n"
    "Examples:\n"
    "  glitterpath brdf plot ward lambert --kind polar --theta-i 30 60 -o ward.png\n"
    "  glitterpath brdf plot disney:roughness=0.2 disney:roughness=0.6 --kind theta-h --log \\\n"
    "      -o disney.svg --csv disney.csv\n"
    "  glitterpath brdf plot microfacet:alpha_x=0.5,alpha_y=0.1 --kind 3d -o lobe.png\n"
    "  glitterpath brdf plot microfacet kulla_conty --kind albedo --set alpha=0.8 alpha_x=0.8 \\\n"
    "      alpha_y=0.8 -o albedo.png";

struct PlotSettings {
    ModelOptions models;
    CurveSettings curves;
    PlotLook look;
    std::string outputPath, csvPath;
    std::set<std::string> given;  // those that not every kind has a use for
};

PlotKind parseKind(const std::string& word) {
    constexpr std::pair<const char*, PlotKind> choices[] = {
        {"polar", PlotKind::polar},    {"theta-v", PlotKind::thetaV}, {"theta-h", PlotKind::thetaH},
        {"theta-d", PlotKind::thetaD}, {"albedo", PlotKind::albedo},  {"3d", PlotKind::lobe}};
    return parseChoice("--kind", word, choices);
}

Channel parseChannel(const std::string& word) {
    constexpr std::pair<const char*, Channel> choices[] = {{"r", Channel::red},
                                                           {"g", Channel::green},
                                                           {"b", Channel::blue},
                                                           {"luminance", Channel::luminance},
                                                           {"rgb", Channel::rgb}};
    return parseChoice("--channel", word, choices);
}

void refuseUnused(const PlotSettings& settings) {
    static const std::map<PlotKind, std::set<std::string>> used = {
        {PlotKind::polar, {"--theta-i", "--phi-i", "--phi-v", "--times-cos"}},
        {PlotKind::thetaV, {"--theta-i", "--phi-i", "--phi-v", "--times-cos"}},
        {PlotKind::thetaH, {"--theta-d", "--phi-d", "--phi-h", "--times-cos"}},
        {PlotKind::thetaD, {"--theta-h", "--phi-d", "--phi-h", "--times-cos"}},
        {PlotKind::albedo, {"--phi-v", "--samples"}},
        {PlotKind::lobe, {"--theta-i", "--phi-i", "--times-cos"}}};
    for (const std::string& option : settings.given) {
        if (!used.at(settings.curves.kind).contains(option)) {
            throw UsageError(fmt::format("{} means nothing for this --kind (see --help)", option));
        }
    }
}

int runPlot(const PlotSettings& settings) {
    refuseUnused(settings);
    const bool lobes = settings.curves.kind == PlotKind::lobe;
    if (lobes && settings.look.channel == Channel::rgb) {
        throw UsageError("--channel: a lobe is drawn from one channel, not rgb");
    }
    checkDrawable(settings.outputPath);
    if (!settings.csvPath.empty()) {
        checkWritable(settings.csvPath);
    }
    const Device device = newModelDevice();
    const std::vector<Model> models = newModels(device.get(), settings.models);
    std::string csv;
    if (lobes) {
        const std::vector<Lobe> list = computeLobes(device.get(), models, settings.curves);
        drawWithGnuplot(lobesJob(list, settings.curves, settings.look), settings.outputPath);
        csv = lobesCsv(list, settings.curves);
    } else {
        const std::vector<Curve> list = computeCurves(device.get(), models, settings.curves);
        drawWithGnuplot(curvesJob(list, settings.curves, settings.look), settings.outputPath);
        csv = curvesCsv(list, models, settings.curves);
    }
    if (!settings.csvPath.empty()) {
        writeText(settings.csvPath, csv);
    }
    return kExitSuccess;
}

// One or more angles.
void addAngles(CLI::App& app, PlotSettings& settings, const std::string& name,
               std::vector<double>& target, double low, double high, const char* help) {
    app.add_option_function<std::vector<std::string>>(
           name,
           [&settings, &target, name, low, high](const std::vector<std::string>& words) {
               target.clear();
               for (const std::string& word : words) {
                   target.push_back(parseNumber(name, word, low, high));
               }
               settings.given.insert(name);
           },
           help)
        ->type_name("DEG...")
        ->expected(1, -1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addAzimuth(CLI::App& app, PlotSettings& settings, const std::string& name,
                std::function<void(double)> accept, const char* help) {
    addWord(app, name, "DEG", help, [&settings, name, accept](const std::string& word) {
        accept(parseNumber(name, word, -360, 360));
        settings.given.insert(name);
    });
}

void addAngleOptions(CLI::App& app, PlotSettings& s) {
    CurveSettings& c = s.curves;
    addAngles(app, s, "--theta-i", c.thetaI, 0, 90, "Angles of the light from the normal; 45");
    addAngles(app, s, "--theta-h", c.thetaH, 0, 90, "Half angles; 0");
    addAngles(app, s, "--theta-d", c.thetaD, 0, 90, "Difference angles; 0");
    addAzimuth(app, s, "--phi-i", [&c](double v) { c.phiI = v; },
               "Azimuth of the light from the tangent; opposite to --phi-v");
    addAzimuth(app, s, "--phi-v", [&c](double v) { c.phiV = v; }, "Azimuth of the view; 0");
    addAzimuth(app, s, "--phi-h", [&c](double v) { c.phiH = v; }, "Azimuth of the half vector; 0");
    addAzimuth(app, s, "--phi-d", [&c](double v) { c.phiD = v; }, "Azimuth of the difference; 90");
}

}  // namespace

Command addBrdfPlot(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("plot", "Draw curves and lobes of models");
    const auto settings = std::make_shared<PlotSettings>();
    PlotSettings& s = *settings;
    addModelOptions(*app, s.models);
    addWord(*app, "--kind", "NAME", "polar, theta-v, theta-h, theta-d, albedo or 3d",
            [&s](const std::string& word) { s.curves.kind = parseKind(word); })
        ->required();
    addWord(*app, "-o,--output", "FILE", "The picture, .png or .svg",
            [&s](const std::string& word) { s.outputPath = word; })
        ->required();
    addWord(*app, "--csv", "FILE", "The numbers as a table; - is stdout",
            [&s](const std::string& word) { s.csvPath = word; });
    addAngleOptions(*app, s);
    addWord(*app, "--channel", "NAME", "r, g, b, luminance (the default) or rgb: all three",
            [&s](const std::string& word) { s.look.channel = parseChannel(word); });
    app->add_flag("--log", s.look.logarithmic, "Logarithmic");
    app->add_flag_function(
        "--times-cos",
        [&s](std::int64_t) {
            s.curves.timesCosine = true;
            s.given.insert("--times-cos");
        },
        "f times the light's cosine");
    addWord(*app, "--samples", "N", "For each albedo; 16384", [&s](const std::string& word) {
        s.curves.samples = parseInteger("--samples", word, 256, 1u << 22);
        s.given.insert("--samples");
    });
    addWord(*app, "--size", "WxH", "Of the picture; 900x600", [&s](const std::string& word) {
        const Size size = parseSize("--size", word);
        s.look.width = size.width;
        s.look.height = size.height;
    });
    app->footer(std::string(kModelSyntax) + "\n\n" + kNotes);
    return {app, [settings] { return runPlot(*settings); }};
}

}  // namespace gp::tool
