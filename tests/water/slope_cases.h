// The distributions and views that tests of masking run over.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "water/slope_quadrature.h"

namespace gp::test {
namespace {  // the shading functions' types have internal linkage

struct SlopeCase {
    gp::shading::Slopes slopes;
    glm::vec3 wo;
    std::string name;
};

// Every mean slope with every roughness and correlation, views up to 85 degrees; those that see
// the mesosurface from behind are left out.
[[maybe_unused]] std::vector<SlopeCase> slopeCases(bool few = false) {
    const glm::vec2 means[] = {{0, 0}, {0.1f, 0}, {0.3f, 0}, {0.2f, -0.3f}, {0.5f, 0}, {-1, 0.5f}};
    const glm::vec3 widths[] = {{0.05f, 0.05f, 0}, {0.3f, 0.3f, 0},
                                {0.3f, 0.15f, 0.5f}, {0.1f, 0.5f, -0.9f}, {0.7f, 0.7f, 0.3f}};
    const glm::vec2 views[] = {{0, 0}, {45, 0}, {45, 180}, {60, 110}, {70, 0},
                               {70, 180}, {85, 0}, {85, 180}, {85, 70}};
    std::vector<SlopeCase> cases;
    std::size_t index = 0;
    for (const glm::vec2 mean : means) {
        for (const glm::vec3 w : widths) {
            for (const glm::vec2 view : views) {
                const glm::vec3 wo = directionAt(double(view.x), double(view.y));
                const gp::shading::Slopes d = slopesOf(mean.x, mean.y, w.x, w.y, w.z);
                if (gp::shading::slope_facing(mean, wo) <= 1e-3f) continue;
                if (few && index++ % 7 != 0) continue;
                cases.push_back({d, wo,
                                 fmt::format("mean ({}, {}) sigma {} {} rho {} view {}/{}", mean.x,
                                             mean.y, w.x, w.y, w.z, view.x, view.y)});
            }
        }
    }
    return cases;
}

}  // namespace
}  // namespace gp::test
