// What only real-time frames have: denoiser, light reuse, anti-aliasing, and all of their numbers.
#include <fmt/format.h>

#include <algorithm>

#include "view/view_words.h"
#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

// From here on a slider of equal steps would leave no room for small values.
constexpr float kManyPowers = 500;

void drawNumber(const DenoiserNumber& number, RealtimeChoices& choices) {
    const auto changed = choices.numbers.find(number.name);
    float value = changed == choices.numbers.end() ? number.initial : changed->second;
    ImGui::PushID(number.name.c_str());
    ImGui::TextUnformatted(number.name.c_str());
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s\n%g..%g, by default %g", number.meaning.c_str(),
                          static_cast<double>(number.low), static_cast<double>(number.high),
                          static_cast<double>(number.initial));
    }
    if (changed != choices.numbers.end()) {
        ImGui::SameLine();
        if (ImGui::SmallButton("default")) {
            value = number.initial;
        }
    }
    const bool hasPowers = number.low >= 0 && number.high >= kManyPowers;
    ImGui::SetNextItemWidth(-1);
    ImGui::SliderFloat("##value", &value, number.low, number.high, "%.3g",
                       hasPowers ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    value = std::clamp(value, number.low, number.high);
    if (value == number.initial) {
        choices.numbers.erase(number.name);
    } else {
        choices.numbers[number.name] = value;
    }
    ImGui::PopID();
}

// What the present choice looks at; all others have no effect.
bool counts(const DenoiserFacts& facts, const DenoiserNumber& number,
            const RealtimeChoices& choices) {
    const bool upscales = choices.antiAliasing == GP_AA_TEMPORAL || choices.renderScale < 1;
    return facts.isUsedBy(number, facts.nameOf(choices.denoiser)) ||
           (choices.lightReuse != GP_REUSE_NONE && facts.isUsedBy(number, "light reuse")) ||
           (choices.indirectReuse != GP_REUSE_NONE && facts.isUsedBy(number, "indirect reuse")) ||
           (upscales && facts.isUsedBy(number, "anti-aliasing"));
}

void drawNumbers(const DenoiserFacts& facts, RealtimeChoices& choices) {
    if (!ImGui::TreeNode("numbers")) {
        return;
    }
    if (!choices.numbers.empty() &&
        ImGui::Button(fmt::format("All {} back to default", choices.numbers.size()).c_str())) {
        choices.numbers.clear();
    }
    for (const DenoiserNumber& number : facts.numbers) {
        if (counts(facts, number, choices)) {
            drawNumber(number, choices);
        }
    }
    if (ImGui::TreeNode("of other denoisers")) {
        for (const DenoiserNumber& number : facts.numbers) {
            if (!counts(facts, number, choices)) {
                drawNumber(number, choices);
            }
        }
        ImGui::TreePop();
    }
    ImGui::TreePop();
}

void drawDenoiser(const DenoiserFacts& facts, GpDenoiser& denoiser) {
    if (!ImGui::BeginCombo("denoiser", facts.nameOf(denoiser).c_str())) {
        return;
    }
    for (std::size_t i = 0; i < facts.names.size(); ++i) {
        const auto known = static_cast<GpDenoiser>(i);
        if (ImGui::Selectable(facts.names[i].c_str(), known == denoiser)) {
            denoiser = known;
        }
    }
    ImGui::EndCombo();
}

void drawEye(EyeChoices& eye) {
    bool isOn = eye.seconds > 0;
    if (ImGui::Checkbox("eye adaptation", &isOn)) {
        eye.seconds = isOn ? 0.5f : 0.0f;
    }
    if (!isOn) {
        return;
    }
    ImGui::SliderFloat("seconds", &eye.seconds, 0.01f, 10.0f, "%.2f",
                       ImGuiSliderFlags_Logarithmic);
    eye.seconds = std::clamp(eye.seconds, 0.01f, static_cast<float>(kLongestAdaptation));
    ImGui::DragFloatRange2("EV", &eye.evMin, &eye.evMax, 0.05f, -20.0f, 20.0f, "%.1f");
    eye.evMin = std::clamp(eye.evMin, -20.0f, 20.0f);
    eye.evMax = std::clamp(eye.evMax, eye.evMin, 20.0f);
    if (eye.evMin == 0 && eye.evMax == 0) {
        eye.evMax = 0.05f;  // both 0 would be the library's default
    }
}

}  // namespace

void drawRealtimePanel(ViewModel& model) {
    RealtimeChoices& choices = model.choices().realtime;
    if (model.choices().live != LiveMode::realtime || !ImGui::CollapsingHeader("Real time")) {
        return;
    }
    const DenoiserFacts& facts = model.facts().denoisers;
    drawDenoiser(facts, choices.denoiser);
    chooseWord("light reuse", choices.lightReuse, kLightReuseWords);
    chooseWord("indirect reuse", choices.indirectReuse, kLightReuseWords);
    chooseWord("anti-aliasing", choices.antiAliasing, kAntiAliasingWords);
    ImGui::SliderFloat("render scale", &choices.renderScale, 0.5f, 1.0f, "at most %.2f");
    choices.renderScale = std::clamp(choices.renderScale, 0.5f, 1.0f);
    ImGui::SliderInt("bounces", &choices.bounces, 0, kMostBounces);
    choices.bounces = std::clamp(choices.bounces, 0, kMostBounces);
    ImGui::SliderInt("mirrors", &choices.mirrors, 0, kMostBounces);
    choices.mirrors = std::clamp(choices.mirrors, 0, kMostBounces);
    drawEye(choices.eye);
    drawNumbers(facts, choices);
    if (ImGui::Button("Forget history")) {
        ++choices.cuts;
    }
}

}  // namespace gp::tool::view
