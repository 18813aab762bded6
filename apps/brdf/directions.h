// Pairs of directions by the angles that people use. Radians; normal +Z, tangent +X.
#pragma once

#include <glm/glm.hpp>

#include <vector>

#include "half_angles.h"

namespace gp::tool {

glm::dvec3 spherical(double theta, double phi);

// `count` and more places from `low` to `high`, both included: evenly spread, and again ever closer
// to each of `centers`, where lobes may be as narrow as 1e-4 rad. Ascending.
std::vector<double> placesBetween(double low, double high, std::size_t count,
                                  const std::vector<double>& centers);

}  // namespace gp::tool
