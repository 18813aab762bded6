// What lies over the picture: the scale of a heat map, the names at the divider.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

constexpr float kMargin = 12;
constexpr float kBarWidth = 180;
constexpr float kBarHeight = 12;
constexpr int kBarSteps = 60;

ImU32 packed(const glm::vec3& srgb) {
    return ImGui::ColorConvertFloat4ToU32(ImVec4(srgb.x, srgb.y, srgb.z, 1.0f));
}

// Readable over whatever is behind it.
void drawText(ImDrawList& list, float x, float y, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled(ImVec2(x - 3, y - 1), ImVec2(x + size.x + 3, y + size.y + 1),
                       IM_COL32(0, 0, 0, 170), 2.0f);
    list.AddText(ImVec2(x, y), IM_COL32(255, 255, 255, 255), text.c_str());
}

void drawScale(ImDrawList& list, const HeatScale& heat, const std::string& image,
               const PictureArea& area) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float x = area.x + kMargin;
    const float y = area.y + area.height - kMargin - kBarHeight - line;
    drawText(list, x, y - line, image);
    for (int i = 0; i < kBarSteps; ++i) {
        const float from = static_cast<float>(i) / kBarSteps;
        const float to = static_cast<float>(i + 1) / kBarSteps;
        list.AddRectFilled(ImVec2(x + from * kBarWidth, y), ImVec2(x + to * kBarWidth,
                           y + kBarHeight), packed(heatColor(0.5f * (from + to))));
    }
    drawText(list, x, y + kBarHeight + 3, "0");
    const std::string most = fmt::format("{:.3g} {} and more", heat.high, heat.unit);
    const float width = ImGui::CalcTextSize(most.c_str()).x;
    drawText(list, x + std::max(kBarWidth - width, 20.0f), y + kBarHeight + 3, most);
}

void drawDivider(ImDrawList& list, const ViewModel& model, const PictureArea& area) {
    const ShownPicture& picture = *model.picture();
    const float line = area.x + model.choices().divider * area.width;
    const std::string left = model.choices().live == LiveMode::realtime ? "real time" : "live";
    const std::string right = fmt::format("reference, {} samples", picture.samplesBeside);
    const float width = ImGui::CalcTextSize(left.c_str()).x;
    drawText(list, line - width - kMargin, area.y + kMargin, left);
    drawText(list, line + kMargin, area.y + kMargin, right);
    // A handle for the hand.
    const float y = area.y + 0.5f * area.height;
    list.AddRectFilled(ImVec2(line - 3, y - 18), ImVec2(line + 3, y + 18),
                       IM_COL32(255, 255, 255, 220), 3.0f);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (std::abs(mouse.x - line) <= ViewModel::kDividerReach && mouse.y >= area.y) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
}

}  // namespace

void drawOverPicture(const ViewModel& model, const PictureArea& area) {
    if (!model.picture()) {
        return;
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    if (model.picture()->heat) {
        drawScale(list, *model.picture()->heat, model.choices().image, area);
    }
    if (model.choices().beside && model.picture()->samplesBeside > 0) {
        drawDivider(list, model, area);
    }
}

}  // namespace gp::tool::view
