// A light at infinity: the sun, a disk of a given angular radius, or a mere direction.
#ifndef GP_SHADING_LIGHT_DIRECTIONAL_GLSL
#define GP_SHADING_LIGHT_DIRECTIONAL_GLSL
#include "shading/frame.glsl"
#include "shading/light/light_sample.glsl"
#include "shading/sampling/warps.glsl"

struct DirectionalLight {
    vec3 direction;           // unit, to the middle of the disk
    vec3 irradiance;          // W/m^2 on a surface that faces it
    float one_minus_cos_max;  // 1 - cos of the disk's angular radius, as 2 sin^2(radius / 2);
                              // 0: a direction only
};

// The radiance of the disk: facing it, its cosine-weighted solid angle is pi sin^2(radius).
vec3 directional_light_radiance(IN(DirectionalLight) l) {
    float sin_squared = l.one_minus_cos_max * (2.0f - l.one_minus_cos_max);
    return sin_squared > 0.0f ? l.irradiance / (PI * sin_squared) : vec3(0.0f);
}

// Whether a direction is on the disk. By the chord, whose square is 2 (1 - cos): the cosine of a
// direction near the middle has no digits left.
bool directional_light_contains(IN(DirectionalLight) l, vec3 wi) {
    vec3 chord = wi - l.direction;
    return dot(chord, chord) <= 2.0f * l.one_minus_cos_max;
}

float directional_light_pdf(IN(DirectionalLight) l, vec3 wi) {
    bool found = l.one_minus_cos_max > 0.0f && directional_light_contains(l, wi);
    return found ? uniform_cone_pdf(l.one_minus_cos_max) : 0.0f;
}

LightSample directional_light_sample(IN(DirectionalLight) l, vec2 u) {
    LightSample s;
    s.distance = FLOAT_MAX;
    if (l.one_minus_cos_max > 0.0f) {
        vec3 local = square_to_uniform_cone(u, l.one_minus_cos_max);
        s.wi = world_from_local(frame_from_normal(l.direction), local);
        s.radiance = directional_light_radiance(l);
        s.pdf = uniform_cone_pdf(l.one_minus_cos_max);
        s.is_delta = 0u;
    } else {
        s.wi = l.direction;
        s.radiance = l.irradiance;
        s.pdf = 1.0f;
        s.is_delta = 1u;
    }
    return s;
}

#endif
