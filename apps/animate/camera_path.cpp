#include "animate/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::tool {
namespace {

// Between keys k and k + 1, at fraction s.
struct Moment {
    std::size_t k = 0;
    double s = 0;
};

Moment momentOf(const std::vector<CameraKey>& keys, double seconds) {
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), seconds,
                         [](double time, const CameraKey& key) { return time < key.time; });
    if (after == keys.begin() || keys.size() == 1) {
        return {};
    }
    const auto k = static_cast<std::size_t>(after - keys.begin()) - 1;
    if (after == keys.end()) {
        return {k - 1, 1.0};
    }
    return {k, (seconds - keys[k].time) / (after->time - keys[k].time)};
}

// The speed at a key: that of the line between its neighbours, at the ends that to the only one.
glm::dvec3 tangentAt(const std::vector<CameraKey>& keys, std::size_t k,
                     glm::dvec3 CameraKey::*value) {
    const CameraKey& before = keys[k == 0 ? 0 : k - 1];
    const CameraKey& after = keys[std::min(k + 1, keys.size() - 1)];
    return (after.*value - before.*value) / (after.time - before.time);
}

glm::dvec3 between(const CameraKeys& path, const Moment& m, glm::dvec3 CameraKey::*value) {
    const CameraKey& a = path.keys[m.k];
    if (path.keys.size() == 1) {
        return a.*value;
    }
    const CameraKey& b = path.keys[m.k + 1];
    const double s = m.s;
    if (path.straight) {
        return glm::mix(a.*value, b.*value, s);
    }
    // A cubic Hermite spline with the tangents of [Catmull, Rom 1974], for uneven times.
    const double s2 = s * s;
    const double s3 = s2 * s;
    const double seconds = b.time - a.time;
    return (2 * s3 - 3 * s2 + 1) * (a.*value) +
           (s3 - 2 * s2 + s) * seconds * tangentAt(path.keys, m.k, value) +
           (3 * s2 - 2 * s3) * (b.*value) +
           (s3 - s2) * seconds * tangentAt(path.keys, m.k + 1, value);
}

void store(const glm::dvec3& from, float* to) {
    for (int axis = 0; axis < 3; ++axis) {
        to[axis] = static_cast<float>(from[axis]);
    }
}

}  // namespace

GpCameraDesc cameraAt(const CameraKeys& path, double seconds) {
    const Moment m = momentOf(path.keys, seconds);
    const CameraKey& a = path.keys[m.k];
    const CameraKey& b = path.keys[std::min(m.k + 1, path.keys.size() - 1)];
    GpCameraDesc camera{};
    const glm::dvec3 position = between(path, m, &CameraKey::position);
    store(position, camera.position);
    if (path.turns) {
        // Along the shorter arc at constant speed [Shoemake 1985].
        const glm::dquat rotation = glm::slerp(a.rotation, b.rotation, m.s);
        store(position + rotation * glm::dvec3(0, 0, -1), camera.target);
        store(rotation * glm::dvec3(0, 1, 0), camera.up);
    } else {
        store(between(path, m, &CameraKey::target), camera.target);
    }
    const double fovDeg = glm::mix(a.fovDeg, b.fovDeg, m.s);
    camera.verticalFov = static_cast<float>(fovDeg * std::numbers::pi / 180);
    return camera;
}

GpCameraDesc orbitAt(const GpCameraDesc& start, const glm::dvec3& centre, double periodSeconds,
                     double seconds) {
    const double angle = 2 * std::numbers::pi * seconds / periodSeconds;
    const double x = start.position[0] - centre.x;
    const double z = start.position[2] - centre.z;
    GpCameraDesc camera = start;
    // About +Y, counter-clockwise seen from above: +Z turns towards +X.
    camera.position[0] = static_cast<float>(centre.x + x * std::cos(angle) + z * std::sin(angle));
    camera.position[2] = static_cast<float>(centre.z - x * std::sin(angle) + z * std::cos(angle));
    store(centre, camera.target);
    std::fill(std::begin(camera.up), std::end(camera.up), 0.0f);
    return camera;
}

}  // namespace gp::tool
