// What lies under the mouse, or was clicked.
#include <fmt/format.h>

#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {

void drawThingPanel(ViewModel& model) {
    if (!ImGui::CollapsingHeader("Material under the cursor", ImGuiTreeNodeFlags_DefaultOpen)) {
        return;
    }
    const std::optional<PickedThing>& thing = model.thing();
    if (!thing) {
        ImGui::TextDisabled("nothing");
        return;
    }
    const auto orNone = [](const std::string& name) { return name.empty() ? "(no name)" : name; };
    valueRow("material", orNone(thing->materialName));
    valueRow("model", thing->model);
    valueRow("instance", fmt::format("{}  {}", thing->instance, orNone(thing->instanceName)));
    valueRow("mesh", orNone(thing->meshName));
    ImGui::Separator();
    valueRows(thing->parameters);
    if (model.isPinned() && ImGui::Button("Let go")) {
        model.unpin();
    }
}

}  // namespace gp::tool::view
