#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>

#include "scene_setup.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

std::uint64_t cameraCount(GpDevice device, GpScene scene) {
    GpSceneInfo info{};
    check(device, gpGetSceneInfo(scene, &info));
    return info.cameras;
}

// A name wins over a number, since a camera may be called "2".
GpCameraDesc fileCamera(GpDevice device, GpScene scene, const std::string& wanted) {
    const std::uint64_t count = cameraCount(device, scene);
    std::string names;
    for (std::uint32_t i = 0; i < count; ++i) {
        GpCameraDesc camera{};
        const char* name = nullptr;
        check(device, gpGetSceneCamera(scene, i, &camera, &name));
        if (name != nullptr && wanted == name) {
            return camera;
        }
        names += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, name == nullptr ? "" : name);
    }
    std::uint32_t index = 0;
    const char* end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, index);
    if (error != std::errc() || stop != end || index >= count) {
        throw UsageError(fmt::format("--camera: there is no '{}' in the file ({})", wanted,
                                     count == 0 ? "it has no camera" : "it has: " + names));
    }
    GpCameraDesc camera{};
    check(device, gpGetSceneCamera(scene, index, &camera, nullptr));
    return camera;
}

GpCameraDesc baseCamera(GpDevice device, GpScene scene, const RenderSettings& s,
                        std::vector<std::string>& notes, const GpCameraDesc* standard) {
    if (!s.camera.empty()) {
        return fileCamera(device, scene, s.camera);
    }
    GpCameraDesc camera{};
    if (cameraCount(device, scene) > 0) {
        check(device, gpGetSceneCamera(scene, 0, &camera, nullptr));
        return camera;
    }
    if (standard != nullptr) {
        return *standard;
    }
    const float aspect = static_cast<float>(s.size.width) / static_cast<float>(s.size.height);
    check(device, gpFrameScene(scene, aspect, &camera));
    if (!s.from && !s.lookAt) {
        notes.push_back("the scene has no camera: it is shown whole, from the front");
    }
    return camera;
}

void setMiddle(GpDevice device, GpScene scene, float* point) {
    GpSceneInfo info{};
    check(device, gpGetSceneInfo(scene, &info));
    for (int axis = 0; axis < 3; ++axis) {
        point[axis] = 0.5f * (info.boundsMin[axis] + info.boundsMax[axis]);
    }
}

// Looking straight up or down, +Y says nothing about which way is up in the picture.
void setUp(GpCameraDesc& camera) {
    const float x = camera.target[0] - camera.position[0];
    const float y = camera.target[1] - camera.position[1];
    const float z = camera.target[2] - camera.position[2];
    const bool vertical = std::hypot(x, z) < 1.0e-4f * std::abs(y);
    camera.up[0] = 0.0f;
    camera.up[1] = vertical ? 0.0f : 1.0f;
    camera.up[2] = vertical ? (y < 0 ? -1.0f : 1.0f) : 0.0f;
}

}  // namespace

GpCameraDesc setUpCamera(GpDevice device, GpScene scene, const RenderSettings& s,
                         std::vector<std::string>& notes, const GpCameraDesc* standard) {
    GpCameraDesc camera = baseCamera(device, scene, s, notes, standard);
    if (s.from || s.lookAt) {
        // The lens and the roll of the file's camera were made for its own place.
        GpCameraDesc placed{};
        placed.verticalFov = camera.kind == GP_CAMERA_PERSPECTIVE ? camera.verticalFov : 0.0f;
        std::memcpy(placed.position, camera.position, sizeof placed.position);
        setMiddle(device, scene, placed.target);
        if (s.from) {
            std::memcpy(placed.position, s.from->data(), sizeof placed.position);
        }
        for (int axis = 0; standard != nullptr && axis < 3; ++axis) {
            placed.target[axis] =
                placed.position[axis] + standard->target[axis] - standard->position[axis];
        }
        if (s.lookAt) {
            std::memcpy(placed.target, s.lookAt->data(), sizeof placed.target);
        }
        if (std::memcmp(placed.position, placed.target, sizeof placed.position) == 0) {
            throw UsageError("--from: the camera stands where it looks at; give --look-at");
        }
        setUp(placed);
        camera = placed;
    }
    if (s.fovDeg) {
        if (camera.kind != GP_CAMERA_PERSPECTIVE) {
            throw UsageError("--fov: this camera is orthographic; give --from as well");
        }
        camera.verticalFov = static_cast<float>(*s.fovDeg * std::numbers::pi / 180.0);
    }
    return camera;
}

}  // namespace gp::tool
