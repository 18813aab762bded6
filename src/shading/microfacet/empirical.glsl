// Distributions from before microfacets had an area: functions of the angle to the half vector that
// were chosen by eye or by fit. Where a factor that makes their projected area one has a closed
// form, it stands beside the published value.
#ifndef GP_SHADING_MICROFACET_EMPIRICAL_GLSL
#define GP_SHADING_MICROFACET_EMPIRICAL_GLSL
#include "shading/constants.glsl"

// The angle between wm and the normal; from the sine, since acos has no digits near 0.
float angle_to_normal(vec3 wm) {
    return atan(sqrt(wm.x * wm.x + wm.y * wm.y), wm.z);
}

// 1 at the normal; c is the angle at which it is 1 / e.
// [Blinn 1977, SIGGRAPH, "Models of Light Reflection for Computer Synthesized Pictures"]
float gaussian_angle_d(vec3 wm, float c) {
    float x = angle_to_normal(wm) / c;
    return exp(-x * x);
}

float exponential_angle_d(vec3 wm, float c) {
    return exp(-angle_to_normal(wm) / c);
}

// The integral of exp(-theta / c) cos over the hemisphere.
float exponential_angle_area(float c) {
    return TWO_PI * (1.0f + exp(-HALF_PI / c)) / (1.0f / (c * c) + 4.0f);
}

// c^4 / (cos^2 (c^2 - 1) + 1)^2, 1 at the normal: GGX times pi c^2.
// [Trowbridge and Reitz 1975, JOSA 65(5)]
float trowbridge_reitz_d(vec3 wm, float c) {
    float e = (wm.x * wm.x + wm.y * wm.y) / (c * c) + wm.z * wm.z;
    return 1.0f / (e * e);
}

// The hemispherical exponential power distribution, one lobe of it.
// [Nishino 2009, ICCV, "Directional Statistics BRDF Model"]
float nishino_d(float cos_h, float kappa, float power) {
    float x = kappa * pow(max(cos_h, 0.0f), power);
    // 1 - e^-x; the difference has no digits where x is small.
    return x < 1.0e-3f ? x * (1.0f - 0.5f * x) : 1.0f - exp(-x);
}

#endif
