#include <numbers>

#include "api/check.h"
#include "api/scenes.h"
#include "scene/sky.h"

namespace gp::api {

static_assert(GP_CAMERA_ORTHOGRAPHIC == int(CameraKind::orthographic));

namespace {

bool parallel(const glm::vec3& a, const glm::vec3& b) {
    const glm::dvec3 da(a), db(b);
    return glm::length(glm::cross(da, db)) <= 1e-6 * glm::length(da) * glm::length(db);
}

void readUp(Camera& camera, const GpCameraDesc& desc) {
    checkFinite(desc.up, 3, "camera.up");
    const glm::vec3 view = camera.target - camera.position;
    if (!allZero(desc.up, 3)) {
        camera.up = vec3From(desc.up);
        if (parallel(view, camera.up))
            fail(GP_ERROR_OUT_OF_RANGE, "camera.up is parallel to the view");
        return;
    }
    // Maps are looked at from above: their north, -Z, is then at the top of the picture.
    camera.up = parallel(view, {0, 1, 0}) ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
}

}  // namespace

Camera cameraFrom(const GpCameraDesc& desc) {
    Camera camera;
    camera.kind = CameraKind(checkEnum(desc.kind, 2, "camera.kind"));
    checkFinite(desc.position, 3, "camera.position");
    checkFinite(desc.target, 3, "camera.target");
    camera.position = vec3From(desc.position);
    camera.target = vec3From(desc.target);
    if (camera.target == camera.position) camera.target.z -= 1;
    const float distance = glm::distance(camera.target, camera.position);
    if (!(distance > 0) || !std::isfinite(distance))
        fail(GP_ERROR_OUT_OF_RANGE, "camera.position and camera.target give no direction");
    readUp(camera, desc);
    checkRange(desc.verticalFov, 0, std::numbers::pi, "camera.verticalFov");
    if (desc.verticalFov >= float(std::numbers::pi))
        fail(GP_ERROR_OUT_OF_RANGE, "camera.verticalFov is {:g}, not below pi", desc.verticalFov);
    if (desc.verticalFov != 0) camera.verticalFov = desc.verticalFov;
    checkNotNegative(desc.orthographicHeight, "camera.orthographicHeight");
    if (desc.orthographicHeight != 0) camera.orthographicHeight = desc.orthographicHeight;
    checkNotNegative(desc.apertureRadius, "camera.apertureRadius");
    camera.apertureRadius = desc.apertureRadius;
    checkNotNegative(desc.focusDistance, "camera.focusDistance");
    camera.focusDistance = desc.focusDistance;
    return camera;
}

GpCameraDesc descFrom(const Camera& camera) {
    GpCameraDesc desc{};
    desc.kind = GpCameraKind(camera.kind);
    for (int i = 0; i < 3; ++i) {
        desc.position[i] = camera.position[i];
        desc.target[i] = camera.target[i];
        desc.up[i] = camera.up[i];
    }
    desc.verticalFov = camera.verticalFov;
    desc.orthographicHeight = camera.orthographicHeight;
    desc.apertureRadius = camera.apertureRadius;
    desc.focusDistance = camera.focusDistance;
    return desc;
}

}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpGetSceneCamera(GpScene scene, uint32_t index, GpCameraDesc* camera, const char** name) {
    return enter("gpGetSceneCamera", "scene", scene, [&](SceneObject& s) {
        checkPointer(camera, "camera");
        if (index >= s.scene.cameras.size())
            fail(GP_ERROR_OUT_OF_RANGE, "index is {}, but the scene has {} cameras", index,
                 s.scene.cameras.size());
        const gp::Camera& found = s.scene.cameras[index];
        // The cameras move when more are loaded; the names in the set do not.
        if (name) *name = s.cameraNames.insert(found.name).first->c_str();
        *camera = descFrom(found);
    });
}

GpError gpFrameScene(GpScene scene, float aspect, GpCameraDesc* camera) {
    return enter("gpFrameScene", "scene", scene, [&](SceneObject& s) {
        checkPointer(camera, "camera");
        checkFinite(aspect, "aspect");
        if (!(aspect > 0)) fail(GP_ERROR_OUT_OF_RANGE, "aspect is {:g}, not above 0", aspect);
        *camera = descFrom(gp::frameScene(s.scene, aspect));
    });
}

}  // extern "C"
