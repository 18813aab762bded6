#include "render_realtime.h"

#include <fmt/format.h>

#include "animate/animate_settings.h"
#include "animate/frame_progress.h"
#include "commands.h"
#include "interrupt.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kGroup = "Real time";
// The scene stands still: only eyes would notice, and they are not asked.
constexpr double kSecondsPerFrame = 1.0 / 60.0;

void add(GpFrameStatistics& sum, const GpFrameStatistics& frame) {
    GpFrameStatistics all = frame;
    all.samplesPerPixel += sum.samplesPerPixel;
    all.cameraRays += sum.cameraRays;
    all.bounceRays += sum.bounceRays;
    all.shadowRays += sum.shadowRays;
    all.secondsBuild += sum.secondsBuild;
    all.secondsRender += sum.secondsRender;
    sum = all;
}

}  // namespace

void addRealtimeRenderOptions(CLI::App& app, RenderSettings& s) {
    addWord(app, "--frames", "N",
            "How many frames the picture builds on, 1..65536; the last one is written (default 16)",
            [&s](const std::string& word) {
                s.frames = static_cast<std::uint32_t>(parseInteger("--frames", word, 1, 65536));
            })->group(kGroup);
    addWord(app, "--denoiser", "NAME", "asvgf, svgf, atrous or none (default asvgf)",
            [&s](const std::string& word) {
                s.options.realtime.denoiser = parseDenoiser(word);
            })->group(kGroup);
    addRealtimeOptions(app, s);
}

void finishRealtimeRender(const CLI::App& app, RenderSettings& s) {
    if (s.local.mode != GP_MODE_REALTIME) {
        for (const CLI::Option* option : app.get_options()) {
            if (option->get_group() == kGroup && option->count() > 0) {
                throw UsageError(fmt::format("{}: only with --mode realtime", option->get_name()));
            }
        }
        return;
    }
    if (app.count("--spp") > 0) {
        throw UsageError("--spp: not in real time; --frames says how many frames there are");
    }
    constexpr std::uint32_t variance = 1u << GP_IMAGE_VARIANCE;
    if (s.everyLayer) {
        s.save.layers &= ~variance;
    } else if ((s.save.layers & variance) != 0) {
        throw UsageError("--aov: there is no variance in real time");
    }
    if (app.count("--bounces") == 0) {
        s.bounces = 1;
    }
    finishRealtime(s, kSecondsPerFrame);
}

void renderRealtime(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
                    const RenderSettings& settings, RenderReport& report) {
    GpRenderOptions options = settings.options;
    options.exposureEv = static_cast<float>(settings.exposureEv.value_or(0.0));
    FrameProgress progress(settings.quiet, 0, settings.frames);
    for (std::uint32_t i = 0; i < settings.frames; ++i) {
        progress.begin(i, 0, 1);
        check(device, gpRender(frame, scene, &camera, &options));
        GpFrameStatistics statistics{};
        check(device, gpGetFrameStatistics(frame, &statistics));
        add(report.statistics, statistics);
        ++report.frames;
        if (interrupted() && report.frames < settings.frames) {
            report.interrupted = true;
            return;
        }
    }
}

}  // namespace gp::tool
