#include "view/fly_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::tool::view {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kHalfPi = 0.5f * kPi;
// From where one stands to what one sees.
constexpr float kSecondsToReach = 3.0f;
constexpr float kFastFactor = 4.0f;
// Four clicks of a wheel double the speed or halve it.
constexpr float kStepsPerDoubling = 4.0f;
constexpr float kSlowest = 1.0e-4f;
constexpr float kFastest = 1.0e5f;

glm::vec3 vec3From(const float* xyz) {
    return {xyz[0], xyz[1], xyz[2]};
}

void store(float* xyz, const glm::vec3& v) {
    for (int i = 0; i < 3; ++i) {
        xyz[i] = v[i];
    }
}

// The library's own rule for a camera without an up vector (GpCameraDesc::up).
glm::vec3 upOf(const GpCameraDesc& camera, const glm::vec3& forward) {
    const glm::vec3 up = vec3From(camera.up);
    if (up != glm::vec3(0.0f)) {
        return up;
    }
    const bool vertical = std::hypot(forward.x, forward.z) < 1.0e-4f;
    return vertical ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
}

float headingOf(const glm::vec3& v) {
    return std::atan2(v.x, -v.z);
}

}  // namespace

FlyCamera::FlyCamera(const GpCameraDesc& start, float reach)
    : m_lens(start), m_position(vec3From(start.position)) {
    glm::vec3 axis = vec3From(start.target) - m_position;
    m_targetDistance = glm::length(axis);
    if (!(m_targetDistance > 0)) {
        axis = {0, 0, -1};
        m_targetDistance = 1;
    }
    const glm::vec3 f = glm::normalize(axis);
    const glm::vec3 up = upOf(start, f);
    m_pitch = std::asin(std::clamp(f.y, -1.0f, 1.0f));
    // Looking straight down, the upper edge of the picture is what lies ahead.
    const bool vertical = std::hypot(f.x, f.z) < 1.0e-4f;
    m_heading = vertical ? headingOf(f.y < 0 ? up : -up) : headingOf(f);
    const glm::vec3 levelUp = glm::cross(right(), forward());
    m_roll = std::atan2(glm::dot(up, right()), glm::dot(up, levelUp));
    m_speed = std::clamp(reach / kSecondsToReach, kSlowest, kFastest);
}

glm::vec3 FlyCamera::forward() const {
    const float level = std::cos(m_pitch);
    return {std::sin(m_heading) * level, std::sin(m_pitch), -std::cos(m_heading) * level};
}

glm::vec3 FlyCamera::right() const {
    return {std::cos(m_heading), 0.0f, std::sin(m_heading)};
}

void FlyCamera::move(const glm::vec3& rightUpForward, float seconds, bool fast) {
    const float distance = m_speed * (fast ? kFastFactor : 1.0f) * seconds;
    m_position += distance * (rightUpForward.x * right() +
                              rightUpForward.y * glm::vec3(0, 1, 0) +
                              rightUpForward.z * forward());
}

void FlyCamera::turn(float pixelsRight, float pixelsDown, float pictureHeight) {
    const float fov = m_lens.verticalFov > 0 ? m_lens.verticalFov : 0.25f * kPi;
    const float perPixel = fov / std::max(pictureHeight, 1.0f);
    m_heading = std::remainder(m_heading + pixelsRight * perPixel, 2.0f * kPi);
    m_pitch = std::clamp(m_pitch - pixelsDown * perPixel, -kHalfPi, kHalfPi);
}

void FlyCamera::changeSpeed(float wheelSteps) {
    m_speed = std::clamp(m_speed * std::exp2(wheelSteps / kStepsPerDoubling), kSlowest, kFastest);
}

GpCameraDesc FlyCamera::desc() const {
    GpCameraDesc desc = m_lens;
    const glm::vec3 f = forward();
    const glm::vec3 levelUp = glm::cross(right(), f);
    store(desc.position, m_position);
    store(desc.target, m_position + m_targetDistance * f);
    store(desc.up, std::cos(m_roll) * levelUp + std::sin(m_roll) * right());
    return desc;
}

bool sameCamera(const GpCameraDesc& a, const GpCameraDesc& b) {
    return a.kind == b.kind && std::equal(a.position, a.position + 3, b.position) &&
           std::equal(a.target, a.target + 3, b.target) && std::equal(a.up, a.up + 3, b.up) &&
           a.verticalFov == b.verticalFov && a.orthographicHeight == b.orthographicHeight &&
           a.apertureRadius == b.apertureRadius && a.focusDistance == b.focusDistance;
}

}  // namespace gp::tool::view
