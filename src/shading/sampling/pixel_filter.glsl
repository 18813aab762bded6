// Pixel filters by importance sampling: each camera sample is moved by an offset distributed as the
// filter itself, so that every sample weighs exactly 1 and pixels share no samples.
// [Ernst et al. 2006, "Filter Importance Sampling"]
#ifndef GP_SHADING_SAMPLING_PIXEL_FILTER_GLSL
#define GP_SHADING_SAMPLING_PIXEL_FILTER_GLSL
#include "shading/constants.glsl"
#include "shading/powers.glsl"
#include "shading/trigonometry.glsl"

#define FILTER_BOX 0u
#define FILTER_TENT 1u
#define FILTER_GAUSSIAN 2u         // cut off at its radius of 3 standard deviations
#define FILTER_BLACKMAN_HARRIS 3u  // the four-term window

// erf(3 / sqrt(2)): the mass of a normal distribution within 3 standard deviations.
#define GAUSSIAN_MASS 0.99730020393673979f
// Coefficients of the window, [Harris 1978, "On the Use of Windows...", table 1, minimum 4-term].
#define BLACKMAN_HARRIS_A0 0.35875f
#define BLACKMAN_HARRIS_A1 0.48829f
#define BLACKMAN_HARRIS_A2 0.14128f
#define BLACKMAN_HARRIS_A3 0.01168f

// [Giles 2012, "Approximating the erfinv function", GPU Computing Gems, single precision]
float inverse_erf(float x) {
    float w = -log((1.0f - x) * (1.0f + x));
    if (w < 5.0f) {
        w = w - 2.5f;
        float p = 2.81022636e-08f;
        p = 3.43273939e-07f + p * w;
        p = -3.5233877e-06f + p * w;
        p = -4.39150654e-06f + p * w;
        p = 0.00021858087f + p * w;
        p = -0.00125372503f + p * w;
        p = -0.00417768164f + p * w;
        p = 0.246640727f + p * w;
        return (1.50140941f + p * w) * x;
    }
    w = sqrt(w) - 3.0f;
    float p = -0.000200214257f;
    p = 0.000100950558f + p * w;
    p = 0.00134934322f + p * w;
    p = -0.00367342844f + p * w;
    p = 0.00573950773f + p * w;
    p = -0.0076224613f + p * w;
    p = 0.00943887047f + p * w;
    p = 1.00167406f + p * w;
    return (2.83297682f + p * w) * x;
}

// The window's density on [-1, 1] and its integral from 0 to x; `angle`: sincos_turns(x / 2).
float blackman_harris_density(SinCos angle) {
    float c = angle.c;
    float c2 = 2.0f * c * c - 1.0f;
    float c3 = c * (4.0f * c * c - 3.0f);
    return (BLACKMAN_HARRIS_A0 + BLACKMAN_HARRIS_A1 * c + BLACKMAN_HARRIS_A2 * c2 +
            BLACKMAN_HARRIS_A3 * c3) / (2.0f * BLACKMAN_HARRIS_A0);
}

float blackman_harris_mass(float x, SinCos angle) {
    float s = angle.s;
    float c = angle.c;
    float s2 = 2.0f * s * c;
    float s3 = s * (4.0f * c * c - 1.0f);
    return (BLACKMAN_HARRIS_A0 * x +
            (BLACKMAN_HARRIS_A1 * s + BLACKMAN_HARRIS_A2 / 2.0f * s2 +
             BLACKMAN_HARRIS_A3 / 3.0f * s3) * INV_PI) / (2.0f * BLACKMAN_HARRIS_A0);
}

// The inverse of its distribution: a rational fit of our own in the logarithm of the tail (error
// below 1e-3), which is nearly linear there, then one step of Newton (error below 2e-5).
float blackman_harris_sample(float u) {
    float tail = min(u, 1.0f - u);
    float w = -LN_TWO * log2_above_0(max(2.0f * tail, EXP2_MINUS_24));
    float x = w * (0.35254781f + w * (0.1168491f - w * 0.0022598843f)) /
              (1.0f + w * (0.78469221f + w * 0.049799201f));
    SinCos angle = sincos_turns(0.5f * x);
    x += (0.5f - tail - blackman_harris_mass(x, angle)) / blackman_harris_density(angle);
    x = clamp(x, 0.0f, 1.0f);
    return u < 0.5f ? -x : x;
}

float filter_sample_1d(uint kind, float u) {
    if (kind == FILTER_TENT) {
        return u < 0.5f ? sqrt(2.0f * u) - 1.0f : 1.0f - sqrt(2.0f * (1.0f - u));
    }
    if (kind == FILTER_GAUSSIAN) {
        return SQRT_TWO / 3.0f * inverse_erf((2.0f * u - 1.0f) * GAUSSIAN_MASS);
    }
    if (kind == FILTER_BLACKMAN_HARRIS) {
        return blackman_harris_sample(u);
    }
    return 2.0f * u - 1.0f;
}

// The filter on [-1, 1], normalised; zero outside.
float filter_density_1d(uint kind, float x) {
    if (!(abs(x) <= 1.0f)) {
        return 0.0f;
    }
    if (kind == FILTER_TENT) {
        return 1.0f - abs(x);
    }
    if (kind == FILTER_GAUSSIAN) {
        // 3 / (sqrt(2 pi) mass): the standard deviation is a third of the radius.
        return 1.19682684120429f / GAUSSIAN_MASS * exp(-4.5f * x * x);
    }
    if (kind == FILTER_BLACKMAN_HARRIS) {
        return blackman_harris_density(sincos_turns(0.5f * x));
    }
    return 0.5f;
}

// The offset of a camera sample from its pixel's centre, in pixels; the filter is the product of
// two one-dimensional ones, zero beyond `radius`.
vec2 filter_sample(uint kind, float radius, vec2 u) {
    return radius * vec2(filter_sample_1d(kind, u.x), filter_sample_1d(kind, u.y));
}

float filter_pdf(uint kind, float radius, vec2 offset) {
    return filter_density_1d(kind, offset.x / radius) * filter_density_1d(kind, offset.y / radius) /
           (radius * radius);
}

#endif
