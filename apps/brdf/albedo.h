// Albedos by sampling, with their errors.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>

#include "reflectance.h"

namespace gp::tool {

struct Albedo {
    glm::dvec3 mean{0}, error{0};  // one standard deviation of the mean
};

// The share of the light that arrives from `direction` and leaves again, reflected or transmitted.
Albedo directionalAlbedo(GpDevice device, const Bsdf& bsdf, const glm::dvec3& direction,
                         std::size_t samples);

// The share of light that arrives evenly from above.
Albedo averageAlbedo(GpDevice device, const Bsdf& bsdf, std::size_t samples);

}  // namespace gp::tool
