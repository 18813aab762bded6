#include "view/window/panel_rows.h"

namespace gp::tool::view {
namespace {

constexpr float kValueColumn = 130;

}  // namespace

void textLine(const std::string& text) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void valueRow(const std::string& name, const std::string& value) {
    ImGui::TextDisabled("%s", name.c_str());
    if (ImGui::CalcTextSize(name.c_str()).x < kValueColumn - 12.0f) {
        ImGui::SameLine(kValueColumn);
    } else {
        ImGui::SetCursorPosX(kValueColumn);  // a long name has a line of its own
    }
    textLine(value);
}

void valueRows(const std::vector<Row>& rows) {
    for (const auto& [name, value] : rows) {
        valueRow(name, value);
    }
}

}  // namespace gp::tool::view
