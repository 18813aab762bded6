// A rough metal that loses nothing: one reflection at a microfacet, and what is reflected twice and
// more as a wide lobe beside it.
#ifndef GP_SHADING_BSDF_KULLA_CONTY_GLSL
#define GP_SHADING_BSDF_KULLA_CONTY_GLSL
#include "shading/fresnel.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/microfacet/multiple_scattering.glsl"
#include "shading/bsdf/ggx_lobe.glsl"

ScatteringLoss kulla_conty_losses(IN(BsdfParams) m) {
    ScatteringLoss l;
    l.surface = kulla_conty_mirror(m);
    l.alpha = m.alpha_x;
    l.average = m.slot_a.z;
    l.low = m.slot_b;
    l.middle = m.slot_c;
    l.high = m.slot_d;
    return l;
}

// With the losses, which the other functions read; again after each change of mirror or width.
BsdfParams kulla_conty_prepared(BsdfParams m) {
    ScatteringLoss l = scattering_loss_of(kulla_conty_mirror(m), m.alpha_x);
    m.slot_a.z = l.average;
    m.slot_b = l.low;
    m.slot_c = l.middle;
    m.slot_d = l.high;
    return m;
}

bool rough_mirror_is_beckmann(uint surface) {
    return surface >= ROUGH_MIRROR_BECKMANN_SEPARABLE;
}

// One reflection with F = 1; wo.z > 0 and wi.z > 0. [Walter et al. 2007, EGSR, equation 20]
GgxLobe rough_mirror_reflection(uint surface, vec3 wo, vec3 wi, float alpha) {
    GgxLobe lobe = ggx_reflection(wo, wi, alpha, alpha);
    if (surface == ROUGH_MIRROR_GGX_CORRELATED) {
        return lobe;
    }
    if (surface == ROUGH_MIRROR_GGX_SEPARABLE) {
        // The density is that of visible normals, G1(o) D / (4 cos_o); G1(i) makes it the value.
        lobe.f_cos = lobe.pdf * ggx_g1(wi, alpha, alpha);
        return lobe;
    }
    vec3 wm = normalize(wo + wi);
    float g1 = beckmann_g1(wo, alpha, alpha);
    lobe.pdf = 0.25f * g1 * beckmann_d(wm, alpha, alpha) / wo.z;
    float g2 = surface == ROUGH_MIRROR_BECKMANN_SEPARABLE
        ? beckmann_g2_separable(wo, wi, alpha, alpha)
        : beckmann_g2_correlated(wo, wi, alpha, alpha);
    lobe.f_cos = lobe.pdf * (g2 / g1);
    return lobe;
}

// The probability of the wide lobe: what it returns for a white metal.
float kulla_conty_wide_share(IN(BsdfParams) m, float loss_o) {
    return kulla_conty_multiple(m) ? loss_o : 0.0f;
}

// [Kulla and Conty 2017]
BsdfValue kulla_conty_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    uint surface = kulla_conty_mirror(m);
    GgxLobe lobe = rough_mirror_reflection(surface, wo, wi, m.alpha_x);
    BsdfValue v;
    v.f_cos = fresnel_schlick(m.base_color, vec3(1.0f), lobe.cos_h) * lobe.f_cos;
    v.pdf = lobe.pdf;
    if (!kulla_conty_multiple(m)) {
        return v;
    }
    ScatteringLoss losses = kulla_conty_losses(m);
    float loss_o = scattering_loss(losses, wo.z);
    float loss_i = scattering_loss(losses, wi.z);
    vec3 f_average = fresnel_schlick_average(m.base_color, vec3(1.0f));
    v.f_cos += multiple_scattering_color(f_average, losses.average)
             * (multiple_scattering(loss_o, loss_i, losses.average) * wi.z);
    float wide = kulla_conty_wide_share(m, loss_o);
    v.pdf = mix(v.pdf, cosine_hemisphere_pdf(wi), wide);
    return v;
}

BsdfSample kulla_conty_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    uint surface = kulla_conty_mirror(m);
    float loss_o = scattering_loss(kulla_conty_losses(m), wo.z);
    if (u_lobe < kulla_conty_wide_share(m, loss_o)) {
        vec3 wi = square_to_cosine_hemisphere(u);
        return bsdf_sample_of(wi, kulla_conty_eval(m, wo, wi), LOBE_DIFFUSE);
    }
    vec3 wm = rough_mirror_is_beckmann(surface) ? beckmann_sample_vndf(wo, m.alpha_x, m.alpha_x, u)
                                                : ggx_sample_vndf(wo, m.alpha_x, m.alpha_x, u);
    vec3 wi = reflect(-wo, wm);
    bool narrow = alpha_is_specular(m.alpha_x, m.alpha_x);
    return bsdf_sample_of(wi, kulla_conty_eval(m, wo, wi), narrow ? LOBE_SPECULAR : LOBE_GLOSSY);
}

vec3 kulla_conty_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    ScatteringLoss losses = kulla_conty_losses(m);
    float loss = scattering_loss(losses, cos_o);
    vec3 f_average = fresnel_schlick_average(m.base_color, vec3(1.0f));
    vec3 wide = multiple_scattering_color(f_average, losses.average);
    // Schlick's term where most light meets the microfacets: at their own angles for a rough
    // surface, at the view's for a smooth one.
    vec3 one = mix(fresnel_schlick(m.base_color, vec3(1.0f), cos_o), f_average, loss);
    return one * (1.0f - loss) + kulla_conty_wide_share(m, loss) * wide;
}

bool kulla_conty_is_specular(IN(BsdfParams) m) {
    return alpha_is_specular(m.alpha_x, m.alpha_x);
}

#endif
