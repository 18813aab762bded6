// The camera of a scene as the shading language has it. Internal linkage: the hot code of each
// instruction set compiles its own.
#pragma once

#include <cmath>
#include <cstdint>

#include "scene/camera.h"
#include "shading/shading.h"

namespace gp {
namespace {

[[maybe_unused]] inline shading::CameraParams cameraParams(const Camera& c, uint32_t width,
                                                           uint32_t height) {
    const bool perspective = c.kind == CameraKind::perspective;
    const float halfY = perspective ? std::tan(0.5f * c.verticalFov) : 0.5f * c.orthographicHeight;
    shading::CameraParams p = shading::camera_look_at(
        perspective ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC, c.position, c.target, c.up, halfY,
        float(width) / float(height));
    p.lens_radius = c.apertureRadius;
    p.focus_distance = c.focusDistance > 0 ? c.focusDistance : glm::length(c.target - c.position);
    return p;
}

}  // namespace
}  // namespace gp
