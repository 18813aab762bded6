// Pairs of directions by the angles that people use. Radians; normal +Z, tangent +X.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace gp::tool {

glm::dvec3 spherical(double theta, double phi);

struct DirectionPair {
    glm::dvec3 wi{0}, wo{0};  // to the light, to the viewer
    bool aboveHorizon() const { return wi.z > 0 && wo.z > 0; }
};

// From the half vector and the difference of the light from it.
DirectionPair fromHalfAndDifference(double thetaH, double phiH, double thetaD, double phiD);

// `count` and more places from `low` to `high`, both included: evenly spread, and again ever closer
// to each of `centers`, where lobes may be as narrow as 1e-4 rad. Ascending.
std::vector<double> placesBetween(double low, double high, std::size_t count,
                                  const std::vector<double>& centers);

}  // namespace gp::tool
