// Blinn and Phong's distribution as a microfacet distribution: a power of the cosine, of area one.
// alpha stands for the exponent n = 2 / alpha^2 - 2, with which the peak is that of Beckmann.
#ifndef GP_SHADING_MICROFACET_BLINN_PHONG_GLSL
#define GP_SHADING_MICROFACET_BLINN_PHONG_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"
#include "shading/sampling/cosine_power.glsl"

// [Walter et al. 2007, EGSR, "Phong distribution"]
float blinn_phong_exponent(float alpha) {
    return 2.0f / (alpha * alpha) - 2.0f;
}

float blinn_phong_alpha(float exponent) {
    return sqrt(2.0f / (exponent + 2.0f));
}

// (n + 2) / (2 pi) cos^n. [Walter et al. 2007, EGSR, "Phong distribution"]
float blinn_phong_d(vec3 wm, float alpha) {
    return INV_PI / (alpha * alpha) * height_power(wm, blinn_phong_exponent(alpha));
}

// [Walter et al. 2007, EGSR, "Phong distribution"]
float blinn_phong_sample_sin2(float alpha, float u) {
    float e = alpha * alpha * log(max(1.0f - u, 1.0e-20f));
    return clamp(-e * expm1_over(e), 0.0f, 1.0f);
}

#endif
