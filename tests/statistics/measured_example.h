// A measured material that nobody measured: matte with a highlight, which changes with all three
// angles, so that a pair of axes exchanged or one turned round shows.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "merl_format.h"
#include "scene/measured_brdf.h"

namespace gp::test {

// f at the centre of a cell; negative below the horizon.
inline glm::dvec3 measuredExampleAt(std::size_t cell) {
    const DirectionPair pair = merl::directionsOf(cell, 0.0);
    if (!pair.aboveHorizon()) return glm::dvec3(-1.0);
    const glm::dvec3 h = glm::normalize(pair.wi + pair.wo);
    const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    const double cosD = glm::dot(h, pair.wi);
    const double phiD = M_PI * (static_cast<double>(merl::placeOf(cell)[2]) + 0.5) / 180.0;
    constexpr double width = 0.1;
    const double lobe = std::exp(-tan2 / (width * width)) / std::pow(h.z, 4.0);
    const double fresnel = 0.1 + 0.9 * std::pow(1.0 - cosD, 5.0);
    const double streak = 1.0 + 0.3 * std::cos(2.0 * phiD) + 0.1 * std::sin(2.0 * phiD);
    const glm::dvec3 matte(0.10, 0.06, 0.03);
    return matte + glm::dvec3(6.0, 5.0, 4.0) * (lobe * fresnel * streak)
                 / std::max(4.0 * pair.wi.z * pair.wo.z, 0.2);
}

inline std::shared_ptr<const MeasuredBrdf> makeMeasuredExample() {
    LargeVector<float> cells(3 * merl::cellCount);
    for (std::size_t cell = 0; cell < merl::cellCount; ++cell) {
        const glm::dvec3 f = measuredExampleAt(cell);
        for (int c = 0; c < 3; ++c) cells[3 * cell + std::size_t(c)] = float(f[c]);
    }
    return makeMeasuredBrdf("example", std::move(cells));
}

// The same one for all tests of a program.
inline std::shared_ptr<const MeasuredBrdf> measuredExample() {
    static const std::shared_ptr<const MeasuredBrdf> example = makeMeasuredExample();
    return example;
}

}  // namespace gp::test
