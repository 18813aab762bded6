// A rough mirror under a thin film: the colours of soap, oil and anodised metal.
#ifndef GP_SHADING_BSDF_WAVE_IRIDESCENT_MIRROR_GLSL
#define GP_SHADING_BSDF_WAVE_IRIDESCENT_MIRROR_GLSL
#include "shading/iridescence_polarised.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/bsdf/ggx_lobe.glsl"

// The truncated series leaves [0, 1] by a little: no light is negative, none is made.
// [Belcour and Barla 2017, ACM TOG 36(4), supplemental code]
vec3 iridescent_mirror_fresnel(IN(BsdfParams) m, float cos_h) {
    ThinFilm film;
    film.outside_ior = 1.0f;
    film.film_ior = m.iridescence_ior;
    float eta = iridescent_mirror_base_ior(m);
    film.base_ior = vec2(eta, eta * iridescent_mirror_base_kappa(m));
    film.thickness_nm = m.iridescence_thickness_nm;
    vec3 f = fresnel_iridescence_polarised(film, cos_h, int(iridescent_mirror_terms(m) + 0.5f));
    return clamp(f, vec3(0.0f), vec3(1.0f));
}

BsdfValue iridescent_mirror_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    GgxLobe lobe = ggx_reflection(wo, wi, m.alpha_x, m.alpha_y);
    BsdfValue v;
    v.f_cos = iridescent_mirror_fresnel(m, min(lobe.cos_h, 1.0f)) * lobe.f_cos;
    v.pdf = lobe.pdf;
    return v;
}

BsdfSample iridescent_mirror_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wi = reflect(-wo, ggx_sample_vndf(wo, m.alpha_x, m.alpha_y, u));
    return bsdf_sample_of(wi, iridescent_mirror_eval(m, wo, wi), microfacet_lobe(m, 0u));
}

vec3 iridescent_mirror_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    return iridescent_mirror_fresnel(m, cos_o) * ggx_albedo(cos_o, mean_alpha(m)).white;
}

bool iridescent_mirror_is_specular(IN(BsdfParams) m) {
    return alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
