// Which image of the frame is seen, how bright, and where it is saved.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "view/image_view.h"
#include "view/view_words.h"
#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {

void drawPicturePanel(ViewModel& model) {
    if (!ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) {
        return;
    }
    ViewChoices& choices = model.choices();
    if (ImGui::BeginCombo("image", choices.image.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const ImageName& image : allImages()) {
            if (ImGui::Selectable(image.info.name, choices.image == image.info.name)) {
                choices.image = image.info.name;
            }
        }
        ImGui::EndCombo();
    }
    const ImageName* image = imageNamed(choices.image);
    if (model.picture() && !model.picture()->note.empty()) {
        textLine(model.picture()->note);
    } else {
        const std::string meaning = image->meaning;
        textLine((meaning.empty() ? "" : meaning + "; shown: ") +
                 explanationOf(scaleOf(image->info)));
    }
    ImGui::Checkbox("reference beside it (B)", &choices.beside);
    if (choices.beside && model.picture() && model.picture()->samplesBeside > 0) {
        ImGui::SliderFloat("divider", &choices.divider, 0.0f, 1.0f, "%.2f");
        choices.divider = std::clamp(choices.divider, 0.0f, 1.0f);
        ImGui::TextDisabled("%u samples, they differ by %.2f %%", model.picture()->samplesBeside,
                            100.0 * model.picture()->rmseBeside);
    }
    if (eyeDecides(choices)) {
        ImGui::TextDisabled("exposure by eye adaptation: %.2f EV",
                            static_cast<double>(model.picture() ? model.picture()->exposureEv
                                                                : 0.0f));
        ImGui::SliderFloat("added", &choices.exposureEv, -16.0f, 16.0f, "%.2f EV");
    } else if (ImGui::Checkbox("exposure by itself", &choices.autoExposure) && model.picture()) {
        choices.exposureEv = model.picture()->exposureEv;  // goes on from what is seen
    }
    if (eyeDecides(choices)) {
        // said above
    } else if (choices.autoExposure) {
        ImGui::SameLine();
        ImGui::TextDisabled("%.2f EV", static_cast<double>(
                                           model.picture() ? model.picture()->exposureEv : 0.0f));
    } else {
        ImGui::SliderFloat("exposure", &choices.exposureEv, -16.0f, 16.0f, "%.2f EV");
    }
    chooseWord("tone map", choices.tonemap, kTonemapWords);
    ImGui::InputText("file", &model.screenshotPath());
    if (ImGui::Button("Save picture (F12)")) {
        model.requestScreenshot();
    }
}

}  // namespace gp::tool::view
