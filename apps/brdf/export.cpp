// glitterpath brdf export: a model as a measured material, in MERL's format.
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "brdf/brdf.h"
#include "brdf/merl_table.h"
#include "brdf/models.h"
#include "output.h"
#include "progress_bar.h"
#include "reflectance.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kNotes =
    "Writes f at the centres of the 90 x 90 x 180 cells of a MERL file (35 MB); where light or\n"
    "viewer would be below the horizon the file has -1, as the measured ones. The format knows\n"
    "only what is isotropic and reciprocal: an anisotropic model is averaged over the azimuths,\n"
    "one that is not reciprocal over both ways, and a note says so.\n\n"
    "Examples:\n"
    "  glitterpath brdf export disney --set metallic=1 roughness=0.3 -o metal.binary\n"
    "  glitterpath brdf eval metal.binary --wi 0.5,0,1 --wo -0.5,0,1";

struct ExportSettings {
    ModelOptions models;
    std::string outputPath;
};

// A line that people at a terminal see when they have waited for a second.
class Percentage {
public:
    ~Percentage() {
        if (m_drawn) {
            fmt::print(stderr, "\r\x1b[K");
        }
    }
    void show(double part) {
        const auto now = Clock::now();
        if (!stderrIsTerminal() || now < m_next) {
            return;
        }
        m_next = now + std::chrono::milliseconds(200);
        m_drawn = true;
        fmt::print(stderr, "\rtabulating {:3.0f} %", 100 * part);
    }

private:
    Clock::time_point m_next = Clock::now() + std::chrono::seconds(1);
    bool m_drawn = false;
};

void note(const std::string& text) { fmt::print(stderr, "glitterpath: note: {}\n", text); }

void printNotes(const Model& model, const MerlTable& table) {
    const auto name = model.description.at("model").get<std::string>();
    if (model.transmissive) {
        note(fmt::format("{}: only what is reflected is kept", name));
    }
    if (table.isAnisotropic()) {
        note(fmt::format("{} is anisotropic: a cell is the mean of {} azimuths", name,
                         MerlTable::azimuths));
    }
    if (!table.isReciprocal()) {
        note(fmt::format("{} is not reciprocal: a cell is the mean of both ways", name));
    }
}

int runExport(const ExportSettings& settings) {
    if (!settings.outputPath.ends_with(".binary")) {
        throw UsageError(fmt::format("-o: '{}' does not end with .binary, by which a MERL file is "
                                     "known", settings.outputPath));
    }
    checkWritable(settings.outputPath);
    const Device device = newModelDevice();
    const Model model = newModel(device.get(), settings.models);
    const MerlTable table(device.get(), model.bsdf);
    printNotes(model, table);
    Percentage percentage;
    writeText(settings.outputPath, table.file([&](double part) { percentage.show(part); }));
    return kExitSuccess;
}

}  // namespace

Command addBrdfExport(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("export", "Write a model as a measured MERL file");
    const auto settings = std::make_shared<ExportSettings>();
    addModelOptions(*app, settings->models);
    addWord(*app, "-o,--output", "FILE.binary", "Where to write",
            [settings](const std::string& word) { settings->outputPath = word; })->required();
    addWord(*app, "--dialect", "NAME",
            "Whose names of models and parameters: own, wdas (Disney's BRDF Explorer) or bbm",
            [settings](const std::string& word) { settings->models.dialect = parseDialect(word); });
    app->footer(std::string(kModelSyntax) + "\n\n" + kNotes);
    return {app, [settings] { return runExport(*settings); }};
}

}  // namespace gp::tool
