// Thin-film interference as KHR_materials_iridescence has it: the model of Belcour and Barla with
// Schlick's Fresnel term at both interfaces, phases of 0 or pi, and two terms of the series.
#ifndef GP_SHADING_IRIDESCENCE_GLSL
#define GP_SHADING_IRIDESCENCE_GLSL
#include "shading/constants.glsl"
#include "shading/fresnel.glsl"

// Linear Rec. 709 from XYZ, as the extension prints it (columns first in GLSL and in GLM).
vec3 rec709_from_xyz_gltf(vec3 c) {
    return vec3(3.2404542f, -0.9692660f, 0.0556434f) * c.x
         + vec3(-1.5371385f, 1.8760108f, -0.2040259f) * c.y
         + vec3(-0.4985314f, 0.0415560f, 1.0572252f) * c.z;
}

// The Fourier transform of the eye's sensitivity, a sum of Gaussians, at an optical path
// difference in nanometres and a phase shift per channel.
// [Belcour and Barla 2017, ACM TOG 36(4), section 4 and supplemental code]
vec3 iridescence_sensitivity_xyz(float opd_nm, vec3 shift) {
    float phase = TWO_PI * opd_nm * 1.0e-9f;
    vec3 position = vec3(1.6810e6f, 1.7953e6f, 2.2084e6f);
    vec3 variance = vec3(4.3278e9f, 9.3046e9f, 6.6121e9f);
    // Heights times sqrt(2 pi variance) over the normalisation 1.0685e-7, all of them constants.
    vec3 height = vec3(0.846590f, 1.000222f, 1.001122f);
    vec3 xyz = height * cos(position * phase + shift) * exp(-phase * phase * variance);
    xyz.x += 0.153868f * cos(2.2399e6f * phase + shift.x) * exp(-4.5282e9f * phase * phase);
    return xyz;
}

vec3 iridescence_sensitivity(float opd_nm, vec3 shift) {
    return rec709_from_xyz_gltf(iridescence_sensitivity_xyz(opd_nm, shift));
}

// 0 where light enters the denser medium, pi otherwise.
float iridescence_phase(float ior_from, float ior_to) {
    return ior_to < ior_from ? PI : 0.0f;
}

// Reflectance of a film over a base that alone reflects base_f0. Above 0, but the truncated series
// may exceed 1; who needs energy conservation clamps it.
// [KHR_materials_iridescence, "Implementation Notes"]
vec3 fresnel_iridescence(float outside_ior, float film_ior, float cos_o, float thickness_nm,
                         vec3 base_f0) {
    // A film of no thickness must not change the base: its index fades to that of the outside.
    float ior = mix(outside_ior, film_ior, smoothstep(0.0f, 0.03f, thickness_nm));
    float ratio = outside_ior / ior;
    float cos2_film = 1.0f - ratio * ratio * (1.0f - cos_o * cos_o);
    if (cos2_film < 0.0f) {
        return vec3(1.0f);
    }
    float cos_film = sqrt(cos2_film);
    float r12 = fresnel_schlick(f0_from_ior(ior / outside_ior), 1.0f, cos_o);
    float t121 = 1.0f - r12;
    // The extension's own guard against an f0 of 1; it is felt in the fourth digit.
    vec3 f0 = base_f0 + vec3(1.0e-4f);
    vec3 base_ior = vec3(ior_from_f0(f0.x), ior_from_f0(f0.y), ior_from_f0(f0.z));
    vec3 r1 = vec3(f0_from_ior(base_ior.x / ior), f0_from_ior(base_ior.y / ior),
                   f0_from_ior(base_ior.z / ior));
    vec3 r23 = fresnel_schlick(r1, vec3(1.0f), cos_film);
    float phase21 = PI - iridescence_phase(outside_ior, ior);
    vec3 phase = vec3(phase21) + vec3(iridescence_phase(ior, base_ior.x),
                                      iridescence_phase(ior, base_ior.y),
                                      iridescence_phase(ior, base_ior.z));
    vec3 r123 = clamp(r12 * r23, vec3(1.0e-5f), vec3(0.9999f));
    vec3 rs = t121 * t121 * r23 / (vec3(1.0f) - r123);
    float opd_nm = 2.0f * ior * thickness_nm * cos_film;
    // The constant term, then the pairs at +- m of the path difference.
    vec3 amplitude = sqrt(r123);
    vec3 c1 = (rs - vec3(t121)) * amplitude;
    vec3 sum = vec3(r12) + rs + 2.0f * c1 * iridescence_sensitivity(opd_nm, phase);
    sum += 2.0f * c1 * amplitude * iridescence_sensitivity(2.0f * opd_nm, 2.0f * phase);
    return max(sum, vec3(0.0f));
}

#endif
