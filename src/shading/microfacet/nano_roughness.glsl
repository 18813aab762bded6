// Roughness about as small as the wavelength, which no microfacet describes: it takes light out of
// the mirror direction and diffracts it into a wide lobe. Its heights have the standard deviation
// sigma and the K-correlation ("ABC") power spectrum with the length b and the exponent c > 1. All
// lengths are in one unit, say micrometres, the wavelength too.
//
// Based on: Holzschuch and Pacanowski 2017, "A Two-Scale Microfacet Reflectance Model Combining
// Reflection and Diffraction", ACM TOG 36(4). Different here:
// - The share of the spectrum that diffracts into visible directions is a sum of closed forms,
//   not a table; error below 1e-3 of its value, 1e-4 for b up to 20 wavelengths.
// - The polarisation factor is half the sum of its four squares, which in the mirror direction is
//   the Fresnel reflectance F. With the whole sum, as in the authors' program, the lobe returns
//   (1 - A) 2 F: twice what the mirror loses (tests/statistics/nano_roughness_test.cpp).
#ifndef GP_SHADING_MICROFACET_NANO_ROUGHNESS_GLSL
#define GP_SHADING_MICROFACET_NANO_ROUGHNESS_GLSL
#include "shading/complex.glsl"
#include "shading/constants.glsl"

// Points of the sum over the logarithm of the slopes in nano_blurred_length.
#define NANO_BLUR_POINTS 16
// An even rule over a smooth periodic function converges like a geometric series.
#define NANO_SHARE_POINTS 24

// The spectrum over sigma^2, normalised over the plane, at a frequency in units of 1 / wavelength:
// f = |(wo + wi).xy|; b in wavelengths. [Holzschuch and Pacanowski 2017, K-correlation model]
float nano_spectrum(float f2, float b, float c) {
    return INV_TWO_PI * (c - 1.0f) * b * b * pow(1.0f + b * b * f2, -0.5f * (c + 1.0f));
}

// The share of the spectrum beyond the distance whose square is f2.
float nano_spectrum_beyond(float f2, float b, float c) {
    return exp2(-0.5f * (c - 1.0f) * log2(1.0f + b * b * f2));
}

// sigma_rel^2 / sigma^2: the share of the spectrum that sends light from an angle into directions
// above the horizon, those within a unit circle around -wo.xy. Seen from the spectrum's centre the
// circle is at a distance d(psi) in the direction psi, and the share within d has a closed form:
// one smooth integral is left. [Holzschuch and Pacanowski 2017, sigma_rel; our own integration]
float nano_visible_share(float cos_o, float b, float c) {
    float cos2 = cos_o * cos_o;
    float sin2 = max(1.0f - cos2, 0.0f);
    float sin_o = sqrt(sin2);
    float beyond = 0.0f;
    // psi and pi - psi are the two roots of d^2 + 2 d sin cos(psi) = cos^2; psi turns by a step.
    float half_step = HALF_PI / float(NANO_SHARE_POINTS);
    vec2 turn = vec2(cos(2.0f * half_step), sin(2.0f * half_step));
    vec2 psi = vec2(cos(half_step), sin(half_step));
    for (int i = 0; i < NANO_SHARE_POINTS / 2; ++i) {
        float middle = sin_o * psi.x;
        float far_root = sqrt(middle * middle + cos2) + middle;
        float near_root = cos2 / max(far_root, 1.0e-20f);
        beyond += nano_spectrum_beyond(far_root * far_root, b, c)
                + nano_spectrum_beyond(near_root * near_root, b, c);
        psi = complex_multiply(psi, turn);
    }
    return 1.0f - beyond / float(NANO_SHARE_POINTS);
}

// wo + wi along the surface, as a displacement with the density of the normalised spectrum.
vec2 nano_spectrum_sample(float b, float c, vec2 u) {
    float r2 = (pow(1.0f - u.x, -2.0f / (c - 1.0f)) - 1.0f) / (b * b);
    float r = sqrt(clamp(r2, 0.0f, 1.0e8f));
    return vec2(r * cos(TWO_PI * u.y), r * sin(TWO_PI * u.y));
}

// The length of a spectrum that stands for this one after microfacets have blurred it: of
// exponential power slopes with the width beta and the power p, each of which turns wo + wi by
// twice its slope. Its peak is that of the convolution (error 0.005), and it is normalised again;
// at half of the peak it is off by up to 0.35, further out it has the spectrum's own exponent. The
// paper has tables for this that are not ours to use. The peak is the mean of the spectrum at the
// slopes, a sum over their logarithm.
float nano_blurred_length(float b, float c, float beta, float p) {
    float ratio2 = 4.0f * b * b * beta * beta;
    // From 0.05 % of the weight to where exp(-t^p) is 1e-4.
    float first = -7.5f;
    float step_x = (2.2f / p - first) / float(NANO_BLUR_POINTS - 1);
    float sum = 0.0f;
    float weights = 0.0f;
    for (int i = 0; i < NANO_BLUR_POINTS; ++i) {
        float x = first + step_x * float(i);
        float weight = exp(x - exp(p * x));
        weights += weight;
        sum += weight * pow(1.0f + ratio2 * exp(x), -0.5f * (c + 1.0f));
    }
    return b * sqrt(sum / weights);
}

// A, what is left in the mirror direction of light that goes from one angle to the other; both
// sigmas in wavelengths. [Holzschuch and Pacanowski 2017; Bennett and Porteus 1961, JOSA 51(2)]
float nano_specular_share(float sigma_rel, float cos_o, float cos_i) {
    float phase = TWO_PI * sigma_rel * (cos_o + cos_i);
    return exp(-phase * phase);
}

// How a surface of the index n + i k polarises what it diffracts: half the sum of |Q|^2. cos_phi is
// the cosine between the azimuths of wi and of the mirror direction. Reciprocal. It leaves [0, 1]:
// for metals the first order of the theory grows like 1 / cos^2 towards grazing angles.
// [Church, Jenkinson, Zavada 1977, Optical Engineering 16(4); Stover 2012, "Optical Scattering"]
float nano_polarisation(vec2 ior, float cos_o, float cos_i, float cos_phi) {
    vec2 e = complex_multiply(ior, ior);
    float sin2_o = max(1.0f - cos_o * cos_o, 0.0f);
    float sin2_i = max(1.0f - cos_i * cos_i, 0.0f);
    vec2 g_o = complex_sqrt(e - vec2(sin2_o, 0.0f));
    vec2 g_i = complex_sqrt(e - vec2(sin2_i, 0.0f));
    vec2 s_o = g_o + vec2(cos_o, 0.0f);
    vec2 s_i = g_i + vec2(cos_i, 0.0f);
    vec2 p_o = g_o + e * cos_o;
    vec2 p_i = g_i + e * cos_i;
    float sin2_phi = max(1.0f - cos_phi * cos_phi, 0.0f);
    // Squares of absolute values; those of products are products.
    float so = dot(s_o, s_o);
    float si = dot(s_i, s_i);
    float po = dot(p_o, p_o);
    float pi = dot(p_i, p_i);
    vec2 parallel = complex_multiply(g_o, g_i) * cos_phi - e * sqrt(sin2_o * sin2_i);
    float sum = cos_phi * cos_phi / (so * si) + dot(parallel, parallel) / (po * pi)
              + sin2_phi * (dot(g_o, g_o) / (si * po) + dot(g_i, g_i) / (so * pi));
    vec2 contrast = e - vec2(1.0f, 0.0f);
    return 0.5f * dot(contrast, contrast) * sum;
}

#endif
