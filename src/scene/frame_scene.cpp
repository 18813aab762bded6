// The camera for people who have not placed one.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/sky.h"

namespace gp {

namespace {

constexpr double margin = 1.06;  // of the picture around the scene
const glm::dvec3 viewedFrom = glm::normalize(glm::dvec3(0.45, 0.35, 1));

std::array<glm::dvec3, 8> cornersOf(const Bounds& bounds) {
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? bounds.hi.x : bounds.lo.x, i & 2 ? bounds.hi.y : bounds.lo.y,
                      i & 4 ? bounds.hi.z : bounds.lo.z};
    return corners;
}

}  // namespace

Camera frameScene(const Scene& scene, float aspect) {
    Camera camera;
    camera.up = scene.worldUp;
    Bounds bounds = worldBounds(scene);
    if (bounds.empty()) bounds = {glm::vec3(-1), glm::vec3(1)};
    const std::array<glm::dvec3, 8> corners = cornersOf(bounds);
    const glm::dvec3 centre = (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi)) * 0.5;

    const glm::dvec3 back = viewedFrom;  // from the centre to the camera
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back));
    const glm::dvec3 up = glm::cross(back, right);
    const double tanY = std::tan(camera.verticalFov / 2.0), tanX = tanY * aspect;
    // The nearest point on the line of sight from which every corner is within the picture.
    double distance = 0;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 v = corner - centre;
        const double sideways = std::max(std::abs(glm::dot(v, right)) / tanX,
                                         std::abs(glm::dot(v, up)) / tanY);
        distance = std::max(distance, sideways * margin + glm::dot(v, back));
    }
    // A single point, or one so far out that floats end beside it, still needs a direction.
    distance = std::max({distance, 1e-3, glm::length(centre) * 1e-5});
    camera.position = glm::vec3(centre + back * distance);
    camera.target = glm::vec3(centre);
    return camera;
}

}  // namespace gp
