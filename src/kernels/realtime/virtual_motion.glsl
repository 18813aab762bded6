// Where what a pixel reflects was in the last frame. A mirror image does not move with the mirror:
// it stands as far behind it as what it shows is before it, and that point is reprojected.
#ifndef GP_KERNELS_REALTIME_VIRTUAL_MOTION_GLSL
#define GP_KERNELS_REALTIME_VIRTUAL_MOTION_GLSL
#include "kernels/realtime/gbuffer.glsl"
#include "shading/camera.glsl"

// How much of a reflection follows its mirror image, the rest following the surface.
// [Lagarde and de Rousiers 2014, "Moving Frostbite to Physically Based Rendering", section 4.9.3]
float reflection_dominance(float roughness) {
    float smoothness = clamp(1.0f - roughness, 0.0f, 1.0f);
    return smoothness * (sqrt(smoothness) + roughness);
}

// Pixels between where the surface of a pixel was and where its reflection was. `reach`: metres
// from the surface to what it shows. The motion of the camera is all of it that is known: what
// objects do is in the surface's own motion, to which this is added.
vec2 virtual_motion(ivec2 pixel, float depth, float reach, float roughness) {
    LET_REF(RealtimeConstants) c = load_realtime();
    LET_REF(CameraParams) now = load_camera();
    LET_REF(CameraParams) before = load_previous_camera();
    vec2 size = vec2(c.size);
    Ray ray = camera_ray_through_lens(now, (vec2(pixel) + 0.5f) / size, vec2(0.0f));
    float along = dot(ray.direction, now.forward);
    if (!(along > 0.0f)) { return vec2(0.0f); }
    vec3 surface = ray.origin + ray.direction * (depth / along);
    vec3 image = surface + ray.direction * (reach * reflection_dominance(roughness));
    vec3 from = camera_film_from_world(before, surface);
    vec3 to = camera_film_from_world(before, image);
    if (!(from.z > 0.0f && to.z > 0.0f)) { return vec2(0.0f); }
    return (vec2(to.x, to.y) - vec2(from.x, from.y)) * size;
}

#endif
