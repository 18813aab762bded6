// The surroundings, a lamp of one's own, and the lights of the scene.
#include <algorithm>

#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

constexpr std::pair<const char*, Surroundings::Kind> kSurroundings[] = {
    {"as loaded", Surroundings::Kind::asLoaded},
    {"sky and sun", Surroundings::Kind::sky},
    {"one color", Surroundings::Kind::color}};

void drawSurroundings(Surroundings& s) {
    chooseWord("surroundings", s.kind, kSurroundings);
    if (s.kind == Surroundings::Kind::sky) {
        ImGui::SliderFloat("sun azimuth", &s.azimuthDeg, 0.0f, 360.0f, "%.0f deg");
        if (ImGui::SliderFloat("elevation", &s.elevationDeg, 0.0f, 90.0f, "%.0f deg")) {
            s.elevationDeg = std::clamp(s.elevationDeg, 0.0f, 90.0f);
        }
        if (ImGui::DragFloat("lux (0: own)", &s.lux, 100.0f, 0.0f, 200000.0f, "%.0f")) {
            s.lux = std::max(s.lux, 0.0f);
        }
    } else if (s.kind == Surroundings::Kind::color) {
        ImGui::ColorEdit3("radiance", s.color,
                          ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_Float);
        std::transform(s.color, s.color + 3, s.color, [](float v) { return std::max(v, 0.0f); });
    }
}

void drawLamp(HandLamp& lamp, const FlyCamera& camera) {
    ImGui::Checkbox("lamp in the hand", &lamp.isOn);
    if (!lamp.isOn) {
        return;
    }
    if (ImGui::SliderFloat("W/sr", &lamp.intensity, 0.01f, 10000.0f, "%.2f",
                           ImGuiSliderFlags_Logarithmic)) {
        lamp.intensity = std::max(lamp.intensity, 0.0f);
    }
    if (ImGui::Button(lamp.followsCamera ? "Put it down here" : "Take it up again")) {
        lamp.followsCamera = !lamp.followsCamera;
        std::copy_n(camera.desc().position, 3, lamp.position);
    }
}

}  // namespace

void drawLightPanel(ViewModel& model) {
    if (!ImGui::CollapsingHeader("Light")) {
        return;
    }
    drawSurroundings(model.choices().surroundings);
    drawLamp(model.choices().lamp, model.camera());
    drawSceneLights(model);
}

}  // namespace gp::tool::view
