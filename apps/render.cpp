// glitterpath render: from a scene file to a picture.
#include <fmt/format.h>

#include <vector>

#include "commands.h"
#include "exposure.h"
#include "interrupt.h"
#include "lighting_sheet.h"
#include "output.h"
#include "render_frame.h"
#include "render_realtime.h"
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
    "  glitterpath render box.glb -o box.png --time-limit 30 --json - --quiet\n"
    "  glitterpath render room.glb -o room.png --mode realtime --frames 32 --denoiser svgf\n"
    "  glitterpath render ship.glb -o ship.png --mode local --lighting ward:alpha_x=0.3\n"
    "  glitterpath render ship.glb -o sheet.png --mode local --lighting all";

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

void prepare(const CLI::App& app, RenderSettings& settings) {
    const bool sheet = isSheet(settings.local);
    if (sheet) {
        checkSheet(settings);
    }
    checkSettings(app, settings);
    if (sheet && !settings.sizeGiven) {
        settings.size = {320, 180};
    }
    checkWritable(settings.outputPath);
    if (!settings.jsonPath.empty()) {
        checkWritable(settings.jsonPath);
    }
    settings.local.models.quiet = settings.quiet;
    settings.device.instructionSet =
        settings.instructionSet.empty() ? nullptr : settings.instructionSet.c_str();
}

int renderPicture(GpDevice device, const SceneSetup& setup, const GpCameraDesc& camera,
                  const RenderSettings& settings, const Lighting& lighting) {
    if (pictureFormat(settings.outputPath) != PictureFormat::png &&
        (settings.exposureGiven || settings.tonemapGiven)) {
        say(settings, ".exr and .hdr hold radiance: --exposure and --tonemap change nothing");
    }
    if (interrupted()) {
        return nothingSaved(settings);
    }
    const Frame frame = newFrameFor(device, settings);
    RenderReport report;
    report.secondsLoad = setup.secondsLoad;
    report.device = gpGetDeviceName(device);
    report.lighting = lighting;
    if (settings.local.mode == GP_MODE_REALTIME) {
        renderRealtime(device, frame.get(), setup.scene.get(), camera, settings, report);
    } else {
        report.interrupted =
            !trace(device, frame.get(), setup.scene.get(), camera, settings, lighting.local);
        check(device, gpGetFrameStatistics(frame.get(), &report.statistics));
    }
    if (report.interrupted && report.statistics.samplesPerPixel == 0) {
        return nothingSaved(settings);
    }
    return saveResults(device, frame.get(), report, settings);
}

int runRender(const CLI::App& app, RenderSettings& settings) {
    prepare(app, settings);
    const Device device = newDevice(settings.device);
    // A frame of real time that was cancelled is half of one: there the last whole one counts.
    const bool realtime = settings.local.mode == GP_MODE_REALTIME;
    const InterruptGuard guard(realtime ? nullptr : device.get());
    const std::vector<Model> models = lightingModels(device.get(), settings.local);
    SceneSetup setup = setUpScene(device.get(), settings);
    const GpCameraDesc camera =
        setUpCamera(device.get(), setup.scene.get(), settings, setup.notes);
    for (const std::string& note : setup.notes) {
        say(settings, note);
    }
    const std::vector<Lighting> lightings = lightingsOf(settings.local, models);
    if (isSheet(settings.local)) {
        return renderSheet(device.get(), setup.scene.get(), camera, settings, lightings);
    }
    return renderPicture(device.get(), setup, camera, settings, lightings.front());
}

}  // namespace

Command addRenderCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("render", "Render a scene into a picture");
    const auto settings = std::make_shared<RenderSettings>();
    addRenderOptions(*app, *settings);
    app->footer(std::string(kExposureRule) +
                "\n\nCtrl-C ends the render and saves what there is; a second one kills.\n\n" +
                kExamples);
    return {app, [app, settings] { return runRender(*app, *settings); }};
}

}  // namespace gp::tool
