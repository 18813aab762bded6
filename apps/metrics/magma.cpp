#include "metrics/magma.h"

#include <algorithm>
#include <array>

namespace gp::metrics {

// [van der Walt and Smith 2015, the matplotlib colour maps (CC0)] Ten colours of "magma", evenly
// spaced; between them straight lines are within 8/255 of it.
glm::vec3 magmaSrgb(float t) {
    static constexpr std::array<std::array<float, 3>, 10> colors = {{
        {0x00, 0x00, 0x04}, {0x18, 0x0f, 0x3e}, {0x45, 0x10, 0x77}, {0x72, 0x1f, 0x81},
        {0x9f, 0x2f, 0x7f}, {0xcd, 0x40, 0x71}, {0xf1, 0x60, 0x5d}, {0xfd, 0x95, 0x67},
        {0xfe, 0xc9, 0x8d}, {0xfc, 0xfd, 0xbf}}};
    const float position = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(colors.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(position), colors.size() - 2);
    const float fraction = position - static_cast<float>(below);
    const auto& a = colors[below];
    const auto& b = colors[below + 1];
    return glm::mix(glm::vec3(a[0], a[1], a[2]), glm::vec3(b[0], b[1], b[2]), fraction) / 255.0f;
}

}  // namespace gp::metrics
