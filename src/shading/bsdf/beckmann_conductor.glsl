// A metal with Gaussian slopes: Beckmann reflection, exact Smith masking, Schlick's Fresnel term.
#ifndef GP_SHADING_BSDF_BECKMANN_CONDUCTOR_GLSL
#define GP_SHADING_BSDF_BECKMANN_CONDUCTOR_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/bsdf/params.glsl"

// [Walter et al. 2007, EGSR, equation 20; masking: Heitz 2014, equation 99]
BsdfValue beckmann_conductor_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    vec3 wm = normalize(wo + wi);
    float d_over_4 = 0.25f * beckmann_d(wm, m.alpha_x, m.alpha_y) / wo.z;
    float lambda_o = beckmann_lambda(wo, m.alpha_x, m.alpha_y);
    float lambda_i = beckmann_lambda(wi, m.alpha_x, m.alpha_y);
    float g2 = 1.0f / (1.0f + lambda_o + lambda_i);
    BsdfValue v;
    v.f_cos = fresnel_schlick(m.base_color, vec3(1.0f), dot(wo, wm)) * (d_over_4 * g2);
    v.pdf = d_over_4 / (1.0f + lambda_o);
    return v;
}

BsdfSample beckmann_conductor_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wm = beckmann_sample_vndf(wo, m.alpha_x, m.alpha_y, u);
    vec3 wi = reflect(-wo, wm);
    return bsdf_sample_of(wi, beckmann_conductor_eval(m, wo, wi), microfacet_lobe(m, 0u));
}

// Single scattering loses little here: 0.66 of the light is left on average at alpha = 1, so the
// smooth surface's albedo, darkened linearly to that, is near enough for a guide.
vec3 beckmann_conductor_albedo(IN(BsdfParams) m, float cos_o) {
    float kept = 1.0f - 0.34f * min(mean_alpha(m), 1.0f);
    return cos_o > 0.0f ? kept * fresnel_schlick(m.base_color, vec3(1.0f), cos_o) : vec3(0.0f);
}

bool beckmann_conductor_is_specular(IN(BsdfParams) m) {
    return alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
