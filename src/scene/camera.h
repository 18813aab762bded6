#pragma once

#include <string>

#include <glm/glm.hpp>

namespace gp {

enum class CameraKind : uint8_t { perspective, orthographic };

struct Camera {
    std::string name;
    CameraKind kind = CameraKind::perspective;
    glm::vec3 position{0};
    glm::vec3 target{0, 0, -1};
    glm::vec3 up{0, 1, 0};
    float verticalFov = 0.7853982f;   // radians
    float orthographicHeight = 2;     // metres, whole height of the picture
    float apertureRadius = 0;         // metres; 0 = pinhole
    float focusDistance = 0;          // metres along the view axis; 0 = the target
};

}  // namespace gp
