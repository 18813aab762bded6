#include "view/window/panels.h"

#include <imgui.h>

#include "view/window/panel_rows.h"

namespace gp::tool::view {

void drawKeys() {
    textLine("Drag the picture to look around, click a thing to keep it in its panel, turn the "
             "wheel to fly faster or slower.");
    for (const KeyInfo& info : allKeys()) {
        ImGui::TextUnformatted(info.name);
        ImGui::SameLine(70);
        ImGui::TextUnformatted(info.meaning);
    }
}

void drawPanels(ViewModel& model, float height) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(kPanelWidth, height));
    const ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin("Glitterpath", nullptr, fixed);
    ImGui::PushItemWidth(-110);  // room for the names at the right
    drawFramePanel(model);
    drawPicturePanel(model);
    drawRealtimePanel(model);
    drawSeaPanel(model);
    drawThingPanel(model);
    drawCameraPanel(model);
    drawLightPanel(model);
    if (ImGui::CollapsingHeader("Keys and mouse")) {
        drawKeys();
    }
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace gp::tool::view
