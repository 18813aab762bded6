// Shirley's coupled diffuse: the matte part below a smooth dielectric, which gets what the polished
// surface lets through on the way in and on the way out. The mirror reflection itself belongs to
// another lobe; with it a white surface reflects everything.
#ifndef GP_SHADING_BSDF_CLASSIC_SHIRLEY_GLSL
#define GP_SHADING_BSDF_CLASSIC_SHIRLEY_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// 1 - (1 - c)^5 integrates to 20 pi / 21 over the hemisphere, cosine included.
// [Shirley, Smits, Hu and Lafortune 1997, "A Practitioners' Assessment of Light Reflection Models"]
BsdfValue shirley_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    BsdfValue v;
    v.pdf = cosine_hemisphere_pdf(wi);
    float through = (1.0f - shirley_f0(m)) * schlick_through(wo.z) * schlick_through(wi.z);
    v.f_cos = m.base_color * (1.05f * through * v.pdf);
    return v;
}

BsdfSample shirley_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, shirley_eval(m, wo, wi), LOBE_DIFFUSE);
}

vec3 shirley_albedo(IN(BsdfParams) m, float cos_o) {
    float through = cos_o > 0.0f ? schlick_through(min(cos_o, 1.0f)) : 0.0f;
    return m.base_color * ((1.0f - shirley_f0(m)) * through);
}

bool shirley_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
