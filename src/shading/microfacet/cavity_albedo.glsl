// What Beckmann facets under V-cavities reflect after one scattering, for any width at once: out of
// a table over widths that scripts/bake_tables made by the quadrature of mirror_albedo.glsl. Where
// the width of a material varies from point to point that quadrature would take 0.3 ms a point.
#ifndef GP_SHADING_MICROFACET_CAVITY_ALBEDO_GLSL
#define GP_SHADING_MICROFACET_CAVITY_ALBEDO_GLSL
#include "shading/microfacet/chebyshev.glsl"
#include "shading/powers.glsl"

// Widths alpha from 2^-10 to 2, three to an octave: what depends on cosines as large as the widths
// has the same error everywhere. Linear between two of them is 0.0006 off at most, where twelve
// coefficients are up to 0.01 off at grazing angles (tests/water/cavity_albedo_test.cpp).
#define CAVITY_ALBEDO_WIDTHS 34

float cavity_albedo_width(int row) {
    return exp2(float(row) * (1.0f / 3.0f) - 10.0f);
}

#include "shading/microfacet/cavity_albedo_table.glsl"

float cavity_albedo_coefficient(int at, float between, float f0) {
    float low = f0 * cavity_albedo_entry(at) + cavity_albedo_entry(at + 12);
    float high = f0 * cavity_albedo_entry(at + 24) + cavity_albedo_entry(at + 36);
    return low + between * (high - low);
}

vec4 cavity_albedo_coefficients(int at, float between, float f0) {
    return vec4(cavity_albedo_coefficient(at, between, f0),
                cavity_albedo_coefficient(at + 1, between, f0),
                cavity_albedo_coefficient(at + 2, between, f0),
                cavity_albedo_coefficient(at + 3, between, f0));
}

// The albedo with Schlick's term of f0, over the root of the cosine; alpha is above 0.
Chebyshev cavity_albedo(float alpha, float f0) {
    float at = clamp(3.0f * log2_above_0(alpha) + 30.0f, 0.0f, float(CAVITY_ALBEDO_WIDTHS - 1));
    int row = min(int(at), CAVITY_ALBEDO_WIDTHS - 2);
    float between = at - float(row);
    Chebyshev c;
    c.low = cavity_albedo_coefficients(24 * row, between, f0);
    c.middle = cavity_albedo_coefficients(24 * row + 4, between, f0);
    c.high = cavity_albedo_coefficients(24 * row + 8, between, f0);
    return c;
}

// 2 * integral of such an albedo times the cosine over cosines: of the polynomials, exactly.
float cavity_albedo_average(IN(Chebyshev) c) {
    return dot(c.low, vec4(1.0000000f, 0.6000000f, -0.0666667f, -0.3142857f))
         + dot(c.middle, vec4(-0.2190476f, -0.1111111f, -0.0666667f, -0.0464646f))
         + dot(c.high, vec4(-0.0343434f, -0.0265734f, -0.0212010f, -0.0173382f));
}

#endif
