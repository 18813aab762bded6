// A closed box of Lambertian walls with a block in it, lit by a lamp that shines at the ceiling:
// all but light of surfaces is shadow.
#pragma once

#include "render/stage.h"

namespace gp::test {

// `block`: the material of the block in the middle; NULL: grey. Returns the lamp.
inline GpLight buildBox(Stage& stage, GpMaterial block = nullptr) {
    Triangles grey, red, middle;
    grey.quad({-2, -1, 5.5f}, {4, 0, 0}, {0, 0, -7.5f});
    grey.quad({-2, 2, -2}, {4, 0, 0}, {0, 0, 7.5f});
    grey.quad({-2, -1, -2}, {4, 0, 0}, {0, 3, 0});
    grey.quad({2, -1, 5.5f}, {-4, 0, 0}, {0, 3, 0});
    red.quad({-2, -1, 5.5f}, {0, 0, -7.5f}, {0, 3, 0});
    red.quad({2, -1, -2}, {0, 0, 7.5f}, {0, 3, 0});
    middle.box({-0.2f, -1, -0.8f}, {0.7f, 0.2f, 0.1f});
    const GpMaterial wall = stage.lambert(glm::vec3(0.7f));
    stage.add(grey, wall);
    stage.add(red, stage.lambert({0.8f, 0.3f, 0.2f}));
    stage.add(middle, block ? block : wall);
    GpLightDesc lamp{};
    lamp.kind = GP_LIGHT_SPOT, lamp.intensity = 30, lamp.radius = 0.1f;
    put(lamp.position, {-1, 0.8f, 0.5f});
    put(lamp.direction, {0.2f, 1, -0.1f});
    lamp.innerAngle = 0.6f, lamp.outerAngle = 0.9f;
    return gpNewLight(stage.scene, &lamp);
}

inline GpCameraDesc boxCamera() {
    GpCameraDesc c{};
    put(c.position, {0.4f, 0.6f, 5});
    put(c.target, {0, 0.1f, 0});
    c.verticalFov = 0.6f;
    return c;
}

}  // namespace gp::test
