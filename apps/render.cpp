// glitterpath render: from a scene file to a picture.
#include <fmt/format.h>

#include <cstdio>
#include <vector>

#include "commands.h"
#include "exposure.h"
#include "interrupt.h"
#include "output.h"
#include "progress_bar.h"
#include "render_report.h"
#include "render_settings.h"
#include "scene_setup.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  glitterpath render helmet.glb -o helmet.png\n"
    "  glitterpath render helmet.glb -o helmet.png --env studio.hdr --noise 0.02\n"
    "  glitterpath render room.glb -o room.exr --size 1920x1080 --spp 1024 --aov albedo,normal\n"
    "  glitterpath render ship.glb -o ship.png --sun 120,25,0 --from 8,3,10 --fov 35\n"
    "  glitterpath render cup.glb -o cup.png --material gold --material handle=leather:sheen=0.4\n"
    "  glitterpath render box.glb -o box.png --time-limit 30 --json - --quiet";

// Messages for people go to stderr, so that stdout is free for --json -.
void say(const RenderSettings& settings, const std::string& text) {
    if (!settings.quiet) {
        fmt::print(stderr, "glitterpath: {}\n", text);
    }
}

int onProgress(void* user, const GpProgress* progress) {
    static_cast<ProgressBar*>(user)->show(*progress);
    // The signal may have come just before the render began.
    return interrupted() ? 1 : 0;
}

// Returns false when it was cancelled.
bool trace(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
           const RenderSettings& settings) {
    ProgressBar bar(stderrIsTerminal() && !settings.quiet);
    GpRenderOptions options = settings.options;
    options.exposureEv = static_cast<float>(settings.exposureEv.value_or(0.0));
    options.progress = &onProgress;
    options.progressUser = &bar;
    const GpError error = gpRender(frame, scene, &camera, &options);
    if (error == GP_ERROR_CANCELLED) {
        gpGetError(device, nullptr);  // it is no failure, so nobody shall find it later
        return false;
    }
    bar.clear();
    check(device, error);
    return true;
}

double exposeAutomatically(GpDevice device, GpFrame frame, const RenderSettings& settings) {
    const std::size_t count = static_cast<std::size_t>(settings.size.width) * settings.size.height;
    std::vector<float> pixels(4 * count);
    check(device, gpReadFrameImage(frame, GP_IMAGE_COLOR, pixels.data(),
                                   pixels.size() * sizeof(float)));
    const double ev = automaticExposureEv(pixels.data(), count);
    check(device, gpTonemapFrame(frame, static_cast<float>(ev), settings.options.tonemap));
    return ev;
}

int nothingSaved(const RenderSettings& settings) {
    say(settings, "interrupted before the first sample: nothing saved");
    return kExitInterrupted;
}

int saveResults(GpDevice device, GpFrame frame, RenderReport& report,
                const RenderSettings& settings) {
    if (pictureFormat(settings.outputPath) == PictureFormat::png) {
        report.exposureEv = settings.exposureEv ? *settings.exposureEv
                                                : exposeAutomatically(device, frame, settings);
    }
    check(device, gpSaveFrame(frame, settings.outputPath.c_str(), &settings.save));
    if (!settings.jsonPath.empty()) {
        writeJson(settings.jsonPath, reportJson(report, settings));
    }
    say(settings, (report.interrupted ? "interrupted; saved " : "saved ") +
                      reportText(report, settings));
    return report.interrupted ? kExitInterrupted : kExitSuccess;
}

int runRender(RenderSettings& settings) {
    checkSettings(settings);
    checkWritable(settings.outputPath);
    if (!settings.jsonPath.empty()) {
        checkWritable(settings.jsonPath);
    }
    settings.device.instructionSet =
        settings.instructionSet.empty() ? nullptr : settings.instructionSet.c_str();
    const Device device = newDevice(settings.device);
    const InterruptGuard guard(device.get());
    SceneSetup setup = setUpScene(device.get(), settings);
    const GpCameraDesc camera =
        setUpCamera(device.get(), setup.scene.get(), settings, setup.notes);
    for (const std::string& note : setup.notes) {
        say(settings, note);
    }
    if (pictureFormat(settings.outputPath) != PictureFormat::png &&
        (settings.exposureGiven || settings.tonemapGiven)) {
        say(settings, ".exr and .hdr hold radiance: --exposure and --tonemap change nothing");
    }
    if (interrupted()) {
        return nothingSaved(settings);
    }
    GpFrameDesc desc{};
    desc.width = settings.size.width;
    desc.height = settings.size.height;
    const Frame frame = newFrame(device.get(), desc);
    RenderReport report;
    report.secondsLoad = setup.secondsLoad;
    report.device = gpGetDeviceName(device.get());
    report.interrupted = !trace(device.get(), frame.get(), setup.scene.get(), camera, settings);
    check(device.get(), gpGetFrameStatistics(frame.get(), &report.statistics));
    if (report.interrupted && report.statistics.samplesPerPixel == 0) {
        return nothingSaved(settings);
    }
    return saveResults(device.get(), frame.get(), report, settings);
}

}  // namespace

Command addRenderCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("render", "Path-trace a scene into a picture");
    const auto settings = std::make_shared<RenderSettings>();
    addRenderOptions(*app, *settings);
    app->footer(std::string(kExposureRule) +
                "\n\nCtrl-C ends the render and saves what there is; a second one kills.\n\n" +
                kExamples);
    return {app, [settings] { return runRender(*settings); }};
}

}  // namespace gp::tool
