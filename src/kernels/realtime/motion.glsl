// Where a surface appears, now and in the last frame, also through mirrors.
// Resources: load_camera, load_previous_camera, load_realtime, load_previous_instance,
// load_previous_corners.
#ifndef GP_KERNELS_REALTIME_MOTION_GLSL
#define GP_KERNELS_REALTIME_MOTION_GLSL
#include "kernels/surface.glsl"
#include "shading/camera.glsl"
#include "shared/realtime_structs.glsl"

// The way from a point to where plane mirrors show it: the product of their reflections.
struct MirrorImage {
    vec3 x;         // where the axes go
    vec3 y;
    vec3 z;
    vec3 offset;
};

MirrorImage mirror_image_identity() {
    MirrorImage m;
    m.x = vec3(1.0f, 0.0f, 0.0f);
    m.y = vec3(0.0f, 1.0f, 0.0f);
    m.z = vec3(0.0f, 0.0f, 1.0f);
    m.offset = vec3(0.0f);
    return m;
}

vec3 mirror_image_of_vector(IN(MirrorImage) m, vec3 v) {
    return m.x * v.x + m.y * v.y + m.z * v.z;
}

vec3 mirror_image_of_point(IN(MirrorImage) m, vec3 p) {
    return mirror_image_of_vector(m, p) + m.offset;
}

// Seen through one more mirror, at p with the unit normal n: p' = p - 2 ((p - at) . n) n comes
// first, then what was there.
MirrorImage mirror_image_behind(IN(MirrorImage) m, vec3 at, vec3 n) {
    vec3 turned = mirror_image_of_vector(m, n);
    MirrorImage next;
    next.x = m.x - turned * (2.0f * n.x);
    next.y = m.y - turned * (2.0f * n.y);
    next.z = m.z - turned * (2.0f * n.z);
    next.offset = m.offset + turned * (2.0f * dot(at, n));
    return next;
}

// A point of the picture in pixels, its depth along the view in z.
vec3 pixels_from_world(IN(CameraParams) camera, vec3 p) {
    LET_REF(RealtimeConstants) r = load_realtime();
    vec3 film = camera_film_from_world(camera, p);
    return vec3(film.x * float(r.size.x), film.y * float(r.size.y), film.z);
}

// Where the point of the triangle was in the last frame; `known` 0: nobody can say.
struct PreviousPoint {
    vec3 position;
    uint known;
};

PreviousPoint previous_point(IN(Hit) hit) {
    LET_REF(PreviousInstance) previous = load_previous_instance(hit.instance);
    PreviousPoint p;
    p.position = vec3(0.0f);
    p.known = previous.index != NO_INDEX ? 1u : 0u;
    if (p.known == 0u) { return p; }
    PreviousCorners c = load_previous_corners(hit.instance, hit.primitive);
    vec4 q = vec4(interpolate(c.p0, c.p1, c.p2, hit.u, hit.v), 1.0f);
    p.position = vec3(dot(previous.world_from_object[0], q),
                      dot(previous.world_from_object[1], q),
                      dot(previous.world_from_object[2], q));
    return p;
}

// Depth where the ray through a point of the picture meets a plane; `other` where it does not.
float plane_depth(IN(CameraParams) camera, vec2 pixel, vec3 at, vec3 normal, float other) {
    LET_REF(RealtimeConstants) r = load_realtime();
    vec2 film = vec2(pixel.x / float(r.size.x), pixel.y / float(r.size.y));
    Ray ray = camera_ray_through_lens(camera, film, vec2(0.0f));
    float t = dot(at - ray.origin, normal) / dot(ray.direction, normal);
    return t > 0.0f && t < DEPTH_NONE ? t * dot(ray.direction, camera.forward) : other;
}

// How much the depth of a plane changes to the next pixel, at most: second rays to the same plane.
// [Igehy 1999, "Tracing Ray Differentials", section 3.1.1; finite differences instead]
float depth_slope(IN(CameraParams) camera, vec3 at, vec3 normal) {
    vec3 here = pixels_from_world(camera, at);
    vec2 pixel = vec2(here.x, here.y);
    float right = plane_depth(camera, pixel + vec2(1.0f, 0.0f), at, normal, 2.0f * here.z);
    float below = plane_depth(camera, pixel + vec2(0.0f, 1.0f), at, normal, 2.0f * here.z);
    return min(max(abs(right - here.z), abs(below - here.z)), here.z);
}

// The motion image's value for a surface whose point p is seen as `image` says.
vec4 surface_motion(IN(MirrorImage) image, vec3 p, vec3 normal, IN(PreviousPoint) previous) {
    LET_REF(CameraParams) camera = load_camera();
    vec3 now = mirror_image_of_point(image, p);
    vec3 here = pixels_from_world(camera, now);
    float slope = depth_slope(camera, now, mirror_image_of_vector(image, normal));
    if (previous.known == 0u) { return vec4(0.0f, 0.0f, 0.0f, slope); }
    vec3 before = mirror_image_of_point(image, previous.position);
    vec3 there = pixels_from_world(load_previous_camera(), before);
    return vec4(there.x - here.x, there.y - here.y, there.z - here.z, slope);
}

// The same for the sky, which only turns.
vec4 sky_motion(IN(MirrorImage) image, vec3 direction) {
    LET_REF(CameraParams) camera = load_camera();
    LET_REF(CameraParams) previous_camera = load_previous_camera();
    vec3 d = mirror_image_of_vector(image, direction);
    if (camera.kind == CAMERA_ORTHOGRAPHIC || !(dot(d, previous_camera.forward) > 0.0f)) {
        return vec4(0.0f);
    }
    vec3 here = pixels_from_world(camera, camera.position + d);
    vec3 there = pixels_from_world(previous_camera, previous_camera.position + d);
    return vec4(there.x - here.x, there.y - here.y, 0.0f, 0.0f);
}

#endif
