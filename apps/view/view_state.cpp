// ViewModel::stateJson: where things stand, for scripts.
#include "view/view_model.h"
#include "view/view_words.h"

namespace gp::tool::view {
namespace {

using Json = nlohmann::ordered_json;

Json lightsJson(const std::vector<SceneLight>& lights) {
    Json all = Json::array();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const SceneLight& light = lights[i];
        if (!light.isRemoved) {
            all.push_back({{"number", i},
                           {"name", light.name},
                           {"kind", wordOf(light.desc.kind, kLightKindWords)},
                           {"on", light.isOn},
                           {"color", light.desc.color},
                           {"intensity", light.desc.intensity},
                           {"position", light.desc.position},
                           {"direction", light.desc.direction}});
        }
    }
    return all;
}

}  // namespace

Json ViewModel::stateJson() const {
    const GpCameraDesc camera = m_camera.desc();
    Json json;
    json["position"] = camera.position;
    json["target"] = camera.target;
    json["speed"] = m_camera.speed();
    json["live"] = wordOf(m_choices.live, kLiveWords);
    json["reference"] = m_choices.reference;
    json["image"] = m_choices.image;
    json["panels"] = m_showsPanels;
    json["denoiser"] = m_facts.denoisers.nameOf(m_choices.realtime.denoiser);
    json["light_reuse"] = wordOf(m_choices.realtime.lightReuse, kLightReuseWords);
    json["tuned"] = m_choices.realtime.numbers;
    json["divider"] = m_choices.divider;
    json["lights"] = lightsJson(lights());
    json["sea"] = seaJson();
    if (m_picture) {
        json["render_size"] = {m_picture->size.width, m_picture->size.height};
        json["scale"] = m_picture->scale;
        json["render_scale"] = m_picture->renderScale;
        json["samples_beside"] = m_picture->samplesBeside;
        json["rmse_beside"] = m_picture->rmseBeside;
        if (m_picture->heat) {
            json["heat"] = {{"high", m_picture->heat->high}, {"unit", m_picture->heat->unit}};
        }
        json["at_rest"] = m_picture->atRest;
        json["samples_per_pixel"] = m_picture->statistics.samplesPerPixel;
        json["exposure_ev"] = m_picture->exposureEv;
        json["live_frames"] = m_picture->liveFrames;
        json["note"] = m_picture->note;
        for (const auto& [pass, milliseconds] : m_picture->passes) {
            json["passes"][pass] = milliseconds;
        }
    }
    json["milliseconds_per_frame"] = {{"mean", m_times.mean()},
                                      {"p50", m_times.percentile(50)},
                                      {"p95", m_times.percentile(95)}};
    json["thing"] = nullptr;
    if (const std::optional<PickedThing>& picked = thing()) {
        json["thing"] = {{"instance", picked->instance},
                         {"name", picked->instanceName},
                         {"mesh", picked->meshName},
                         {"material", picked->materialName},
                         {"model", picked->model},
                         {"pinned", isPinned()}};
        for (const auto& [parameter, value] : picked->parameters) {
            json["thing"]["parameters"][parameter] = value;
        }
    }
    json["message"] = m_message.text;
    return json;
}

}  // namespace gp::tool::view
