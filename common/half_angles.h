// Two directions by their half vector and by how far the light is from it, in which measurements
// and plots are made. In double, for tables; shading/measured/half_angles.glsl is the way back.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace gp {

struct DirectionPair {
    glm::dvec3 wi{0}, wo{0};  // to the light, to the viewer; normal +Z, tangent +X
    bool aboveHorizon() const { return wi.z > 0.0 && wo.z > 0.0; }
};

// Radians. With phiD = 0 the light is turned from the half vector towards the horizon.
// [Rusinkiewicz 1998, EGWR, "A New Change of Variables for Efficient BRDF Representation", 3]
inline DirectionPair fromHalfAndDifference(double thetaH, double phiH, double thetaD,
                                           double phiD) {
    const double sineH = std::sin(thetaH), cosineH = std::cos(thetaH);
    const glm::dvec2 azimuth(std::cos(phiH), std::sin(phiH));
    const glm::dvec3 half(sineH * azimuth, cosineH);
    const glm::dvec3 down(cosineH * azimuth, -sineH);
    const glm::dvec3 across(-azimuth.y, azimuth.x, 0.0);
    const glm::dvec3 side = (down * std::cos(phiD) + across * std::sin(phiD)) * std::sin(thetaD);
    return {half * std::cos(thetaD) + side, half * std::cos(thetaD) - side};
}

}  // namespace gp
