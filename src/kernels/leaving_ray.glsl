// Rays that leave a surface: on which side of its triangle they start.
// Resources: load_frame.
#ifndef GP_KERNELS_LEAVING_RAY_GLSL
#define GP_KERNELS_LEAVING_RAY_GLSL
#include "kernels/shading_point.glsl"
#include "shading/camera.glsl"
#include "shading/light/light_sample.glsl"
#include "shading/ray_offset.glsl"

#define SHADOW_MARGIN 1.0e-4f     // of a shadow ray's length: it must not meet the light itself

// Whether light turning from wo to wi stays on the side of the surface that its shading normal
// says; a normal map or smooth shading must not make light leak through, nor back. The sea has no
// such side: its triangles are only the long waves, and its slopes belong to shorter ones that
// stand on them. Light that these reflect downwards goes on above the triangle (leaving_side),
// where it meets the next wave.
bool sides_agree(IN(Surface) s, IN(ShadingPoint) p, vec3 wo, vec3 wi, vec3 wo_local,
                 vec3 wi_local) {
    if ((p.flags & MATERIAL_SEA) != 0u) { return true; }
    return same_side(p.bsdf, wo_local, wi_local) ==
           ((dot(s.ng, wi) > 0.0f) == (dot(s.ng, wo) > 0.0f));
}

// The geometric normal on the side of the triangle where a ray to wi begins.
vec3 leaving_side(IN(Surface) s, IN(ShadingPoint) p, vec3 wo, vec3 wi) {
    bool front = dot(s.ng, wi) > 0.0f;
    if ((p.flags & MATERIAL_SEA) != 0u) {
        front = (dot(s.ng, wo) > 0.0f) == same_side(p.bsdf, local_from_world(p.frame, wo),
                                                    local_from_world(p.frame, wi));
    }
    return front ? s.ng : -s.ng;
}

// `side`: as leaving_side gives it.
Ray ray_from(IN(Surface) s, vec3 side, vec3 direction, float t_max) {
    Ray ray;
    ray.origin = offset_ray_origin(s.position, side);
    ray.direction = direction;
    ray.t_min = 0.0f;
    ray.t_max = min(t_max, load_frame().ray_length);
    return ray;
}

// To the chosen point of a light. It is aimed anew from the moved origin: where the light is seen
// edge-on, the old direction would meet it far before that point, and the light would shadow
// itself.
Ray shadow_ray(IN(Surface) s, IN(ShadingPoint) p, vec3 wo, IN(LightSample) light) {
    Ray ray = ray_from(s, leaving_side(s, p, wo, light.wi), light.wi, light.distance);
    if (light.distance < FLOAT_MAX) {
        vec3 to_light = s.position + light.wi * light.distance - ray.origin;
        float distance = length(to_light);
        ray.direction = to_light / max(distance, 1.0e-30f);
        ray.t_max = distance * (1.0f - SHADOW_MARGIN);
    }
    return ray;
}

#endif
