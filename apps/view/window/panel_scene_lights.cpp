// The scene's lights, one by one: switched, changed, added, removed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/view_words.h"
#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

constexpr float kDegrees = 180.0f / std::numbers::pi_v<float>;
// More are scrolled through.
constexpr float kListRows = 6;

void drawRow(ViewModel& model, std::size_t i) {
    const SceneLight& light = model.lights()[i];
    ImGui::PushID(static_cast<int>(i));
    bool isOn = light.isOn;
    if (light.isRemoved) {
        ImGui::TextDisabled("%d  removed", static_cast<int>(i));
    } else {
        if (ImGui::Checkbox("##on", &isOn)) {
            model.changeLight(i, [isOn](SceneLight& l) { l.isOn = isOn; });
        }
        ImGui::SameLine();
        const std::string label = fmt::format(
            "{}  {}  {}", i, wordOf(light.desc.kind, kLightKindWords), light.name);
        if (ImGui::Selectable(label.c_str(), model.selectedLight() == i)) {
            model.selectedLight() = i;
        }
    }
    ImGui::PopID();
}

void drawList(ViewModel& model) {
    const float height = ImGui::GetFrameHeightWithSpacing() *
                         std::min(static_cast<float>(model.lights().size()) + 0.3f, kListRows);
    ImGui::BeginChild("lights", ImVec2(0, height), true);
    ImGuiListClipper clipper;  // there may be 100,000
    clipper.Begin(static_cast<int>(model.lights().size()), ImGui::GetFrameHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(model, static_cast<std::size_t>(i));
        }
    }
    ImGui::EndChild();
}

void drawDegrees(const char* label, float& radians, float least) {
    float degrees = radians * kDegrees;
    if (ImGui::SliderFloat(label, &degrees, 0.0f, 90.0f, "%.2f deg")) {
        radians = std::clamp(degrees / kDegrees, least, 0.5f * std::numbers::pi_v<float>);
    }
}

void drawMetres(const char* label, float& metres, float least) {
    if (ImGui::DragFloat(label, &metres, std::max(0.01f * metres, 1.0e-4f), least, 1.0e6f,
                         "%.3g m")) {
        metres = std::clamp(metres, least, 1.0e6f);
    }
}

void drawShape(GpLightDesc& d) {
    if (d.kind == GP_LIGHT_DIRECTIONAL) {
        drawDegrees("angular radius", d.angularRadius, 0.0f);
    } else if (d.kind == GP_LIGHT_RECTANGLE) {
        const std::pair<const char*, float*> edges[] = {{"width", d.edgeU}, {"height", d.edgeV}};
        for (const auto& [label, edge] : edges) {
            float length = edgeLength(edge);
            const float before = length;
            drawMetres(label, length, 1.0e-3f);
            if (length != before) {
                scaleEdge(edge, length);
            }
        }
    } else if (d.kind != GP_LIGHT_POLYGON) {
        drawMetres("radius", d.radius, 0.0f);
    }
    if (d.kind == GP_LIGHT_SPOT) {
        drawDegrees("cone", d.outerAngle, 1.0e-3f);
        d.innerAngle = std::min(d.innerAngle, d.outerAngle);
        drawDegrees("inner cone", d.innerAngle, 0.0f);
        d.innerAngle = std::min(d.innerAngle, d.outerAngle);
    }
}

void drawPlace(GpLightDesc& d, const GpCameraDesc& camera, float reach) {
    const bool hasPlace = d.kind != GP_LIGHT_DIRECTIONAL && d.kind != GP_LIGHT_POLYGON;
    const bool hasDirection = d.kind == GP_LIGHT_DIRECTIONAL || d.kind == GP_LIGHT_SPOT;
    if (hasPlace) {
        ImGui::DragFloat3("position, m", d.position, 0.005f * reach, 0.0f, 0.0f, "%.3g");
    }
    if (hasDirection) {
        float direction[3];
        std::copy_n(d.direction, 3, direction);
        if (ImGui::DragFloat3("direction", direction, 0.01f, -1.0f, 1.0f, "%.2f") &&
            edgeLength(direction) > 1.0e-3f) {
            std::copy_n(direction, 3, d.direction);
        }
    }
    if (hasPlace && ImGui::Button("Bring it here")) {
        std::copy_n(camera.position, 3, d.position);
    }
    if (hasPlace && hasDirection) {
        ImGui::SameLine();
    }
    if (hasDirection && ImGui::Button("Aim where I look")) {
        for (int i = 0; i < 3; ++i) {
            d.direction[i] = camera.target[i] - camera.position[i];
        }
    }
}

void drawSelected(ViewModel& model) {
    const std::size_t i = model.selectedLight();
    if (i >= model.lights().size() || model.lights()[i].isRemoved) {
        return;
    }
    SceneLight light = model.lights()[i];
    GpLightDesc& d = light.desc;
    ImGui::PushID("selected");
    ImGui::ColorEdit3("color", d.color, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
    std::transform(d.color, d.color + 3, d.color, [](float v) { return std::max(v, 0.0f); });
    ImGui::DragFloat(intensityUnit(d.kind), &d.intensity, std::max(0.01f * d.intensity, 1.0e-3f),
                     0.0f, 1.0e12f, "%.4g");
    d.intensity = std::clamp(d.intensity, 0.0f, 1.0e12f);
    drawPlace(d, model.camera().desc(), model.facts().reach);
    drawShape(d);
    if (ImGui::Button("Remove it")) {
        light.isRemoved = true;
    }
    ImGui::PopID();
    model.changeLight(i, [&light](SceneLight& l) { l = light; });
}

}  // namespace

void drawSceneLights(ViewModel& model) {
    ImGui::TextDisabled("lights of the scene: %d", static_cast<int>(model.lights().size()));
    if (!model.lights().empty()) {
        drawList(model);
        drawSelected(model);
    }
    for (const auto& [word, kind] : kLightKindWords) {
        if (kind == GP_LIGHT_POLYGON) {
            continue;
        }
        if (kind != GP_LIGHT_DIRECTIONAL) {
            ImGui::SameLine();
        }
        if (ImGui::SmallButton(fmt::format("+ {}", word).c_str())) {
            model.addLight(kind);
            model.selectedLight() = model.lights().size() - 1;
        }
    }
}

}  // namespace gp::tool::view
