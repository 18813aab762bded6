// glitterpath animate: from a scene that moves to numbered pictures or a video.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "animate/animate_report.h"
#include "animate/frame_progress.h"
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

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

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
    addWord(app, "--denoiser", "NAME", "asvgf, svgf, atrous or none (default asvgf)",
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
    checkPictureSettings(r, video ? PictureFormat::png : pictureFormat(r.outputPath));
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

GpRenderOptions optionsOf(const AnimateSettings& s, double exposureEv, std::uint32_t frame) {
    GpRenderOptions options = s.render.options;
    options.exposureEv = static_cast<float>(exposureEv);
    // Noise of its own for each frame; where frames build on each other, they see to it themselves.
    if (s.mode == GP_MODE_REFERENCE) {
        options.seed += frame;
    }
    return options;
}

// Adds the times of the frame's passes; other modes than the real-time one have none.
void addPasses(GpDevice device, GpFrame frame, std::vector<PassSum>& sums) {
    std::vector<GpPassTime> times(64);
    std::uint32_t count = 0;
    check(device, gpGetPassTimes(frame, times.data(), static_cast<std::uint32_t>(times.size()),
                                 &count));
    times.resize(std::min<std::size_t>(count, times.size()));
    for (const GpPassTime& time : times) {
        const auto found = std::find_if(sums.begin(), sums.end(), [&](const PassSum& sum) {
            return sum.name == time.name;
        });
        if (found == sums.end()) {
            sums.push_back({time.name, time.milliseconds});
        } else {
            found->milliseconds += time.milliseconds;
        }
    }
}

// Renders and writes the frames until all are there or Ctrl-C comes.
void renderFrames(GpDevice device, GpFrame frame, MovingScene& moving, FrameWriter& writer,
                  const AnimateSettings& settings, AnimateReport& report) {
    FrameProgress progress(settings.render.quiet, settings.start, settings.frames);
    for (std::uint32_t i = settings.start; i < settings.frames && !interrupted(); ++i) {
        progress.begin(i, 0, 1);
        const Clock::time_point start = Clock::now();
        const GpCameraDesc camera = moving.goTo(i);
        if (!renderWith(device, frame, moving.scene(), camera,
                        optionsOf(settings, report.exposureEv, i), progress)) {
            break;
        }
        const Clock::time_point rendered = Clock::now();
        report.milliseconds.push_back(
            std::chrono::duration<double, std::milli>(rendered - start).count());
        check(device, gpGetFrameStatistics(frame, &report.last));
        report.rays += report.last.cameraRays + report.last.bounceRays + report.last.shadowRays;
        addPasses(device, frame, report.passes);
        writer.write(device, frame, i);
        report.secondsWrite += secondsSince(rendered);
    }
    if (settings.adapts()) {
        report.exposureEv = static_cast<double>(report.last.exposureEv);
    }
    report.interrupted = settings.start + report.milliseconds.size() < settings.frames;
}

int finish(FrameWriter& writer, const AnimateSettings& s, const AnimateReport& report) {
    const auto rendered = static_cast<std::uint32_t>(report.milliseconds.size());
    if (rendered > 0) {
        writer.finish();
    }
    if (!s.render.jsonPath.empty()) {
        writeJson(s.render.jsonPath, animateJson(report, s));
    }
    if (!report.interrupted) {
        say(s.render, "saved " + animateText(report, s));
        return kExitSuccess;
    }
    if (rendered == 0) {
        say(s.render, "interrupted before the first frame: nothing saved");
    } else {
        say(s.render, fmt::format("interrupted{}; saved {}",
                                  isVideo(s.render.outputPath)
                                      ? ""
                                      : fmt::format(" (go on with --start {})", s.start + rendered),
                                  animateText(report, s)));
    }
    return kExitInterrupted;
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
    AnimateReport report;
    report.device = gpGetDeviceName(device.get());
    report.secondsLoad = moving.secondsLoad();
    const std::optional<double> exposure = exposureOf(device.get(), moving, settings);
    report.exposureEv = exposure.value_or(0.0);
    if (exposure) {
        renderFrames(device.get(), frame.get(), moving, *writer, settings, report);
    } else {
        report.interrupted = true;
    }
    return finish(*writer, settings, report);
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
