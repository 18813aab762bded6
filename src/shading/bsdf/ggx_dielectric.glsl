// The rough boundary of a solid clear body: reflection and refraction, exact Fresnel term, loses
// only what single scattering loses. base_color tints what goes through.
#ifndef GP_SHADING_BSDF_GGX_DIELECTRIC_GLSL
#define GP_SHADING_BSDF_GGX_DIELECTRIC_GLSL
#include "shading/fresnel.glsl"
#include "shading/bsdf/ggx_lobe.glsl"

// The index behind the surface over the one in front of it, seen from wo's side.
float relative_ior(float ior, float cos_o) {
    float away = abs(ior - 1.0f) < BSDF_MIN_IOR_STEP ? 1.0f + BSDF_MIN_IOR_STEP : ior;
    return cos_o > 0.0f ? away : 1.0f / away;
}

// [Walter et al. 2007, EGSR, equations 20 and 21]
BsdfValue ggx_dielectric_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    BsdfValue v = bsdf_no_value();
    if (wo.z == 0.0f || wi.z == 0.0f) {
        return v;
    }
    float eta = relative_ior(m.ior, wo.z);
    // The distribution of normals is the same from both sides; look from above.
    bool flip = wo.z < 0.0f;
    vec3 o = flip ? mirrored_z(wo) : wo;
    vec3 i = flip ? mirrored_z(wi) : wi;
    if (i.z > 0.0f) {
        GgxLobe lobe = ggx_reflection(o, i, m.alpha_x, m.alpha_y);
        float f = fresnel_dielectric(lobe.cos_h, eta);
        v.f_cos = vec3(f * lobe.f_cos);
        v.pdf = f * lobe.pdf;
        return v;
    }
    GgxLobe lobe = ggx_refraction(o, i, m.alpha_x, m.alpha_y, eta);
    if (lobe.pdf <= 0.0f) {
        return v;
    }
    float t = fresnel_transmittance(lobe.cos_h, lobe.cos_t, eta);
    v.f_cos = m.base_color * (t * lobe.f_cos);
    v.pdf = t * lobe.pdf;
    return v;
}

BsdfSample ggx_dielectric_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z == 0.0f) {
        return bsdf_no_sample();
    }
    float eta = relative_ior(m.ior, wo.z);
    bool flip = wo.z < 0.0f;
    vec3 o = flip ? mirrored_z(wo) : wo;
    vec3 wm = ggx_sample_vndf(o, m.alpha_x, m.alpha_y, u);
    float cos_h = dot(o, wm);
    bool reflects = u_lobe < fresnel_dielectric(cos_h, eta);
    vec3 i = reflects ? reflect(-o, wm) : refracted(o, wm, eta, fresnel_g(cos_h, eta));
    // A normal that is nearly edge-on can send the light to the wrong side: lost.
    if ((i.z > 0.0f) != reflects) {
        return bsdf_no_sample();
    }
    vec3 wi = flip ? mirrored_z(i) : i;
    uint lobe = microfacet_lobe(m, reflects ? 0u : LOBE_TRANSMISSION);
    return bsdf_sample_of(wi, ggx_dielectric_eval(m, wo, wi), lobe);
}

// Reflected plus transmitted, as if the surface were smooth.
vec3 ggx_dielectric_albedo(IN(BsdfParams) m, float cos_o) {
    float f = fresnel_dielectric(abs(cos_o), relative_ior(m.ior, cos_o));
    return vec3(f) + m.base_color * (1.0f - f);
}

bool ggx_dielectric_is_specular(IN(BsdfParams) m) {
    return alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
