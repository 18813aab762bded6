// Thin-film interference in colour, polarised, over dielectrics and metals: the reflectance of
// a film is a series in the path difference, and each term is integrated against the eye's
// sensitivity in closed form, so that no wavelength is sampled.
//
// Based on: Belcour and Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of
// Varying Iridescence", ACM TOG 36(4). Different here:
// - The base has the index n + i k; the paper's kappa is k / n, its base n (1 + i kappa).
// - The film fades within 0.03 nm of no thickness, as in KHR_materials_iridescence; the paper's
//   shader fades over 30 nm of path, which for real films of 10 nm is off by 0.03.
// - Nothing is clamped: the truncated series may leave [0, 1] by some hundredths, and who needs
//   conserved energy clamps, as the paper's shader does.
#ifndef GP_SHADING_IRIDESCENCE_POLARISED_GLSL
#define GP_SHADING_IRIDESCENCE_POLARISED_GLSL
#include "shading/iridescence.glsl"
#include "shading/thin_film.glsl"

// Enough for the eye; 10 are exact to four digits unless both faces are mirrors.
#define IRIDESCENCE_TERMS 3

// CIE RGB from XYZ for the white E. The constant 1 must become white, which it does to 1e-6; the
// matrix to Rec. 709 (white D65) would make it (1.205, 0.948, 0.909).
// [Belcour and Barla 2017, supplemental code]
vec3 rgb_from_xyz_equal_energy(vec3 c) {
    return vec3(2.3706743f, -0.5138850f, 0.0052982f) * c.x
         + vec3(-0.9000405f, 1.4253036f, -0.0146949f) * c.y
         + vec3(-0.4706338f, 0.0885814f, 1.0093968f) * c.z;
}

// One polarisation, as XYZ. [Belcour and Barla 2017, equations 3 to 10]
vec3 iridescence_series(vec2 amplitude12, vec2 amplitude23, float opd_nm, int terms) {
    float r12 = dot(amplitude12, amplitude12);
    float r23 = dot(amplitude23, amplitude23);
    float t121 = 1.0f - r12;
    float r123 = min(r12 * r23, 0.9999f);
    float rs = t121 * t121 * r23 / (1.0f - r123);
    // From inside the outer face reflects with the opposite sign: phase21 + phase23. A face that
    // reflects nothing has no phase; atan(0, 0) is undefined in GLSL.
    vec2 both = -complex_multiply(amplitude12, amplitude23);
    float shift = dot(both, both) > 0.0f ? atan(both.y, both.x) : 0.0f;
    float amplitude = sqrt(r123);
    float c = rs - t121;
    vec3 sum = (r12 + rs) * iridescence_sensitivity_xyz(0.0f, vec3(0.0f));
    for (int m = 1; m <= terms; ++m) {
        c *= amplitude;
        float order = float(m);
        sum += (2.0f * c) * iridescence_sensitivity_xyz(order * opd_nm, vec3(order * shift));
    }
    return sum;
}

// Reflectance as linear RGB, not clamped; cos_o in (0, 1]. A film of no thickness must not change
// the base, but with finitely many terms the series ends near it only: the index fades.
vec3 fresnel_iridescence_polarised(IN(ThinFilm) film, float cos_o, int terms) {
    float ior = mix(film.outside_ior, film.film_ior, smoothstep(0.0f, 0.03f, film.thickness_nm));
    float tangential2 = film.outside_ior * film.outside_ior * (1.0f - cos_o * cos_o);
    if (tangential2 >= ior * ior) {
        return vec3(1.0f);
    }
    vec2 outside = vec2(film.outside_ior, 0.0f);
    vec2 inside = vec2(ior, 0.0f);
    vec2 q1 = vec2(film.outside_ior * cos_o, 0.0f);
    vec2 q2 = film_normal_component(inside, tangential2);
    vec2 q3 = film_normal_component(film.base_ior, tangential2);
    FilmAmplitude r12 = film_amplitude(outside, q1, inside, q2, tangential2);
    FilmAmplitude r23 = film_amplitude(inside, q2, film.base_ior, q3, tangential2);
    float opd_nm = 2.0f * film.thickness_nm * q2.x;
    vec3 xyz = iridescence_series(r12.s, r23.s, opd_nm, terms)
             + iridescence_series(r12.p, r23.p, opd_nm, terms);
    return rgb_from_xyz_equal_energy(0.5f * xyz);
}

#endif
