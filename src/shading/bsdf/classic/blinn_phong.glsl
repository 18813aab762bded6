// Blinn-Phong: a power of the half vector's cosine. As with Phong, the published form is brightness
// in place of f cos_i (not physical); `normalization` and `divide_by_cosine` give the others:
//
//   none,       divided        f cos_i = cos^n: Blinn's own form
//   none,       not divided    f = cos^n
//   normalized, either         scaled so that a white surface seen from above returns all light
#ifndef GP_SHADING_BSDF_CLASSIC_BLINN_PHONG_GLSL
#define GP_SHADING_BSDF_CLASSIC_BLINN_PHONG_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// One over the albedo of cos^n at normal incidence. With t half the angle of wi, the integral is
// 8 pi of cos^(n+1) t sin t from 0 to pi/4, times cos 2t = 2 cos^2 t - 1 if cos_i counts.
// [Giesen 2009, "Phong and Blinn-Phong Normalization Factors"]
float blinn_phong_normalized_scale(IN(BsdfParams) m) {
    float n = blinn_phong_lobe_exponent(m);
    float half_power = exp2(-0.5f * n);
    if (blinn_phong_divided(m)) {
        return (n + 2.0f) / (2.0f * FOUR_PI * (1.0f - 0.5f * half_power));
    }
    return (n + 2.0f) * (n + 4.0f) / (2.0f * FOUR_PI * (half_power + n));
}

float blinn_phong_scale(IN(BsdfParams) m) {
    return blinn_phong_normalization(m) == 0u ? 1.0f : blinn_phong_normalized_scale(m);
}

BsdfValue blinn_phong_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    float n = blinn_phong_lobe_exponent(m);
    HalfVector h = half_vector(wo, wi);
    float power = height_power(h.wm, n);
    BsdfValue v;
    v.f_cos = m.base_color
            * (blinn_phong_scale(m) * power * (blinn_phong_divided(m) ? 1.0f : wi.z));
    v.pdf = reflection_pdf(cosine_power_pdf(power, n), h.cos_h);
    return v;
}

BsdfSample blinn_phong_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wm = square_to_cosine_power(u, blinn_phong_lobe_exponent(m));
    if (wo.z <= 0.0f || dot(wo, wm) <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wi = reflect(-wo, wm);
    return bsdf_sample_of(wi, blinn_phong_eval(m, wo, wi), LOBE_GLOSSY);
}

// Exact at normal incidence; from there on as narrow lobes have it, whose half vectors hold light
// in proportion to cos_h.
vec3 blinn_phong_albedo(IN(BsdfParams) m, float cos_o) {
    float c = max(cos_o, 0.0f);
    float lobe = blinn_phong_scale(m) / blinn_phong_normalized_scale(m);
    return m.base_color * (lobe * (blinn_phong_divided(m) ? c : c * c));
}

bool blinn_phong_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
