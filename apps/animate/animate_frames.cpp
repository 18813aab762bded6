#include "animate/animate_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "animate/animate_report.h"
#include "animate/frame_progress.h"
#include "interrupt.h"
#include "output.h"
#include "render_frame.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
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
void renderFrames(GpDevice device, GpFrame frame, const FrameSource& source, FrameWriter& writer,
                  const AnimateSettings& settings, AnimateReport& report) {
    FrameProgress progress(settings.render.quiet, settings.start, settings.frames);
    for (std::uint32_t i = settings.start; i < settings.frames && !interrupted(); ++i) {
        progress.begin(i, 0, 1);
        const Clock::time_point start = Clock::now();
        const GpCameraDesc camera = source.goTo(i);
        if (!renderWith(device, frame, source.scene, camera,
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

}  // namespace

int animateFrames(GpDevice device, GpFrame frame, const FrameSource& source,
                  std::optional<double> exposureEv, FrameWriter& writer,
                  const AnimateSettings& settings) {
    AnimateReport report;
    report.device = gpGetDeviceName(device);
    report.secondsLoad = source.secondsLoad;
    report.exposureEv = exposureEv.value_or(0.0);
    if (exposureEv) {
        renderFrames(device, frame, source, writer, settings, report);
    } else {
        report.interrupted = true;
    }
    return finish(writer, settings, report);
}

}  // namespace gp::tool
