// Stretched Phong, a metal: Phong's lobe over the larger of the two cosines, which keeps it bright
// up to the horizon. Reciprocal; loses nothing seen from above, and gains a little in between
// ((n + 2) / (n + 1) at most, for power 1).
#ifndef GP_SHADING_BSDF_CLASSIC_STRETCHED_PHONG_GLSL
#define GP_SHADING_BSDF_CLASSIC_STRETCHED_PHONG_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// power 1 is the paper's; 0 is the modified Phong model.
// [Neumann, Neumann and Szirmay-Kalos 1999, "Compact Metallic Reflectance Models"]
BsdfValue stretched_phong_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    float n = stretched_phong_exponent(m);
    float power = cosine_power(mirror_direction(wo), wi, n);
    // A quotient first: a power of a tiny cosine would overflow.
    float high = max(wo.z, wi.z);
    float bent = pow(high, 1.0f - stretched_phong_power(m)) * (wi.z / high);
    BsdfValue v;
    v.f_cos = m.base_color * ((n + 2.0f) * INV_TWO_PI * power * bent);
    v.pdf = cosine_power_pdf(power, n);
    return v;
}

BsdfSample stretched_phong_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_power_about(mirror_direction(wo), u, stretched_phong_exponent(m));
    return bsdf_sample_of(wi, stretched_phong_eval(m, wo, wi), LOBE_GLOSSY);
}

vec3 stretched_phong_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? m.base_color * pow(cos_o, 1.0f - stretched_phong_power(m)) : vec3(0.0f);
}

bool stretched_phong_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
