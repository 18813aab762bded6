#include "view/exposure_meter.h"

#include <algorithm>
#include <cmath>

#include "exposure.h"

namespace gp::tool::view {
namespace {

// After this time two thirds of a change are made up for.
constexpr double kAdaptationSeconds = 0.4;
// The rule sorts what it looks at; so many pixels tell as much as all.
constexpr std::size_t kMostPixels = 16384;

}  // namespace

float ExposureMeter::adapt(const std::vector<float>& rgba, double seconds) {
    const std::size_t count = rgba.size() / 4;
    // An odd stride: an even one could see the same columns of every row.
    const std::size_t stride = std::max<std::size_t>(1, count / kMostPixels) | 1u;
    std::vector<float> some;
    for (std::size_t i = 0; i < count; i += stride) {
        some.insert(some.end(), rgba.begin() + static_cast<std::ptrdiff_t>(4 * i),
                    rgba.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
    }
    const auto wanted = static_cast<float>(automaticExposureEv(some.data(), some.size() / 4));
    const double share = m_hasSeen ? 1.0 - std::exp(-seconds / kAdaptationSeconds) : 1.0;
    m_ev += static_cast<float>(share) * (wanted - m_ev);
    m_hasSeen = true;
    return m_ev;
}

}  // namespace gp::tool::view
