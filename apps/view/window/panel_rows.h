// Small things that all panels draw.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <string>
#include <utility>

#include "view/scene_index.h"

namespace gp::tool::view {

// Text that is broken into lines where it is too long.
void textLine(const std::string& text);
// A name, and its value in a column of its own.
void valueRow(const std::string& name, const std::string& value);
void valueRows(const std::vector<Row>& rows);

// A box with the words of a list; returns whether another one was chosen.
template <class Value, std::size_t count>
bool chooseWord(const char* label, Value& value,
                const std::pair<const char*, Value> (&words)[count]) {
    bool changed = false;
    const char* present = "";
    for (const auto& [word, known] : words) {
        present = known == value ? word : present;
    }
    if (ImGui::BeginCombo(label, present)) {
        for (const auto& [word, known] : words) {
            if (ImGui::Selectable(word, known == value)) {
                changed = known != value;
                value = known;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

}  // namespace gp::tool::view
