// cos^n about an axis: the lobe of the classic models, to evaluate and to sample. Everything is
// taken from sines and differences: a cosine near 1 has too few digits to be raised to 10,000.
#ifndef GP_SHADING_SAMPLING_COSINE_POWER_GLSL
#define GP_SHADING_SAMPLING_COSINE_POWER_GLSL
#include "shading/constants.glsl"
#include "shading/frame.glsl"
#include "shading/special.glsl"

// cos^n of the angle between two unit vectors; 0 from the right angle on.
float cosine_power(vec3 a, vec3 b, float n) {
    vec3 d = a - b;
    float one_minus_cos = 0.5f * dot(d, d);
    return one_minus_cos < 1.0f ? exp(n * log1p_accurate(-one_minus_cos)) : 0.0f;
}

// log(w.z) of a unit vector with w.z > 0, from its sine where that has the digits.
float log_height(vec3 w) {
    return w.z < 0.85f ? log(max(w.z, 1.0e-37f))
                       : 0.5f * log1p_accurate(-(w.x * w.x + w.y * w.y));
}

// w.z^n of a unit vector.
float height_power(vec3 w, float n) {
    return w.z > 0.0f ? exp(n * log_height(w)) : 0.0f;
}

// A direction around +Z with the density (n + 1) / (2 pi) z^n.
// [Lafortune and Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based
// Rendering", section 4]
vec3 square_to_cosine_power(vec2 u, float n) {
    float t = -log1p_accurate(-u.x) / (n + 1.0f);
    float r = sqrt(2.0f * t * expm1_over(-2.0f * t));
    float phi = TWO_PI * u.y;
    return vec3(r * cos(phi), r * sin(phi), exp(-t));
}

float cosine_power_pdf(float power, float n) {
    return (n + 1.0f) * INV_TWO_PI * power;
}

// The same around another axis.
vec3 square_to_cosine_power_about(vec3 axis, vec2 u, float n) {
    return world_from_local(frame_from_normal(axis), square_to_cosine_power(u, n));
}

#endif
