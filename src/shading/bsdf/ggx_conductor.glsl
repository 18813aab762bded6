// A metal: GGX reflection with Schlick's Fresnel term from base_color at normal incidence.
#ifndef GP_SHADING_BSDF_GGX_CONDUCTOR_GLSL
#define GP_SHADING_BSDF_GGX_CONDUCTOR_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/bsdf/ggx_lobe.glsl"

// [Walter et al. 2007, EGSR, equation 20; masking: Heitz 2014, equation 99]
BsdfValue ggx_conductor_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    GgxLobe lobe = ggx_reflection(wo, wi, m.alpha_x, m.alpha_y);
    BsdfValue v;
    v.f_cos = fresnel_schlick(m.base_color, vec3(1.0f), lobe.cos_h) * lobe.f_cos;
    v.pdf = lobe.pdf;
    return v;
}

BsdfSample ggx_conductor_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wm = ggx_sample_vndf(wo, m.alpha_x, m.alpha_y, u);
    vec3 wi = reflect(-wo, wm);
    return bsdf_sample_of(wi, ggx_conductor_eval(m, wo, wi), microfacet_lobe(m, 0u));
}

vec3 ggx_conductor_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    return ggx_albedo_fresnel(ggx_albedo(cos_o, mean_alpha(m)), m.base_color, vec3(1.0f));
}

bool ggx_conductor_is_specular(IN(BsdfParams) m) {
    return alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
