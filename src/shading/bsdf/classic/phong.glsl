// Phong: a power of the cosine to the mirror direction. As it was published it is brightness, not
// reflectance: cos^n in place of f cos_i, so that light at grazing angles counts as much as from
// above. `normalization` and `divide_by_cosine` give the forms that are in use:
//
//   none,       divided        f cos_i = cos^n: Phong's own; neither reciprocal nor conserving
//   none,       not divided    f = cos^n
//   normalized, divided        f cos_i = (n + 1) / (2 pi) cos^n: the lobe holds all of the light
//   normalized, not divided    f = (n + 2) / (2 pi) cos^n: see modified_phong.glsl
#ifndef GP_SHADING_BSDF_CLASSIC_PHONG_GLSL
#define GP_SHADING_BSDF_CLASSIC_PHONG_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// [Phong 1975, CACM 18(6); the factors: Lafortune and Willems 1994, section 2]
float phong_scale(IN(BsdfParams) m) {
    float n = phong_exponent(m) + (phong_divided(m) ? 1.0f : 2.0f);
    return phong_normalization(m) == 0u ? 1.0f : n * INV_TWO_PI;
}

BsdfValue phong_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    float n = phong_exponent(m);
    float power = cosine_power(mirror_direction(wo), wi, n);
    float scale = phong_scale(m) * power * (phong_divided(m) ? 1.0f : wi.z);
    BsdfValue v;
    v.f_cos = m.base_color * scale;
    v.pdf = cosine_power_pdf(power, n);
    return v;
}

BsdfSample phong_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_power_about(mirror_direction(wo), u, phong_exponent(m));
    return bsdf_sample_of(wi, phong_eval(m, wo, wi), LOBE_GLOSSY);
}

// As if all of the lobe were above the horizon.
vec3 phong_albedo(IN(BsdfParams) m, float cos_o) {
    float n = phong_exponent(m) + (phong_divided(m) ? 1.0f : 2.0f);
    float height = phong_divided(m) ? step(0.0f, cos_o) : max(cos_o, 0.0f);
    return m.base_color * (phong_scale(m) * TWO_PI / n * height);
}

bool phong_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
