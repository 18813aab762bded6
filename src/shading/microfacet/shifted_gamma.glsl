// The shifted gamma distribution (SGD) of squared slopes, isotropic, which fits the measured metals
// and plastics of MERL: a power p near the normal, an exponential of the width alpha further out.
#ifndef GP_SHADING_MICROFACET_SHIFTED_GAMMA_GLSL
#define GP_SHADING_MICROFACET_SHIFTED_GAMMA_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"

// The integral of v^-p from `from` to 1, and L = log(1 / from) >= 0.
float shifted_gamma_power_part(float l, float p) {
    return l * expm1_over((p - 1.0f) * l);
}

// Gamma(1 - p, alpha), the first argument of either sign: e^-v v^-p, from alpha to 1 by the series
// of e^-v, from 1 on by a continued fraction.
float shifted_gamma_norm(float alpha, float p) {
    if (alpha >= 1.0f) {
        return exp(-alpha + (1.0f - p) * log(alpha)) * gamma_upper_fraction(1.0f - p, alpha);
    }
    float l = -log(alpha);
    float sum = exp(-1.0f) * gamma_upper_fraction(1.0f - p, 1.0f);
    float coefficient = 1.0f;
    for (int k = 0; k < 10; ++k) {
        sum += coefficient * shifted_gamma_power_part(l, p - float(k));
        coefficient /= -float(k + 1);
    }
    return sum;
}

// [Bagher, Soler, Holzschuch 2012, EGSR]
float shifted_gamma_d(vec3 wm, float alpha, float p) {
    if (wm.z < 1.0e-6f) {
        return 0.0f;
    }
    float z2 = wm.z * wm.z;
    float v = alpha + (wm.x * wm.x + wm.y * wm.y) / (alpha * z2);
    // alpha^(p - 1) (alpha^2 + tan^2)^-p is v^-p / alpha.
    float log_p22 = -v - p * log(v);
    return v < 80.0f ? INV_PI * exp(log_p22) / (alpha * shifted_gamma_norm(alpha, p) * z2 * z2)
                     : 0.0f;
}

// Its inverse distribution function has no closed form; v = alpha + tan^2 / alpha is drawn from
// v^-p below 1 and from e^(1 - v) above, so that D cos is at most e times the density.
float shifted_gamma_sample_tan2(float alpha, float p, float u) {
    float inner = alpha < 1.0f ? shifted_gamma_power_part(-log(alpha), p) : 0.0f;
    float start = max(alpha, 1.0f);
    float pick = u * (inner + 1.0f);
    float v;
    if (pick < inner) {
        // From alpha outwards: the integral of v^-p up to there is pick.
        float k = (1.0f - p);
        float scaled = pick * exp(-k * log(alpha));
        v = alpha * exp(scaled * log1p_over(k * scaled));
    } else {
        v = start - log(max(1.0f - (pick - inner), 1.0e-20f));
    }
    return max(alpha * (v - alpha), 0.0f);
}

// The density of that normal, per solid angle.
float shifted_gamma_sample_pdf(vec3 wm, float alpha, float p) {
    if (wm.z < 1.0e-6f) {
        return 0.0f;
    }
    float z2 = wm.z * wm.z;
    float v = alpha + (wm.x * wm.x + wm.y * wm.y) / (alpha * z2);
    float inner = alpha < 1.0f ? shifted_gamma_power_part(-log(alpha), p) : 0.0f;
    float log_density = v < 1.0f ? -p * log(v) : max(alpha, 1.0f) - v;
    return INV_PI * exp(log_density) / ((inner + 1.0f) * alpha * z2 * wm.z);
}

#endif
