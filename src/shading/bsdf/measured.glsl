// A measured isotropic material: the cells of a MERL file, looked up as they are.
#ifndef GP_SHADING_BSDF_MEASURED_GLSL
#define GP_SHADING_BSDF_MEASURED_GLSL
#include "shading/measured/half_density.glsl"

#define MEASURED_NEAREST 1u

// Sampled by the cosine; the rest by the data. It bounds the weights (20 pi f at most) where the
// density's nodes lie wider than the data's features.
#define MEASURED_COSINE_SHARE 0.05f

bool measured_is_black(IN(BsdfParams) m, vec3 wo) {
    return wo.z <= 0.0f || !table_exists(m.table);
}

BsdfValue measured_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (measured_is_black(m, wo) || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    vec3 f = measured_interpolation(m) == MEASURED_NEAREST ? merl_nearest(m.table, wo, wi)
                                                           : merl_trilinear(m.table, wo, wi);
    HalfVector h = half_vector(wo, wi);
    BsdfValue v;
    v.f_cos = m.base_color * f * wi.z;
    v.pdf = mix(reflection_pdf(half_density_pdf(m.table, wo, h.wm), h.cos_h),
                cosine_hemisphere_pdf(wi), MEASURED_COSINE_SHARE);
    return v;
}

BsdfSample measured_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (measured_is_black(m, wo)) {
        return bsdf_no_sample();
    }
    if (u_lobe < MEASURED_COSINE_SHARE) {
        vec3 any = square_to_cosine_hemisphere(u);
        return bsdf_sample_of(any, measured_eval(m, wo, any), LOBE_DIFFUSE);
    }
    float u_view = (u_lobe - MEASURED_COSINE_SHARE) / (1.0f - MEASURED_COSINE_SHARE);
    vec3 wm = half_density_sample(m.table, wo, u_view, u);
    vec3 wi = normalize(wm * (2.0f * dot(wo, wm)) - wo);
    return bsdf_sample_of(wi, measured_eval(m, wo, wi), LOBE_GLOSSY);
}

vec3 measured_albedo(IN(BsdfParams) m, float cos_o) {
    bool black = cos_o <= 0.0f || !table_exists(m.table);
    return black ? vec3(0.0f) : m.base_color * half_density_albedo(m.table, cos_o);
}

bool measured_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
