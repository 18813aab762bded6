// The sea: its time, its waves, its water. Whatever needs a new sea waits until it is let go.
#include <fmt/format.h>

#include <algorithm>

#include "sea/sea_words.h"
#include "view/view_words.h"
#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

// From here on a slider of equal steps would leave no room for small values.
constexpr double kManyPowers = 500;

void drawTime(ViewModel& model) {
    const SeaChoices& sea = model.choices().sea;
    double seconds = sea.seconds;
    if (ImGui::DragScalar("time, s", ImGuiDataType_Double, &seconds, 0.05f, nullptr, nullptr,
                          "%.2f")) {
        model.setSeaTime(std::clamp(seconds, -kLongestSeaTime, kLongestSeaTime));
    }
    auto speed = static_cast<float>(sea.speed);
    if (ImGui::SliderFloat("speed", &speed, 0.0f, 4.0f, "%.2f times")) {
        model.setSeaSpeed(std::clamp(static_cast<double>(speed), 0.0, kFastestSea));
    }
    if (ImGui::Button(sea.isPaused ? "Go on (Space)" : "Pause (Space)")) {
        model.pauseSea(!sea.isPaused);
    }
    ImGui::SameLine();
    if (ImGui::Button("Step (.)")) {
        model.stepSea();
    }
    if (!sea.isPaused && !model.seaMoves()) {
        ImGui::SameLine();
        ImGui::TextDisabled(sea.speed > 0 ? "stands: reference" : "stands: speed 0");
    }
}

void drawNumber(ViewModel& model, const char* name) {
    const SeaNumber& number = *seaWordNamed(name)->number;
    GpOceanDesc& draft = model.seaDraft();
    auto value = static_cast<float>(number.of(draft));
    const bool hasPowers = number.low > 0 && number.high >= kManyPowers * number.low;
    const std::string format = fmt::format("%.3g {}", number.unit);
    if (ImGui::SliderFloat(name, &value, static_cast<float>(number.low),
                           static_cast<float>(number.high), format.c_str(),
                           hasPowers ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None)) {
        number.put(draft, std::clamp(static_cast<double>(value), number.low, number.high));
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        model.finishSeaDraft();
    }
}

void drawDepth(ViewModel& model) {
    constexpr float firstDepth = 20;
    GpOceanDesc& draft = model.seaDraft();
    bool isDeep = draft.depth == 0;
    if (ImGui::Checkbox("deep", &isDeep)) {
        draft.depth = isDeep ? 0 : firstDepth;
        model.finishSeaDraft();
    }
    if (draft.depth != 0) {
        drawNumber(model, "depth");
    }
}

void drawTriple(ViewModel& model, const char* name) {
    constexpr float firstSteps = 0.0005f;  // 1/m a pixel of the mouse
    const SeaTriple& triple = *seaWordNamed(name)->triple;
    std::array<float, 3> values = triple.of(model.seaDraft());
    const auto high = static_cast<float>(triple.high);
    if (ImGui::DragFloat3(name, values.data(), firstSteps, 0.0f, high, "%.4f /m",
                          ImGuiSliderFlags_AlwaysClamp)) {
        triple.put(model.seaDraft(), values);
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        model.finishSeaDraft();
    }
}

template <class Value, std::size_t count>
void drawChoice(ViewModel& model, const char* name, Value GpOceanDesc::*field,
                const std::pair<const char*, Value> (&words)[count]) {
    if (chooseWord(name, model.seaDraft().*field, words)) {
        model.finishSeaDraft();
    }
}

void drawWaves(ViewModel& model) {
    for (const char* name : {"wind", "wind-direction", "fetch"}) {
        drawNumber(model, name);
    }
    drawDepth(model);
    drawChoice(model, "spectrum", &GpOceanDesc::spectrum, kSpectrumWords);
    for (const char* name : {"swell", "choppiness", "foam"}) {
        drawNumber(model, name);
    }
}

void drawWater(ViewModel& model) {
    drawChoice(model, "glints", &GpOceanDesc::glints, kSeaGlintWords);
    if (model.seaDraft().glints != GP_GLINTS_OFF) {
        drawNumber(model, "glint-density");
    }
    drawChoice(model, "masking", &GpOceanDesc::masking, kSeaMaskingWords);
    drawTriple(model, "water-absorption");
    drawTriple(model, "water-scattering");
    drawNumber(model, "water-ior");
    bool isTransparent = model.seaDraft().transparent != 0;
    if (ImGui::Checkbox("transparent", &isTransparent)) {
        model.seaDraft().transparent = isTransparent ? 1 : 0;
        model.finishSeaDraft();
    }
    float level = model.seaDraft().level;
    if (ImGui::DragFloat("level, m", &level, 0.01f)) {
        const SeaNumber& number = *seaWordNamed("sea-level")->number;
        number.put(model.seaDraft(),
                   std::clamp(static_cast<double>(level), number.low, number.high));
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        model.finishSeaDraft();
    }
}

}  // namespace

void drawSeaPanel(ViewModel& model) {
    bool isThere = model.choices().sea.isThere;
    const ImGuiTreeNodeFlags opens =
        isThere ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
    if (!ImGui::CollapsingHeader("Sea", opens)) {
        return;
    }
    if (ImGui::Checkbox("sea", &isThere)) {
        model.setSeaThere(isThere);
    }
    if (!isThere) {
        return;
    }
    ImGui::PushID("sea");
    drawTime(model);
    drawWaves(model);
    drawWater(model);
    ImGui::PopID();
}

}  // namespace gp::tool::view
