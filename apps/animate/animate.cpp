// glitterpath animate: from a scene that moves to numbered pictures or a video.
#include <fmt/format.h>

#include "animate/animate_frames.h"
#include "animate/frame_writer.h"
#include "animate/moving_scene.h"
#include "commands.h"
#include "interrupt.h"
#include "output.h"
#include "render_frame.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kNotes =
    "The exposure `auto` is found once, from frame 0, by the rule of `glitterpath render`; with\n"
    "--eye-adaptation it is 0, and each frame has its own.\n"
    "Ctrl-C ends after the last whole frame, which stays; --start goes on from there.\n\n"
    "Examples:\n"
    "  glitterpath animate fox.glb --frames 48 --animation 2 -o fox.mp4\n"
    "  glitterpath animate ship.glb --frames 240 --path orbit --orbit-height 5 -o ship/%04d.png\n"
    "  glitterpath animate room.glb --frames 96 --path walk.json --mode reference --spp 32 "
    "-o walk.mp4\n"
    "  glitterpath animate room.glb --frames 96 --start 40 --path walk.json -o walk/%04d.png";

void addAnimateOptions(CLI::App& app, AnimateSettings& s) {
    addSceneOptions(app, s.render);
    addWord(app, "-o,--output", "OUT",
            "DIR/%04d.png (or .exr, .hdr): a file for each frame; or a video: .mp4, .mkv, .webm",
            [&s](const std::string& word) { s.render.outputPath = word; })->required();
    addMotionOptions(app, s);
    addWord(app, "--start", "N", "The first frame to render, to go on with numbered files (0)",
            [&s](const std::string& word) {
                s.start = static_cast<std::uint32_t>(parseInteger("--start", word, 0, 1u << 20));
            })->group("Motion");
    addWord(app, "--mode", "realtime|reference",
            "realtime: a path or so a pixel, denoised, with what the frames before have shown; "
            "reference: each frame path-traced by itself (default realtime)",
            [&s](const std::string& word) {
                const std::pair<const char*, GpFrameMode> choices[] = {
                    {"realtime", GP_MODE_REALTIME}, {"reference", GP_MODE_REFERENCE}};
                s.mode = parseChoice("--mode", word, choices);
            });
    addCameraOptions(app, s.render);
    addLightOptions(app, s.render);
    addWord(app, "--denoiser", "NAME", "asvgf, svgf, atrous, bmfr or none (default asvgf)",
            [&s](const std::string& word) {
                s.render.options.realtime.denoiser = parseDenoiser(word);
            })->group("Real time");
    addRealtimeOptions(app, s.render);
    addEyeOptions(app, s.render.options.realtime.eyeAdaptation);
    addQualityOptions(app, s.render);
    addPictureOptions(app, s.render);
    addMachineOptions(app, s.render);
}

void prepare(const CLI::App& app, AnimateSettings& s) {
    RenderSettings& r = s.render;
    checkMotion(s);
    checkLightSettings(r);
    checkFrameOutput(r.outputPath, r.size);
    const bool video = isVideo(r.outputPath);
    checkPictureSettings(r, video ? PictureFormat::page : pictureFormat(r.outputPath));
    if (s.start >= s.frames) {
        throw UsageError(fmt::format("--start: {} is not below --frames {}", s.start, s.frames));
    }
    if (video && s.start > 0) {
        throw UsageError("--start: a video is written in one go; use numbered files");
    }
    if (!r.jsonPath.empty()) {
        checkWritable(r.jsonPath);
    }
    if (s.mode == GP_MODE_REALTIME) {
        if (r.options.samplesPerPixel > 1) {
            throw UsageError("--spp: only with --mode reference");
        }
        finishRealtime(r, 1 / s.framesPerSecond);
        if (app.count("--eye-range") > 0 && !s.adapts()) {
            throw UsageError("--eye-range: needs --eye-adaptation");
        }
    } else {
        for (const char* name :
             {"--aa", "--render-scale", "--mirrors", "--denoiser", "--light-reuse",
              "--indirect-reuse", "--tune", "--eye-adaptation", "--eye-range"}) {
            if (app.count(name) > 0) {
                throw UsageError(fmt::format("{}: only with --mode realtime", name));
            }
        }
    }
    r.local.mode = s.mode;
    r.device.instructionSet = r.instructionSet.empty() ? nullptr : r.instructionSet.c_str();
}

int runAnimate(const CLI::App& app, AnimateSettings& settings) {
    prepare(app, settings);
    const RenderSettings& r = settings.render;
    const Device device = newDevice(r.device);
    const InterruptGuard guard(device.get());
    // The first things that can fail: before anybody waits for a scene.
    const Frame frame = newFrameFor(device.get(), r);
    const std::unique_ptr<FrameWriter> writer =
        newFrameWriter(r.outputPath, {r.size, settings.framesPerSecond}, r.save);
    MovingScene moving(device.get(), settings);
    for (const std::string& note : moving.notes()) {
        say(r, note);
    }
    const std::optional<double> exposure = exposureOf(device.get(), moving, settings);
    const FrameSource source = {moving.scene(), [&](std::uint32_t i) { return moving.goTo(i); },
                                moving.secondsLoad()};
    return animateFrames(device.get(), frame.get(), source, exposure, *writer, settings);
}

}  // namespace

Command addAnimateCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("animate", "Render a moving picture: files or a video");
    const auto settings = std::make_shared<AnimateSettings>();
    addAnimateOptions(*app, *settings);
    app->footer(kNotes);
    return {app, [app, settings] { return runAnimate(*app, *settings); }};
}

}  // namespace gp::tool
