// The exponential power distribution of slopes, isotropic: p = 1 is Beckmann, smaller powers have
// longer tails and a sharper peak.
#ifndef GP_SHADING_MICROFACET_EXPONENTIAL_POWER_GLSL
#define GP_SHADING_MICROFACET_EXPONENTIAL_POWER_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"

// [Holzschuch and Pacanowski 2017, ACM TOG 36(4)]
float exponential_power_d(vec3 wm, float alpha, float p) {
    if (wm.z <= 0.0f) {
        return 0.0f;
    }
    float z2 = wm.z * wm.z;
    float e = (wm.x * wm.x + wm.y * wm.y) / (alpha * alpha * z2);
    float power = e > 0.0f ? exp(p * log(e)) : 0.0f;
    // Far out the numerator is 0, but so may be the denominator.
    if (power > 80.0f || z2 < 1.0e-12f) {
        return 0.0f;
    }
    return p * INV_PI * exp(-power - log_gamma(1.0f / p)) / (alpha * alpha * z2 * z2);
}

// tan^2 of a normal with the density D cos: its power p has a gamma distribution of shape 1 / p.
float exponential_power_sample_tan2(float alpha, float p, float u) {
    float x = gamma_p_inverse(1.0f / p, u);
    return alpha * alpha * (x > 0.0f ? exp(log(x) / p) : 0.0f);
}

#endif
