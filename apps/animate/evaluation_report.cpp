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
    json["rmse"] = metrics::rootOf(meanFrom(v.mse, 0, s.skip));
    json["ssim"] = meanFrom(v.ssim, 0, s.skip);
    json["flip"] = meanFrom(v.flip, 0, s.skip);
    json["flicker"] = metrics::rootOf(meanFrom(v.squaredFlicker, 1, s.skip));
    if (s.lamp) {
        json["lag_frames"] = lampShows ? lagJson(v) : Json(nullptr);
    }
    Json& frames = json["per_frame"];
    frames["rmse"] = rootsOf(v.mse);
    frames["ssim"] = v.ssim;
    frames["flip"] = v.flip;
    frames["flicker"] = rootsOf(v.squaredFlicker);
    if (s.lamp) {
        frames["afterglow"] = v.afterglow;
    }
    return json;
}

// Of all frames that count.
metrics::ReferenceNoise noiseOf(const Evaluation& e, const EvaluateSettings& s) {
    std::vector<double> squares, ssim;
    for (const metrics::ReferenceNoise& frame : e.noise) {
        squares.push_back(frame.rmse * frame.rmse);
        ssim.push_back(frame.ssim);
    }
    return {metrics::rootOf(meanFrom(squares, 0, s.skip)), meanFrom(ssim, 0, s.skip)};
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
    const metrics::ReferenceNoise noise = noiseOf(e, s);
    json["reference_noise"] = {{"rmse", noise.rmse}, {"ssim", noise.ssim}};
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
    const Json& noise = json["reference_noise"];
    return text + fmt::format("noise of the references, which RMSE, SSIM and flicker leave out: "
                              "RMSE {:.4f}, SSIM of their halves {:.4f}\n",
                              noise["rmse"].get<double>(), noise["ssim"].get<double>());
}

}  // namespace gp::tool
