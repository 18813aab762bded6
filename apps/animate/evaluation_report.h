// An evaluation as JSON, and as a page with tables, plots and pictures.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

#include "animate/evaluation.h"

namespace gp::tool {

nlohmann::ordered_json evaluationJson(const Evaluation& evaluation,
                                      const EvaluateSettings& settings);

// One file of HTML with everything inside. Needs gnuplot; throws RunError.
std::string evaluationHtml(GpDevice device, const Evaluation& evaluation,
                           const EvaluateSettings& settings);

// The table for people at a terminal.
std::string evaluationText(const Evaluation& evaluation, const EvaluateSettings& settings);

}  // namespace gp::tool
