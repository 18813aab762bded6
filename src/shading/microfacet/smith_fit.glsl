// Smith's masking of a distribution without a closed form of Lambda, as eight numbers that
// smith_quadrature.glsl makes once for a material. With c the cotangent of a direction and m the
// mean slope, Lambda starts as m / c at the horizon. u = c / (c + m) therefore is G1 but for a
// factor between 1 and 1.33, which is the same smooth bump for all distributions:
//
//   G1 = u (1 + u (1 - u) r),   r a polynomial of degree six in c / (c + 4 m)
//
// Errors of G1 (tests/statistics): 0.0015; 0.003 for exponential power, whose slopes end abruptly
// for large p.
#ifndef GP_SHADING_MICROFACET_SMITH_FIT_GLSL
#define GP_SHADING_MICROFACET_SMITH_FIT_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"

struct SmithFit {
    vec4 low;   // m and the first three coefficients of r in Chebyshev polynomials
    vec4 high;  // the other four
};

SmithFit smith_fit_none() {
    SmithFit f;
    f.low = vec4(0.0f);
    f.high = vec4(0.0f);
    return f;
}

// |z| over the length of the projection: 1 / tan of the direction.
float cotangent(vec3 w) {
    return abs(w.z) * inversesqrt(max(w.x * w.x + w.y * w.y, 1.0e-30f));
}

// Where r is to be taken, in [-1, 1].
float smith_fit_place(float c, float mean_slope) {
    return 2.0f * c / (c + 4.0f * mean_slope) - 1.0f;
}

// Clenshaw's summation. [Press et al. 2007, "Numerical Recipes", section 5.8]
float smith_fit_bump(IN(SmithFit) f, float x) {
    float x2 = 2.0f * x;
    float b6 = f.high.w;
    float b5 = f.high.z + x2 * b6;
    float b4 = f.high.y + x2 * b5 - b6;
    float b3 = f.high.x + x2 * b4 - b5;
    float b2 = f.low.w + x2 * b3 - b4;
    float b1 = f.low.z + x2 * b2 - b3;
    return f.low.y + x * b1 - b2;
}

float smith_fit_g1(IN(SmithFit) f, float c) {
    float m = f.low.x;
    float u = c / (c + m);
    float g1 = u * (1.0f + u * (1.0f - u) * smith_fit_bump(f, smith_fit_place(c, m)));
    return clamp(g1, 1.0e-30f, 1.0f);
}

float smith_fit_lambda(IN(SmithFit) f, vec3 w) {
    return 1.0f / smith_fit_g1(f, cotangent(w)) - 1.0f;
}

// Adds the value of r at a node: all seven make the coefficients.
SmithFit smith_fit_with_node(IN(SmithFit) f, float value, float angle) {
    float v = value * (2.0f / 7.0f);
    SmithFit g = f;
    g.low.y += 0.5f * v;
    g.low.z += v * cos(angle);
    g.low.w += v * cos(2.0f * angle);
    g.high.x += v * cos(3.0f * angle);
    g.high.y += v * cos(4.0f * angle);
    g.high.z += v * cos(5.0f * angle);
    g.high.w += v * cos(6.0f * angle);
    return g;
}

float smith_fit_angle(int node) {
    return PI * (float(node) + 0.5f) / 7.0f;
}

// The exponential power distribution depends on alpha by a scale only: its numbers are polynomials
// of p, from 1/4 to 4, whose constants scripts/fit_exponential_power.py has found; m has a closed
// form.
SmithFit exponential_power_fit(float alpha, float p) {
    float x = clamp((p / (1.0f + p) - 0.5f) / 0.3f, -1.0f, 1.0f);
    float x2 = 2.0f * x * x - 1.0f;
    vec4 t = vec4(1.0f, x, x2, 2.0f * x * x2 - x);
    SmithFit f;
    f.low.x = alpha * INV_PI * exp(log_gamma(1.5f / p) - log_gamma(1.0f / p));
    f.low.y = dot(t, vec4(1.033229f, 0.049748f, -0.016478f, 0.004430f));
    f.low.z = dot(t, vec4(0.187475f, -0.023816f, 0.007658f, -0.001700f));
    f.low.w = dot(t, vec4(-0.319814f, -0.069818f, 0.021588f, -0.005443f));
    f.high.x = dot(t, vec4(0.080892f, 0.038836f, -0.011030f, 0.001823f));
    f.high.y = dot(t, vec4(0.043179f, 0.026860f, -0.006074f, 0.001025f));
    f.high.z = dot(t, vec4(-0.021592f, -0.019016f, 0.003839f, 0.000114f));
    f.high.w = dot(t, vec4(-0.010342f, -0.011161f, 0.001377f, 0.000077f));
    return f;
}

#endif
