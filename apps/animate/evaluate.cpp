// glitterpath evaluate: how far the real-time picture is from the reference, frame by frame.
#include <fmt/format.h>

#include <algorithm>

#include "animate/evaluation_report.h"
#include "commands.h"
#include "interrupt.h"
#include "output.h"
#include "render_frame.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kNotes =
    "RMSE, SSIM and FLIP compare each frame with a path-traced one, both as they are shown.\n"
    "Flicker is the root mean square of how the error of luma changes along the motion of what is\n"
    "seen. Lag is the number of frames after the --lamp went out until less than 10 % of its\n"
    "light are left.\n\n"
    "Examples:\n"
    "  glitterpath evaluate fox.glb --frames 32 --path orbit --size 320x180 -o fox.html\n"
    "  glitterpath evaluate room.glb --frames 48 --lamp 0,1.8,0,1600 --spp 512 -o room.json";

constexpr std::uint32_t kReferenceSamples = 256;
// Histories have grown by then.
constexpr std::uint32_t kSkip = 16;

EvaluationLamp parseLamp(const std::string& word) {
    const std::vector<std::string> parts = splitAtCommas(word);
    if (parts.size() != 4) {
        throw UsageError(fmt::format("--lamp: '{}' must be X,Y,Z,LUMEN", word));
    }
    EvaluationLamp lamp;
    for (std::size_t i = 0; i < 3; ++i) {
        lamp.position[i] = static_cast<float>(parseNumber("--lamp", parts[i], -1e18, 1e18));
    }
    lamp.lumen = parseNumberFrom("--lamp", parts[3], 0, true);
    return lamp;
}

void addEvaluateOptions(CLI::App& app, EvaluateSettings& s, std::optional<std::uint32_t>& off) {
    RenderSettings& r = s.motion.render;
    addSceneOptions(app, r);
    addWord(app, "-o,--output", "OUT", "The report: .html, with plots and pictures, or .json",
            [&r](const std::string& word) { r.outputPath = word; })->required();
    addMotionOptions(app, s.motion);
    const std::string group = "Evaluation";
    addWord(app, "--skip", "N",
            "Frames at the beginning that means leave out (default 16, or half of the frames)",
            [&s](const std::string& word) {
                s.skip = static_cast<std::uint32_t>(parseInteger("--skip", word, 0, 1u << 20));
                s.skipGiven = true;
            })->group(group);
    addWord(app, "--lamp", "X,Y,Z,LUMEN",
            "Add a small lamp here, metres, that goes out in the middle, and measure how long its "
            "light stays",
            [&s](const std::string& word) { s.lamp = parseLamp(word); })->group(group);
    addWord(app, "--lamp-off", "N", "The first frame without the lamp (default half of the frames)",
            [&off](const std::string& word) {
                off = static_cast<std::uint32_t>(parseInteger("--lamp-off", word, 1, 1u << 20));
            })->group(group);
    addWord(app, "--denoiser", "A,B,...",
            "What to evaluate: asvgf, svgf, atrous, bmfr, none, with commas (default asvgf)",
            [&s](const std::string& word) {
                s.variants.clear();
                for (const std::string& name : splitAtCommas(word)) {
                    s.variants.push_back({name, {}});
                    s.variants.back().options.denoiser = parseDenoiser(name);
                }
            })->group("Real time");
    addRealtimeOptions(app, r);
    addCameraOptions(app, r);
    addLightOptions(app, r);
    addQualityOptions(app, r);
    addPictureOptions(app, r);
    addMachineOptions(app, r);
}

bool isPage(const std::string& path) {
    return path.ends_with(".html");
}

void checkEvaluation(EvaluateSettings& s, std::optional<std::uint32_t> off) {
    RenderSettings& r = s.motion.render;
    checkMotion(s.motion);
    checkLightSettings(r);
    checkPictureSettings(r, PictureFormat::page);
    if (!isPage(r.outputPath) && !r.outputPath.ends_with(".json")) {
        throw UsageError(
            fmt::format("--output: '{}' does not end in .html or .json", r.outputPath));
    }
    finishRealtime(r, 1 / s.motion.framesPerSecond);
    if (s.variants.empty()) {
        s.variants.push_back({"asvgf", {}});
    }
    for (Variant& variant : s.variants) {
        const GpDenoiser denoiser = variant.options.denoiser;
        variant.options = r.options.realtime;
        variant.options.denoiser = denoiser;
    }
    if (r.options.samplesPerPixel == 0) {
        r.options.samplesPerPixel = kReferenceSamples;
    }
    if (!s.skipGiven) {
        s.skip = std::min(kSkip, s.motion.frames / 2);
    }
    if (s.skip >= s.motion.frames) {
        throw UsageError(fmt::format("--skip: {} leaves none of {} frames", s.skip,
                                     s.motion.frames));
    }
    if (off && !s.lamp) {
        throw UsageError("--lamp-off: needs --lamp");
    }
    if (!s.lamp) {
        return;
    }
    s.lamp->offFrame = off.value_or(s.motion.frames / 2);
    if (s.lamp->offFrame == 0 || s.lamp->offFrame >= s.motion.frames) {
        throw UsageError(fmt::format("--lamp-off: {} must be in 1..{}", s.lamp->offFrame,
                                     s.motion.frames - 1));
    }
}

int runEvaluate(EvaluateSettings& s, std::optional<std::uint32_t> off) {
    checkEvaluation(s, off);
    RenderSettings& r = s.motion.render;
    checkWritable(r.outputPath);
    if (!r.jsonPath.empty()) {
        checkWritable(r.jsonPath);
    }
    r.device.instructionSet = r.instructionSet.empty() ? nullptr : r.instructionSet.c_str();
    const Device device = newDevice(r.device);
    const InterruptGuard guard(device.get());
    const std::optional<Evaluation> evaluation = evaluateVariants(device.get(), s);
    if (!evaluation) {
        say(r, "interrupted: nothing saved");
        return kExitInterrupted;
    }
    if (s.lamp && !evaluation->lampShows) {
        say(r, "the lamp lights nothing that is seen: no lag is measured");
    }
    const nlohmann::ordered_json json = evaluationJson(*evaluation, s);
    if (isPage(r.outputPath)) {
        writeText(r.outputPath, evaluationHtml(device.get(), *evaluation, s));
    } else {
        writeJson(r.outputPath, json);
    }
    if (!r.jsonPath.empty()) {
        writeJson(r.jsonPath, json);
    }
    say(r, "saved " + r.outputPath);
    if (!r.quiet) {
        fmt::print(stderr, "{}", evaluationText(*evaluation, s));
    }
    return kExitSuccess;
}

}  // namespace

Command addEvaluateCommand(CLI::App& tool) {
    CLI::App* app =
        tool.add_subcommand("evaluate", "Measure the real-time picture against the reference");
    const auto settings = std::make_shared<EvaluateSettings>();
    const auto off = std::make_shared<std::optional<std::uint32_t>>();
    addEvaluateOptions(*app, *settings, *off);
    app->footer(kNotes);
    return {app, [settings, off] { return runEvaluate(*settings, *off); }};
}

}  // namespace gp::tool
