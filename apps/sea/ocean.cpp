// glitterpath ocean: the sea with a sky over it, as a picture or a moving one.
#include <fmt/format.h>

#include "animate/animate_frames.h"
#include "animate/moving_scene.h"
#include "commands.h"
#include "interrupt.h"
#include "sea/ocean_settings.h"
#include "output.h"
#include "render_frame.h"
#include "render_realtime.h"
#include "render_report.h"
#include "scene_setup.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kNotes =
    "The camera stands at x = z = 0. The exposure `auto` follows the rule of `glitterpath\n"
    "render`, for a moving picture from its first frame. Ctrl-C saves what there is.\n\n"
    "Examples:\n"
    "  glitterpath ocean -o sea.png\n"
    "  glitterpath ocean --wind 6 --sun 0,3 --camera-height 12 --samples 256 -o sunset.png\n"
    "  glitterpath ocean --wind 12 --fetch 300 --frames 240 --fps 24 -o sea.mp4\n"
    "  glitterpath ocean --wind 8 --sun 0,10 --mode local --samples 8 -o quick.png\n"
    "  glitterpath ocean --env harbour.hdr --depth 4 --spectrum tma --size 1920x1080 -o bay.exr";

GpCameraDesc cameraOf(const OceanSettings& s) {
    return s.camera.over(s.sea, s.picture.render.fovDeg);
}

SceneSetup setUpSea(GpDevice device, const OceanSettings& s) {
    SceneSetup setup;
    setup.scene = newScene(device);
    check(device, gpSetOcean(setup.scene.get(), &s.sea));
    check(device, gpSetOceanTime(setup.scene.get(), s.timeSeconds));
    if (!s.mapFolder.empty()) {
        check(device, gpSaveOceanMaps(setup.scene.get(), s.mapFolder.c_str()));
    }
    addLight(device, s.picture.render, setup);
    return setup;
}

int nothingSaved(const RenderSettings& settings) {
    say(settings, "interrupted before the first sample: nothing saved");
    return kExitInterrupted;
}

int renderMoving(GpDevice device, const OceanSettings& s) {
    const RenderSettings& r = s.picture.render;
    const Frame frame = newFrameFor(device, r);
    const std::unique_ptr<FrameWriter> writer =
        newFrameWriter(r.outputPath, {r.size, s.picture.framesPerSecond}, r.save);
    const SceneSetup setup = setUpSea(device, s);
    const GpCameraDesc camera = cameraOf(s);
    GpScene scene = setup.scene.get();
    std::optional<double> exposure = r.exposureEv;
    if (!exposure) {
        exposure = exposureOf(device, scene, camera, r);
    }
    const FrameSource source = {scene, [&](std::uint32_t i) {
                                    const double time =
                                        s.timeSeconds + i / s.picture.framesPerSecond;
                                    check(device, gpSetOceanTime(scene, time));
                                    return camera;
                                }, setup.secondsLoad};
    return animateFrames(device, frame.get(), source, exposure, *writer, s.picture);
}

int renderStill(GpDevice device, const OceanSettings& s) {
    const RenderSettings& r = s.picture.render;
    const SceneSetup setup = setUpSea(device, s);
    const GpCameraDesc camera = cameraOf(s);
    const Frame frame = newFrameFor(device, r);
    RenderReport report;
    report.device = gpGetDeviceName(device);
    if (r.local.mode == GP_MODE_REALTIME) {
        renderRealtime(device, frame.get(), setup.scene.get(), camera, r, report);
    } else {
        report.interrupted =
            !trace(device, frame.get(), setup.scene.get(), camera, r, r.options.local);
        check(device, gpGetFrameStatistics(frame.get(), &report.statistics));
    }
    if (report.interrupted && report.statistics.samplesPerPixel == 0) {
        return nothingSaved(r);
    }
    if (pictureFormat(r.outputPath) == PictureFormat::png) {
        report.exposureEv =
            r.exposureEv ? *r.exposureEv : exposeAutomatically(device, frame.get(), r);
    }
    check(device, gpSaveFrame(frame.get(), r.outputPath.c_str(), &r.save));
    if (!r.jsonPath.empty()) {
        writeJson(r.jsonPath, reportJson(report, r));
    }
    say(r, (report.interrupted ? "interrupted; saved " : "saved ") + reportText(report, r));
    return report.interrupted ? kExitInterrupted : kExitSuccess;
}

int runOcean(const CLI::App& app, OceanSettings& settings) {
    checkOceanSettings(app, settings);
    const Device device = newDevice(settings.picture.render.device);
    // A frame of real time that was cancelled is half of one: there the last whole one counts.
    const bool still = !settings.moves() && settings.picture.mode == GP_MODE_REALTIME;
    const InterruptGuard guard(still ? nullptr : device.get());
    return settings.moves() ? renderMoving(device.get(), settings)
                            : renderStill(device.get(), settings);
}

}  // namespace

Command addOceanCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("ocean", "Render the sea: a picture or a moving one");
    const auto settings = std::make_shared<OceanSettings>();
    addOceanOptions(*app, *settings);
    app->footer(kNotes);
    return {app, [app, settings] { return runOcean(*app, *settings); }};
}

}  // namespace gp::tool
