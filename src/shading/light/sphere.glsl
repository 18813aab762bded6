// Sphere, point and spot lights.
#ifndef GP_SHADING_LIGHT_SPHERE_GLSL
#define GP_SHADING_LIGHT_SPHERE_GLSL
#include "shading/frame.glsl"
#include "shading/light/light_sample.glsl"
#include "shading/sampling/warps.glsl"

struct SphereLight {
    vec3 position;
    float radius;     // metres; 0: a point
    vec3 emission;    // of a sphere its radiance, W/(m^2 sr); of a point its intensity, W/sr
    vec3 axis;        // unit, where a spot shines
    float cos_inner;  // full light within this angle of the axis,
    float cos_outer;  // none beyond this one; below -1: no spot, the same in all directions
};

// The share of a spot's light in a direction `cos_angle` from its axis.
// [KHR_lights_punctual, "Inner and Outer Cone Angles"]
float spot_falloff(float cos_angle, float cos_inner, float cos_outer) {
    float scale = 1.0f / max(0.001f, cos_inner - cos_outer);
    float share = clamp((cos_angle - cos_outer) * scale, 0.0f, 1.0f);
    return share * share;
}

// A spot with a size is a sphere behind a shade: the falloff follows the direction from its centre,
// hence is the same for all points of the sphere as seen from p.
vec3 sphere_light_emission(IN(SphereLight) l, vec3 p) {
    if (l.cos_outer < -1.0f) {
        return l.emission;
    }
    vec3 d = p - l.position;
    float cos_angle = dot(d, l.axis) * inversesqrt(max(dot(d, d), 1.0e-30f));
    return l.emission * spot_falloff(cos_angle, l.cos_inner, l.cos_outer);
}

// 1 - cos of the angular radius of a sphere seen from outside, with all digits for far ones.
float sphere_one_minus_cos(float radius_squared, float distance_squared) {
    float sin_squared = radius_squared / distance_squared;
    return sin_squared / (1.0f + sqrt(max(0.0f, 1.0f - sin_squared)));
}

// The density of sphere_light_sample at a hit on the sphere. `to_light` leads from p to that hit
// (not unit); it matters only where p is inside of the sphere.
float sphere_light_pdf(IN(SphereLight) l, vec3 p, vec3 to_light) {
    vec3 to_centre = l.position - p;
    float d2 = dot(to_centre, to_centre);
    float r2 = l.radius * l.radius;
    if (!(r2 > 0.0f)) {
        return 0.0f;
    }
    if (d2 > r2) {
        return uniform_cone_pdf(sphere_one_minus_cos(r2, d2));
    }
    vec3 normal = (to_light - to_centre) / l.radius;
    float cos_light = dot(to_light, normal) * inversesqrt(max(dot(to_light, to_light), 1.0e-30f));
    return solid_angle_pdf(INV_FOUR_PI / r2, to_light, cos_light);
}

LightSample sphere_light_sample(IN(SphereLight) l, vec3 p, vec2 u) {
    LightSample s = light_sample_none();
    vec3 to_centre = l.position - p;
    float d2 = dot(to_centre, to_centre);
    float r2 = l.radius * l.radius;
    s.radiance = sphere_light_emission(l, p);
    if (!(r2 > 0.0f)) {
        if (!(d2 > 0.0f)) {
            return light_sample_none();
        }
        s.distance = sqrt(d2);
        s.wi = to_centre / s.distance;
        s.radiance = s.radiance / d2;
        s.pdf = 1.0f;
        s.is_delta = 1u;
        return s;
    }
    if (d2 > r2) {
        float d = sqrt(d2);
        float one_minus_cos_max = sphere_one_minus_cos(r2, d2);
        vec3 local = square_to_uniform_cone(u, one_minus_cos_max);
        s.wi = world_from_local(frame_from_normal(to_centre / d), local);
        // The nearer intersection: half chord from Pythagoras, zero at the rim.
        float sin_squared = local.x * local.x + local.y * local.y;
        s.distance = max(0.0f, d * local.z - sqrt(max(0.0f, r2 - d2 * sin_squared)));
        s.pdf = uniform_cone_pdf(one_minus_cos_max);
        return s;
    }
    vec3 to_light = to_centre + l.radius * square_to_uniform_sphere(u);
    s.distance = length(to_light);
    s.wi = to_light / max(s.distance, 1.0e-30f);
    s.pdf = s.distance > 0.0f ? sphere_light_pdf(l, p, to_light) : 0.0f;
    return s;
}

#endif
