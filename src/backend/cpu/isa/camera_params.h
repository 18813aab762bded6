// The camera as kernels see it. Part of the hot code: included inside an unnamed namespace, after
// shading/shading.h and scene/camera.h.
inline CameraParams cameraParams(const Camera& c, uint32_t width, uint32_t height) {
    const bool perspective = c.kind == CameraKind::perspective;
    const float halfY = perspective ? std::tan(0.5f * c.verticalFov) : 0.5f * c.orthographicHeight;
    CameraParams p =
        camera_look_at(perspective ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC, c.position, c.target,
                       c.up, halfY, float(width) / float(height));
    p.lens_radius = c.apertureRadius;
    p.focus_distance = c.focusDistance > 0 ? c.focusDistance : length(c.target - c.position);
    return p;
}
