// Irradiance in closed form. Points are relative to the receiver; its normal is unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

namespace gp::test {

constexpr double pi = 3.14159265358979323846;

// The part of a polygon above the plane through the origin.
// [Sutherland and Hodgman 1974, "Reentrant Polygon Clipping", CACM 17(1)]
inline std::vector<glm::dvec3> clipToHorizon(const std::vector<glm::dvec3>& polygon, glm::dvec3 n) {
    std::vector<glm::dvec3> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double ha = glm::dot(a, n), hb = glm::dot(b, n);
        if (ha >= 0) kept.push_back(a);
        if ((ha >= 0) != (hb >= 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    return kept;
}

// The projected solid angle of a polygon, in sr: irradiance for a radiance of 1.
// [Lambert 1760, "Photometria"; Arvo 1995, "Analytic Methods for Simulated
// Light Transport", eq. 3.9]
inline double polygonIrradiance(const std::vector<glm::dvec3>& polygon, glm::dvec3 n) {
    const std::vector<glm::dvec3> p = clipToHorizon(polygon, n);
    double sum = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 a = glm::normalize(p[i]), b = glm::normalize(p[(i + 1) % p.size()]);
        const glm::dvec3 c = glm::cross(a, b);
        const double length = glm::length(c);
        if (length > 0) sum += std::atan2(length, glm::dot(a, b)) * glm::dot(c / length, n) / 2;
    }
    return std::abs(sum);
}

inline std::vector<glm::dvec3> quadPolygon(glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v) {
    return {corner, corner + u, corner + u + v, corner + v};
}

// A sphere of radiance 1 wholly above the horizon: the square of the sine of its angular radius.
inline double sphereIrradiance(glm::dvec3 centre, double radius, glm::dvec3 n) {
    const double d2 = glm::dot(centre, centre);
    return pi * radius * radius / d2 * std::max(glm::dot(centre, n) / std::sqrt(d2), 0.0);
}

}  // namespace gp::test
