// Frame times, sizes, and what is rendered when.
#include <fmt/format.h>

#include <algorithm>

#include "view/view_words.h"
#include "view/window/panel_rows.h"
#include "view/window/panels.h"

namespace gp::tool::view {
namespace {

void drawSizes(const ShownPicture& picture) {
    const GpFrameStatistics& s = picture.statistics;
    valueRow("now", picture.atRest ? "reference, at rest" : "live");
    valueRow("size", fmt::format("{} x {}, {:.0f} % of the view", picture.size.width,
                                 picture.size.height, 100.0 * picture.scale));
    if (picture.renderScale < 1) {
        valueRow("rays", fmt::format("{:.0f} % along each side", 100.0 * picture.renderScale));
    }
    valueRow("samples", fmt::format("{} a pixel", s.samplesPerPixel));
    if (s.noise >= 0 && s.samplesPerPixel > 1) {
        valueRow("noise", fmt::format("{:.2f} %", 100.0 * s.noise));
    }
    const double rays = static_cast<double>(s.cameraRays + s.bounceRays + s.shadowRays);
    if (s.secondsRender > 0) {
        valueRow("speed", fmt::format("{:.2f} Mrays/s", 1.0e-6 * rays / s.secondsRender));
    }
    valueRow("frame memory", fmt::format("{:.1f} MB", 1.0e-6 * static_cast<double>(s.frameBytes)));
}

void drawTimes(const TimeHistory& times, double target) {
    const std::vector<float>& all = times.milliseconds();
    if (all.empty()) {
        return;
    }
    // What was wanted is a third of the height; a frame that took a second shall not hide others.
    const auto top = static_cast<float>(3000.0 * target);
    valueRow("frame time", fmt::format("{:.1f} ms, 95 % below {:.1f} ms", times.percentile(50),
                                       times.percentile(95)));
    ImGui::PlotHistogram("##times", all.data(), static_cast<int>(all.size()), 0, nullptr, 0.0f,
                         top, ImVec2(ImGui::GetContentRegionAvail().x, 40));
}

void drawPasses(const ShownPicture& picture) {
    if (picture.passes.empty() || !ImGui::TreeNode("passes")) {
        return;
    }
    for (const auto& [name, milliseconds] : picture.passes) {
        valueRow(name, fmt::format("{:.2f} ms", milliseconds));
    }
    ImGui::TreePop();
}

}  // namespace

void drawFramePanel(ViewModel& model) {
    if (!ImGui::CollapsingHeader("Frame", ImGuiTreeNodeFlags_DefaultOpen)) {
        return;
    }
    ViewChoices& choices = model.choices();
    textLine(model.facts().deviceName);
    if (model.picture()) {
        drawSizes(*model.picture());
    }
    drawTimes(model.times(), choices.liveSeconds);
    if (model.picture()) {
        drawPasses(*model.picture());
    }
    LiveMode live = choices.live;
    if (chooseWord("live picture", live, kLiveWords)) {
        model.setLive(live);
    }
    auto fps = static_cast<float>(1.0 / choices.liveSeconds);
    if (ImGui::SliderFloat("frames a second", &fps, static_cast<float>(kLowestFps), 60.0f,
                           "%.0f")) {
        choices.liveSeconds = 1.0 / std::clamp(static_cast<double>(fps), kLowestFps, kHighestFps);
    }
    ImGui::Checkbox("progressive reference at rest (P)", &choices.reference);
    if (choices.reference) {
        auto samples = static_cast<int>(choices.mostSamples);
        if (ImGui::InputInt("most samples", &samples, 64, 1024)) {
            choices.mostSamples = static_cast<std::uint32_t>(
                std::clamp(samples, 1, static_cast<int>(kMostSamples)));
        }
    }
    if (!model.message().empty()) {
        const ImVec4 color = model.messageIsError() ? ImVec4(1.0f, 0.45f, 0.4f, 1.0f)
                                                    : ImVec4(0.6f, 0.9f, 0.6f, 1.0f);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        textLine(model.message());
        ImGui::PopStyleColor();
    }
}

}  // namespace gp::tool::view
