#include "animate/animate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

double percentile(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    const double rank = std::ceil(part * static_cast<double>(values.size()));
    return values[static_cast<std::size_t>(std::max(rank - 1, 0.0))];
}

Json animateJson(const AnimateReport& report, const AnimateSettings& settings) {
    const RenderSettings& s = settings.render;
    const auto frames = report.milliseconds.size();
    const double pixels = static_cast<double>(s.size.width) * s.size.height;
    Json json;
    json["scene"] = s.scenePath;
    json["output"] = s.outputPath;
    json["mode"] = settings.mode == GP_MODE_REALTIME ? "realtime" : "reference";
    json["width"] = s.size.width;
    json["height"] = s.size.height;
    json["fps"] = settings.framesPerSecond;
    json["spp"] = report.last.samplesPerPixel;
    json["first_frame"] = settings.start;
    json["frames"] = frames;
    json["milliseconds_per_frame"] = nullptr;
    if (frames > 0) {
        json["milliseconds_per_frame"] = {{"mean", mean(report.milliseconds)},
                                          {"p50", percentile(report.milliseconds, 0.5)},
                                          {"p95", percentile(report.milliseconds, 0.95)}};
    }
    json["passes"] = Json::object();
    for (const PassSum& pass : report.passes) {
        json["passes"][pass.name] = pass.milliseconds / static_cast<double>(frames);
    }
    json["rays_per_frame"] =
        frames > 0 ? Json(static_cast<double>(report.rays) / static_cast<double>(frames)) : nullptr;
    json["frame_image_bytes_per_pixel"] = static_cast<double>(report.last.frameBytes) / pixels;
    json["seconds"] = {{"load", report.secondsLoad}, {"write", report.secondsWrite}};
    json["exposure_ev"] = report.exposureEv;
    json["device"] = report.device;
    json["interrupted"] = report.interrupted;
    return json;
}

std::string animateText(const AnimateReport& report, const AnimateSettings& settings) {
    const RenderSettings& s = settings.render;
    std::string text = fmt::format("{}: {} frames of {}x{}, {} spp", s.outputPath,
                                   report.milliseconds.size(), s.size.width, s.size.height,
                                   report.last.samplesPerPixel);
    if (!report.milliseconds.empty()) {
        text += fmt::format(", {:.1f} ms a frame (95 %: {:.1f})", mean(report.milliseconds),
                            percentile(report.milliseconds, 0.95));
    }
    return text + fmt::format(", exposure {:+.2f} EV{}", report.exposureEv,
                              settings.adapts() ? " (adapted, last frame)"
                              : s.exposureEv      ? ""
                                                  : " (automatic)");
}

}  // namespace gp::tool
