#include "scene/light_cluster.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// The smallest cone, with its axis in the plane of both, that holds a and b.
// [Conty Estevez and Kulla 2018, algorithm 1]
LightCone unite(const LightCone& first, const LightCone& second) {
    if (first.theta < 0) return second;
    if (second.theta < 0) return first;
    const bool ordered = first.theta >= second.theta;
    const LightCone &a = ordered ? first : second, &b = ordered ? second : first;
    if (a.theta >= pi) return a;  // all around, as spheres shine
    const float between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0f, 1.0f));
    if (std::min(between + b.theta, pi) <= a.theta) return a;
    const float theta = 0.5f * (a.theta + between + b.theta);
    if (theta >= pi) return {a.axis, pi, -1};
    const glm::vec3 pivot = glm::cross(a.axis, b.axis);
    const float length = glm::length(pivot);
    if (!(length > 1e-6f)) return {a.axis, pi, -1};  // opposite axes: no plane to turn in
    const glm::vec3 k = pivot / length;
    const float turn = theta - a.theta;
    // Rodrigues' rotation; k is perpendicular to the axis.
    return {glm::normalize(a.axis * std::cos(turn) + glm::cross(k, a.axis) * std::sin(turn)),
            theta, std::cos(theta)};
}

}  // namespace

void LightCluster::add(const LightCluster& c) {
    lo = glm::min(lo, c.lo), hi = glm::max(hi, c.hi);
    normals = unite(normals, c.normals);
    thetaE = std::max(thetaE, c.thetaE), cosThetaE = std::min(cosThetaE, c.cosThetaE);
    phi += c.phi, twoSided |= c.twoSided, count += c.count;
}

// [Conty Estevez and Kulla 2018, equation 1]
float LightCluster::cost(float regularisation) const {
    const float o = normals.theta;
    const float w = std::min(o + thetaE, pi);
    const float orientation = o >= pi
        ? 4 * pi
        : 2 * pi * (1 - normals.cosTheta) +
              0.5f * pi * (2 * w * std::sin(o) - std::cos(o - 2 * w) - 2 * o * std::sin(o) +
                           normals.cosTheta);
    // A row of points has no area, but the nearer parts of it still belong together.
    const glm::vec3 box = hi - lo, d = box + 0.01f * std::max({box.x, box.y, box.z});
    const float area = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
    return phi * orientation * regularisation * area;
}

}  // namespace gp
