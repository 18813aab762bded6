// Weights of multiple importance sampling: how much of a light path found by technique a counts,
// when b could have found it too. Any pair of densities from 0 to infinity (a delta) is valid; the
// weights of a and b then add up to 1, unless both densities are 0.
// [Veach and Guibas 1995, "Optimally Combining Sampling Techniques for Monte Carlo Rendering"]
#ifndef GP_SHADING_SAMPLING_MIS_GLSL
#define GP_SHADING_SAMPLING_MIS_GLSL
#include "shading/constants.glsl"

// How many times likelier b is than a. A ratio, because squares of densities overflow: narrow
// lobes reach 1e20. Two infinite densities count as equal.
float mis_ratio(float pdf_a, float pdf_b) {
    return min(pdf_b, FLOAT_MAX) / min(pdf_a, FLOAT_MAX);
}

float mis_balance(float pdf_a, float pdf_b) {
    return pdf_a > 0.0f ? 1.0f / (1.0f + mis_ratio(pdf_a, pdf_b)) : 0.0f;
}

float mis_power(float pdf_a, float pdf_b) {
    if (!(pdf_a > 0.0f)) {
        return 0.0f;
    }
    float ratio = mis_ratio(pdf_a, pdf_b);
    return 1.0f / (1.0f + ratio * ratio);
}

#endif
