// What a render says about itself.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

#include "render_settings.h"

namespace gp::tool {

struct RenderReport {
    GpFrameStatistics statistics{};
    double secondsLoad = 0;
    std::optional<double> exposureEv;  // none: the file is not display-referred
    std::uint32_t frames = 0;          // of real time
    std::string device;
    Lighting lighting;
    bool interrupted = false;
};

nlohmann::ordered_json reportJson(const RenderReport& report, const RenderSettings& settings);
// One line for people.
std::string reportText(const RenderReport& report, const RenderSettings& settings);

}  // namespace gp::tool
