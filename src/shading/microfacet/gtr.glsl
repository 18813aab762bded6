// Generalised Trowbridge-Reitz: D = c / (alpha^2 cos^2 + sin^2)^gamma, isotropic, any gamma > 0.
// gamma = 2 is GGX; 1 is Berry's distribution, used by Disney's clearcoat. Written in
// y = cos^2 + sin^2 / alpha^2 and L = log(1 / alpha^2), which leave no quotient 0 / 0 at
// gamma = 1 or alpha = 1.
#ifndef GP_SHADING_MICROFACET_GTR_GLSL
#define GP_SHADING_MICROFACET_GTR_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"

// y^-gamma; the exponents that have names need no power.
float gtr_falloff(float y, float gamma) {
    if (gamma == 2.0f) {
        return 1.0f / (y * y);
    }
    if (gamma == 1.0f) {
        return 1.0f / y;
    }
    if (gamma == 1.5f) {
        return inversesqrt(y) / y;
    }
    return exp(-gamma * log(y));
}

// Its value at the normal: (1 - alpha^2) / integral of y^-gamma over y from 1 to 1 / alpha^2,
// over pi alpha^2, where both are of the form (e^x - 1) / x.
// [Burley 2012, "Physically Based Shading at Disney", appendix B.2, any gamma]
float gtr_peak(float alpha, float gamma) {
    float l = -2.0f * log(alpha);
    return INV_PI * expm1_over(-l) / (alpha * alpha * expm1_over((1.0f - gamma) * l));
}

float gtr_d(vec3 wm, float alpha, float gamma) {
    if (wm.z <= 0.0f) {
        return 0.0f;
    }
    float y = wm.z * wm.z + (wm.x * wm.x + wm.y * wm.y) / (alpha * alpha);
    return gtr_peak(alpha, gamma) * gtr_falloff(y, gamma);
}

// The place lambda in [0, 1] at which e^((1 - gamma) L lambda) has the share u of its integral.
float gtr_exponential_place(float l, float gamma, float u) {
    float k = (1.0f - gamma) * l;
    float e = expm1_over(k);
    // k e is e^k - 1 > -1, but not by its rounding error.
    return u * e * log1p_over(max(u * k * e, -ONE_MINUS_EPSILON));
}

// sin^2 of a normal with the density D cos; u in [0, 1).
// [Burley 2012, appendix B.2, any gamma]
float gtr_sample_sin2(float alpha, float gamma, float u) {
    float l = -2.0f * log(alpha);
    float place = gtr_exponential_place(l, gamma, u);
    return clamp(place * expm1_over(place * l) / expm1_over(l), 0.0f, 1.0f);
}

// That normal. From the sine: 1 - cos of a narrow lobe has no digits.
vec3 gtr_sample(float alpha, float gamma, vec2 u) {
    float sin2 = gtr_sample_sin2(alpha, gamma, u.x);
    float sin_theta = sqrt(sin2);
    float phi = TWO_PI * u.y;
    return vec3(sin_theta * cos(phi), sin_theta * sin(phi), sqrt(1.0f - sin2));
}

#endif
