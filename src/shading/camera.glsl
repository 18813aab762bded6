// The camera: from a point of the film and one of the lens to a ray.
#ifndef GP_SHADING_CAMERA_GLSL
#define GP_SHADING_CAMERA_GLSL
#include "shading/constants.glsl"
#include "shading/ray_cone.glsl"
#include "shading/sampling/warps.glsl"

#define CAMERA_PERSPECTIVE 0u
#define CAMERA_ORTHOGRAPHIC 1u

// Made once a frame by camera_look_at. Vectors are unit and at right angles.
struct CameraParams {
    vec3 position;
    float lens_radius;     // metres; 0 is a pinhole
    vec3 right;
    float half_x;          // half of the film: at distance 1 (perspective: the tangent of half the
                           // field of view), or in metres (orthographic)
    vec3 up;
    float half_y;
    vec3 forward;
    float focus_distance;  // metres along forward to the plane in focus; used with a lens only
    uint kind;
};

struct Ray {
    vec3 origin;
    vec3 direction;
    float t_min;
    float t_max;
};

// A camera at `position` that looks at `target`; `up` need be neither unit nor perpendicular, and
// any other axis is taken where it points along the view. `half_y` as in CameraParams; `aspect` is
// width over height. The lens is closed.
CameraParams camera_look_at(uint kind, vec3 position, vec3 target, vec3 up, float half_y,
                            float aspect) {
    CameraParams c;
    c.position = position;
    c.forward = normalize(target - position);
    vec3 right = cross(c.forward, up);
    if (!(dot(right, right) > 1.0e-12f * dot(up, up))) {
        vec3 other = abs(c.forward.y) < 0.9f ? vec3(0.0f, 1.0f, 0.0f) : vec3(0.0f, 0.0f, -1.0f);
        right = cross(c.forward, other);
    }
    c.right = normalize(right);
    c.up = cross(c.right, c.forward);
    c.half_x = half_y * aspect;
    c.half_y = half_y;
    c.kind = kind;
    c.lens_radius = 0.0f;
    c.focus_distance = 1.0f;
    return c;
}

// `film` is in [0, 1]^2 from the upper left corner; `lens` a point of the unit disk.
Ray camera_ray_through_lens(IN(CameraParams) c, vec2 film, vec2 lens) {
    vec3 on_film = c.right * ((2.0f * film.x - 1.0f) * c.half_x) +
                   c.up * ((1.0f - 2.0f * film.y) * c.half_y);
    vec3 aside = (c.right * lens.x + c.up * lens.y) * c.lens_radius;
    Ray ray;
    ray.t_min = 0.0f;
    ray.t_max = FLOAT_MAX;
    // All rays of a film point meet where its chief ray crosses the plane in focus.
    if (c.kind == CAMERA_ORTHOGRAPHIC) {
        ray.origin = c.position + on_film + aside;
        ray.direction = normalize(c.forward * c.focus_distance - aside);
    } else {
        ray.origin = c.position + aside;
        ray.direction = normalize((c.forward + on_film) * c.focus_distance - aside);
    }
    return ray;
}

// `u_lens` is uniform in [0, 1)^2 and used only where the lens has a size.
Ray camera_ray(IN(CameraParams) c, vec2 film, vec2 u_lens) {
    vec2 lens = c.lens_radius > 0.0f ? square_to_concentric_disk(u_lens) : vec2(0.0f);
    return camera_ray_through_lens(c, film, lens);
}

// Where a point appears, and its distance along the view: (film x, film y, depth). The inverse of
// camera_ray for a pinhole; film positions behind a perspective camera mean nothing.
vec3 camera_film_from_world(IN(CameraParams) c, vec3 p) {
    vec3 d = p - c.position;
    float depth = dot(d, c.forward);
    float scale = c.kind == CAMERA_ORTHOGRAPHIC ? 1.0f : depth;
    float x = dot(d, c.right) / (c.half_x * scale);
    float y = dot(d, c.up) / (c.half_y * scale);
    return vec3(0.5f + 0.5f * x, 0.5f - 0.5f * y, depth);
}

// The angle of a pixel at the middle of an image of `height` pixels.
// [Akenine-Moller et al. 2019, Ray Tracing Gems, chapter 20, equation 30]
float camera_pixel_spread(IN(CameraParams) c, float height) {
    return c.kind == CAMERA_ORTHOGRAPHIC ? 0.0f : atan(2.0f * c.half_y / height);
}

// The cone of a camera ray where it starts.
RayCone camera_ray_cone(IN(CameraParams) c, float height) {
    RayCone cone;
    cone.width = c.kind == CAMERA_ORTHOGRAPHIC ? 2.0f * c.half_y / height : 0.0f;
    cone.spread = camera_pixel_spread(c, height);
    return cone;
}

#endif
