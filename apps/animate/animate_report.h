// What `glitterpath animate` measured.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "animate/animate_settings.h"

namespace gp::tool {

// The time of a pass, in all frames together.
struct PassSum {
    std::string name;
    double milliseconds = 0;
};

struct AnimateReport {
    std::vector<double> milliseconds;  // of each frame: moving the scene, and gpRender
    std::uint64_t rays = 0;            // of all frames
    std::vector<PassSum> passes;       // in their order
    GpFrameStatistics last{};
    double secondsLoad = 0, secondsWrite = 0;
    double exposureEv = 0;
    std::string device;
    bool interrupted = false;
};

// The value below which the share `part` (0..1) of the values lies: the nearest rank.
double percentile(std::vector<double> values, double part);

nlohmann::ordered_json animateJson(const AnimateReport& report, const AnimateSettings& settings);
// One line for people.
std::string animateText(const AnimateReport& report, const AnimateSettings& settings);

}  // namespace gp::tool
