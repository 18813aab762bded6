#include "view/resolution_controller.h"

#include <algorithm>
#include <cmath>

namespace gp::tool::view {
namespace {

// Wider than what frames of the same size differ by, so that the size does not swing.
constexpr double kTooSlow = 1.15;
constexpr double kQuickEnough = 0.9;
constexpr double kLeastRenderScale = 0.5;  // of the library

}  // namespace

double ResolutionController::scaleOf(int step) const {
    return std::min(std::exp2(-0.25 * step), m_mostRenderScale.value_or(1.0));
}

double ResolutionController::renderScale() const {
    return m_mostRenderScale ? std::max(scale(), kLeastRenderScale) : 1.0;
}

double ResolutionController::sizeScale() const {
    return m_mostRenderScale ? std::min(scale() / kLeastRenderScale, 1.0) : scale();
}

void ResolutionController::record(double seconds) {
    std::rotate(m_costs.begin(), m_costs.end() - 1, m_costs.end());
    m_costs[0] = seconds / (scale() * scale());
    m_known = std::min(m_known + 1, kHistory);
    if (m_known >= 2) {
        const double cost = std::min(m_costs[0], m_costs[1]);
        if (predicted(m_step, cost) > kTooSlow * m_target && m_step < kSteps) {
            while (m_step < kSteps && predicted(m_step, cost) > m_target) {
                ++m_step;
            }
            m_known = 0;  // times of other sizes say less than those to come
            return;
        }
    }
    if (m_known == kHistory && m_step > 0) {
        const double cost = *std::max_element(m_costs.begin(), m_costs.end());
        if (predicted(m_step - 1, cost) < kQuickEnough * m_target) {
            --m_step;
            m_known = 0;
        }
    }
}

RenderSize ResolutionController::sizeFor(RenderSize full) const {
    const auto scaled = [this](std::uint32_t side) {
        const double pixels = std::round(static_cast<double>(side) * sizeScale());
        return std::max(static_cast<std::uint32_t>(pixels), std::min(side, 16u));
    };
    return {scaled(full.width), scaled(full.height)};
}

}  // namespace gp::tool::view
