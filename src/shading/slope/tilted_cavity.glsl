// For comparison only: V-cavity masking of slopes about a mean as earlier work has it, a groove
// rotated by the angle of the mean slope. Its masking function leaves the mean out, so that what
// is seen adds up to cos theta only where the mean slope is across the view, and never to the
// projected area of the mesosurface at grazing angles: it makes and loses energy.
// docs/water.md has figures; sheared_cavity.glsl is what to use.
// Based on: "WaterGlints" 2024, thesis, equations 11, 12, 20 and 21.
#ifndef GP_SHADING_SLOPE_TILTED_CAVITY_GLSL
#define GP_SHADING_SLOPE_TILTED_CAVITY_GLSL
#include "shading/microfacet/masking.glsl"
#include "shading/slope/sheared_cavity.glsl"

// min(1, 2 (w.g) (m.g) / (w.m)) with g the normal of the geometry, whatever the mean slope is: a
// groove about slope 0 although that is not the mean. [WaterGlints 2024, equations 11 and 20]
float tilted_cavity_g1(vec2 s, vec3 w) {
    return sheared_cavity_g1(vec2(0.0f), s, w);
}

// Of the light, which must stand above the mesosurface. [WaterGlints 2024, equations 12 and 21]
float tilted_cavity_g1_light(vec2 mean, vec2 s, vec3 wi) {
    return slope_facing(mean, wi) > 0.0f ? tilted_cavity_g1(s, wi) : 0.0f;
}

// The deeper shadow counts, as in sheared_cavity_g2: the two are compared, not their joint forms.
float tilted_cavity_g2(vec2 mean, vec2 s, vec3 wo, vec3 wi) {
    return min(tilted_cavity_g1(s, wo), tilted_cavity_g1_light(mean, s, wi));
}

// What the shader that came with it computes instead: it turns the half vector alone, by the mean
// slope along its azimuth, taken for an angle. (At h = n it divides by zero; here nothing turns.)
vec3 shipped_cavity_turned(vec3 h, vec2 mean) {
    float r = sqrt(h.x * h.x + h.y * h.y);
    if (!(r > 0.0f)) {
        return h;
    }
    float angle = (h.x * mean.x + h.y * mean.y) / r;
    float c = cos(angle);
    float s = sin(angle);
    float scale = (r * c - h.z * s) / r;
    return vec3(h.x * scale, h.y * scale, h.z * c + r * s);
}

float shipped_cavity_g1(vec3 turned, vec3 w) {
    float facing = dot(turned, w);
    return facing > 0.0f ? max(masking_v_cavity_g1(w.z, turned.z, facing), 0.0f) : 0.0f;
}

// In f cos = F D G / 4, without the division by cos theta, with D about the mean 0 and directions
// in the frame of the mesosurface; it multiplies by the projected area, where others divide.
float shipped_cavity_g2(vec2 mean, vec3 h, vec3 wo, vec3 wi) {
    vec3 turned = shipped_cavity_turned(h, mean);
    float area = max(slope_facing(mean, wo), 1.0f);
    return wi.z > 0.0f ? shipped_cavity_g1(turned, wo) * shipped_cavity_g1(turned, wi) * area
                       : 0.0f;
}

#endif
