// A clear sheet, thin against its lateral extent: light leaves it where it entered. Between the two
// faces it goes back and forth; the sum of all these ways is taken in closed form. base_color tints
// what goes through.
#ifndef GP_SHADING_BSDF_THIN_DIELECTRIC_GLSL
#define GP_SHADING_BSDF_THIN_DIELECTRIC_GLSL
#include "shading/fresnel.glsl"
#include "shading/bsdf/ggx_dielectric.glsl"

// F + (1 - F)^2 F (1 + F^2 + F^4 + …) = 2 F / (1 + F).
// [Born and Wolf 1999, "Principles of Optics", section 7.6, incoherent sum]
float thin_reflectance(float cos_h, float eta) {
    float f = fresnel_dielectric(cos_h, eta);
    return 2.0f * f / (1.0f + f);
}

// Roughness blurs the transmitted light as it does the reflected: the same lobe, mirrored.
BsdfValue thin_dielectric_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z == 0.0f || wi.z == 0.0f) {
        return bsdf_no_value();
    }
    bool transmits = (wo.z > 0.0f) != (wi.z > 0.0f);
    vec3 o = vec3(wo.x, wo.y, abs(wo.z));
    vec3 i = vec3(wi.x, wi.y, abs(wi.z));
    GgxLobe lobe = ggx_reflection(o, i, m.alpha_x, m.alpha_y);
    float r = thin_reflectance(lobe.cos_h, relative_ior(m.ior, 1.0f));
    float share = transmits ? 1.0f - r : r;
    BsdfValue v;
    v.f_cos = (transmits ? m.base_color : vec3(1.0f)) * (share * lobe.f_cos);
    v.pdf = share * lobe.pdf;
    return v;
}

BsdfSample thin_dielectric_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z == 0.0f) {
        return bsdf_no_sample();
    }
    vec3 o = vec3(wo.x, wo.y, abs(wo.z));
    vec3 wm = ggx_sample_vndf(o, m.alpha_x, m.alpha_y, u);
    vec3 i = reflect(-o, wm);
    if (i.z <= 0.0f) {
        return bsdf_no_sample();
    }
    bool transmits = u_lobe >= thin_reflectance(dot(o, wm), relative_ior(m.ior, 1.0f));
    vec3 wi = transmits != (wo.z < 0.0f) ? mirrored_z(i) : i;
    uint lobe = microfacet_lobe(m, transmits ? LOBE_TRANSMISSION : 0u);
    return bsdf_sample_of(wi, thin_dielectric_eval(m, wo, wi), lobe);
}

vec3 thin_dielectric_albedo(IN(BsdfParams) m, float cos_o) {
    float r = thin_reflectance(abs(cos_o), relative_ior(m.ior, 1.0f));
    return vec3(r) + m.base_color * (1.0f - r);
}

bool thin_dielectric_is_specular(IN(BsdfParams) m) {
    return alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
