// Where the camera is, its lens, and the file's cameras.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

constexpr float kDegrees = 180.0f / std::numbers::pi_v<float>;

void drawLens(FlyCamera& camera) {
    GpCameraDesc& lens = camera.lens();
    if (lens.kind == GP_CAMERA_ORTHOGRAPHIC) {
        float height = lens.orthographicHeight > 0 ? lens.orthographicHeight : 2.0f;
        if (ImGui::DragFloat("height, m", &height, 0.01f * height, 1.0e-4f, 1.0e6f)) {
            lens.orthographicHeight = std::max(height, 1.0e-4f);
        }
        return;
    }
    float fov = (lens.verticalFov > 0 ? lens.verticalFov : 0.25f * std::numbers::pi_v<float>) *
                kDegrees;
    if (ImGui::SliderFloat("angle of view", &fov, 5.0f, 120.0f, "%.1f deg")) {
        lens.verticalFov = std::clamp(fov, 0.01f, 179.0f) / kDegrees;
    }
    float diameter = 2000.0f * lens.apertureRadius;
    if (ImGui::DragFloat("aperture", &diameter, 0.1f, 0.0f, 1000.0f, "%.1f mm")) {
        lens.apertureRadius = std::max(diameter, 0.0f) / 2000.0f;
    }
    if (lens.apertureRadius > 0) {
        ImGui::DragFloat("focus, m", &lens.focusDistance, 0.02f, 0.0f, 1.0e6f);
        lens.focusDistance = std::max(lens.focusDistance, 0.0f);
    }
}

}  // namespace

void drawCameraPanel(ViewModel& model) {
    if (!ImGui::CollapsingHeader("Camera")) {
        return;
    }
    FlyCamera& camera = model.camera();
    ImGui::DragFloat3("position, m", &camera.position().x, 0.02f * camera.speed());
    float heading = camera.heading() * kDegrees;
    float pitch = camera.pitch() * kDegrees;
    if (ImGui::SliderFloat("heading", &heading, -180.0f, 180.0f, "%.1f deg")) {
        camera.heading() = heading / kDegrees;
    }
    if (ImGui::SliderFloat("pitch", &pitch, -90.0f, 90.0f, "%.1f deg")) {
        camera.pitch() = std::clamp(pitch, -90.0f, 90.0f) / kDegrees;
    }
    drawLens(camera);
    valueRow("speed", fmt::format("{:.3g} m/s (wheel)", camera.speed()));
    if (ImGui::Button("Whole scene (F)")) {
        model.goTo(model.facts().wholeScene);
    }
    ImGui::SameLine();
    if (ImGui::Button("First view (R)")) {
        model.goTo(model.facts().start);
    }
    const std::vector<std::string> names = model.facts().index.cameras();
    for (std::size_t i = 0; i < std::min(names.size(), model.facts().cameras.size()); ++i) {
        const std::string label =
            fmt::format("{}  {}##camera{}", i, names[i].empty() ? "(no name)" : names[i], i);
        if (ImGui::Selectable(label.c_str())) {
            model.goToCamera(i);
        }
    }
}

}  // namespace gp::tool::view
