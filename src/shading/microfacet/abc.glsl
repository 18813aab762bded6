// The ABC distribution of normals, isotropic: a / (1 + b (1 - cos))^c, the form that the scattering
// of polished surfaces has. alpha stands for b = 2 / alpha^2; `a` is such that the area is one.
#ifndef GP_SHADING_MICROFACET_ABC_GLSL
#define GP_SHADING_MICROFACET_ABC_GLSL
#include "shading/constants.glsl"
#include "shading/microfacet/gtr.glsl"

float abc_b(float alpha) {
    return 2.0f / (alpha * alpha);
}

// The integral of y^-c from 1 to e^l.
float abc_power_integral(float l, float c) {
    return l * expm1_over((1.0f - c) * l);
}

// `a` from 1 = 2 pi a / b^2 * integral of (b + 1 - y) y^-c over y from 1 to 1 + b.
float abc_peak(float b, float c) {
    float l = log(1.0f + b);
    float area = (b + 1.0f) * abc_power_integral(l, c) - abc_power_integral(l, c - 1.0f);
    return INV_TWO_PI * b * (b / area);
}

// 1 + b (1 - cos), 1 - cos from the sine.
float abc_y(vec3 wm, float b) {
    return 1.0f + b * (wm.x * wm.x + wm.y * wm.y) / (1.0f + wm.z);
}

// [Low, Kronander, Ynnerman, Unger 2012, ACM TOG 31(1); normalised]
float abc_d(vec3 wm, float alpha, float c) {
    float b = abc_b(alpha);
    return wm.z > 0.0f ? abc_peak(b, c) * gtr_falloff(abc_y(wm, b), c) : 0.0f;
}

// 1 - cos of a normal with the density D over its integral: with the cosine there is no closed
// form of the inverse.
float abc_sample_one_minus_cos(float alpha, float c, float u) {
    float b = abc_b(alpha);
    float l = log(1.0f + b);
    float place = gtr_exponential_place(l, c, u);
    return clamp(place * l * expm1_over(place * l) / b, 0.0f, 1.0f);
}

float abc_sample_pdf(vec3 wm, float alpha, float c) {
    float b = abc_b(alpha);
    float l = log(1.0f + b);
    float norm = INV_TWO_PI * b / abc_power_integral(l, c);
    return wm.z > 0.0f ? norm * gtr_falloff(abc_y(wm, b), c) : 0.0f;
}

#endif
