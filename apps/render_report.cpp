#include "render_report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include "output.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

std::uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u;  // Linux counts in kibibytes
}

std::uint64_t totalRays(const GpFrameStatistics& s) {
    return s.cameraRays + s.bounceRays + s.shadowRays;
}

// In millions a second of tracing; the null backend takes no time.
double rate(double count, const GpFrameStatistics& s) {
    return s.secondsRender > 0 ? count * 1.0e-6 / s.secondsRender : 0.0;
}

double sampleCount(const GpFrameStatistics& s, const Size& size) {
    return static_cast<double>(size.width) * size.height * s.samplesPerPixel;
}

}  // namespace

Json reportJson(const RenderReport& report, const RenderSettings& settings) {
    const GpFrameStatistics& s = report.statistics;
    Json json;
    json["scene"] = settings.scenePath;
    json["output"] = settings.outputPath;
    json["width"] = settings.size.width;
    json["height"] = settings.size.height;
    json["spp"] = s.samplesPerPixel;
    const bool local = settings.local.mode == GP_MODE_LOCAL;
    const bool realtime = settings.local.mode == GP_MODE_REALTIME;
    json["mode"] = local ? "local" : realtime ? "realtime" : "reference";
    if (realtime) {
        json["frames"] = report.frames;
    }
    if (local) {
        json["lighting"] = report.lighting.model.empty() ? Json(nullptr)
                                                         : Json(report.lighting.model);
        json["frequency"] = report.lighting.frequency;
    } else {
        json["bounces"] = settings.bounces;
    }
    json["seed"] = settings.options.seed;
    json["seconds"] = {{"load", report.secondsLoad},
                       {"build", s.secondsBuild},
                       {"render", s.secondsRender}};
    json["rays"] = {{"camera", s.cameraRays},
                    {"bounce", s.bounceRays},
                    {"shadow", s.shadowRays},
                    {"total", totalRays(s)}};
    json["mrays_per_second"] = rate(static_cast<double>(totalRays(s)), s);
    json["msamples_per_second"] = rate(sampleCount(s, settings.size), s);
    json["noise"] = s.noise >= 0 ? Json(s.noise) : Json(nullptr);
    json["peak_memory_bytes"] = peakMemoryBytes();
    json["acceleration_bytes"] = s.accelerationBytes;
    json["frame_bytes"] = s.frameBytes;
    json["device"] = report.device;
    json["exposure_ev"] = report.exposureEv ? Json(*report.exposureEv) : Json(nullptr);
    json["interrupted"] = report.interrupted;
    return json;
}

std::string reportText(const RenderReport& report, const RenderSettings& settings) {
    const GpFrameStatistics& s = report.statistics;
    std::string text = fmt::format("{}: {}x{}, {} spp", settings.outputPath, settings.size.width,
                                   settings.size.height, s.samplesPerPixel);
    if (report.frames > 0) {
        text += fmt::format(" in {} frame{}", report.frames, report.frames > 1 ? "s" : "");
    }
    if (s.noise >= 0) {
        text += fmt::format(", noise {:.2f} %", 100 * s.noise);
    }
    if (report.exposureEv) {
        text += fmt::format(", exposure {:+.2f} EV{}", *report.exposureEv,
                            settings.exposureEv ? "" : " (automatic)");
    }
    text += fmt::format("; load {:.2f} s, build {:.2f} s, render {:.2f} s, {:.2f} Mrays/s, {}",
                        report.secondsLoad, s.secondsBuild, s.secondsRender,
                        rate(static_cast<double>(totalRays(s)), s),
                        bytesText(static_cast<double>(peakMemoryBytes())));
    return text;
}

}  // namespace gp::tool
