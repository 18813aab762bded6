#include "animate/evaluation_report.h"

#include <fmt/format.h>

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

Json lagJson(const VariantResult& variant) {
    const auto lag = metrics::lagFrames(variant.afterglow, EvaluateSettings::lagLimit);
    return lag ? Json(*lag) : Json(nullptr);
}

Json variantJson(const VariantResult& v, const EvaluateSettings& s, bool lampShows) {
    Json json;
    json["name"] = v.name;
    json["milliseconds"] = meanFrom(v.milliseconds, 0, s.skip);
    json["rmse"] = meanFrom(v.rmse, 0, s.skip);
    json["ssim"] = meanFrom(v.ssim, 0, s.skip);
    json["flip"] = meanFrom(v.flip, 0, s.skip);
    json["flicker"] = meanFrom(v.flicker, 1, s.skip);
    if (s.lamp) {
        json["lag_frames"] = lampShows ? lagJson(v) : Json(nullptr);
    }
    Json& frames = json["per_frame"];
    frames["rmse"] = v.rmse;
    frames["ssim"] = v.ssim;
    frames["flip"] = v.flip;
    frames["flicker"] = v.flicker;
    if (s.lamp) {
        frames["afterglow"] = v.afterglow;
    }
    return json;
}

}  // namespace

Json evaluationJson(const Evaluation& e, const EvaluateSettings& s) {
    const RenderSettings& r = s.motion.render;
    Json json;
    json["scene"] = r.scenePath;
    json["width"] = r.size.width;
    json["height"] = r.size.height;
    json["frames"] = s.motion.frames;
    json["fps"] = s.motion.framesPerSecond;
    json["skip"] = s.skip;
    json["reference_spp"] = r.options.samplesPerPixel;
    json["exposure_ev"] = e.exposureEv;
    json["device"] = e.device;
    if (s.lamp) {
        json["lamp"] = {{"position", s.lamp->position},
                        {"lumen", s.lamp->lumen},
                        {"off_frame", s.lamp->offFrame},
                        {"shows", e.lampShows},
                        {"lag_limit", EvaluateSettings::lagLimit}};
    }
    json["variants"] = Json::array();
    for (const VariantResult& variant : e.variants) {
        json["variants"].push_back(variantJson(variant, s, e.lampShows));
    }
    return json;
}

std::string evaluationText(const Evaluation& e, const EvaluateSettings& s) {
    std::size_t width = 8;
    for (const VariantResult& v : e.variants) {
        width = std::max(width, v.name.size());
    }
    std::string text = fmt::format("{:{}}  {:>8}  {:>7}  {:>7}  {:>7}  {:>8}{}\n", "", width,
                                   "ms", "RMSE", "SSIM", "FLIP", "flicker",
                                   s.lamp ? "  lag" : "");
    const Json json = evaluationJson(e, s);
    for (const Json& v : json["variants"]) {
        text += fmt::format("{:{}}  {:8.2f}  {:7.4f}  {:7.4f}  {:7.4f}  {:8.4f}",
                            v["name"].get<std::string>(), width, v["milliseconds"].get<double>(),
                            v["rmse"].get<double>(), v["ssim"].get<double>(),
                            v["flip"].get<double>(), v["flicker"].get<double>());
        if (s.lamp) {
            text += v["lag_frames"].is_null()
                        ? "    -"
                        : fmt::format("  {:3}", v["lag_frames"].get<std::size_t>());
        }
        text += '\n';
    }
    return text;
}

}  // namespace gp::tool
