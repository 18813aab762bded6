// The GGX microfacet lobes that several models share, without Fresnel: value times |cos_i| and the
// density of visible-normal sampling, for one reflection and for one refraction.
#ifndef GP_SHADING_BSDF_GGX_LOBE_GLSL
#define GP_SHADING_BSDF_GGX_LOBE_GLSL
#include "shading/microfacet/ggx.glsl"
#include "shading/bsdf/params.glsl"

struct GgxLobe {
    float f_cos;
    float pdf;
    float cos_h;  // between wo and the microfacet normal, for the Fresnel term
    float cos_t;  // between wi and that normal, on its side
};

// wo.z > 0 and wi.z > 0. With S the stretched lengths (ggx_stretched) the height-correlated
// D G2 / (4 cos_o cos_i) is D / (2 (cos_o S_i + cos_i S_o)), and G1 D / (4 cos_o), the density,
// is D / (2 (cos_o + S_o)). [Heitz 2014, JCGT 3(2), equation 99; Heitz 2018, equation 17]
GgxLobe ggx_reflection(vec3 wo, vec3 wi, float alpha_x, float alpha_y) {
    vec3 wm = normalize(wo + wi);
    float half_d = 0.5f * ggx_d(wm, alpha_x, alpha_y);
    float so = ggx_stretched(wo, alpha_x, alpha_y);
    float si = ggx_stretched(wi, alpha_x, alpha_y);
    GgxLobe lobe;
    lobe.f_cos = half_d * wi.z / (wo.z * si + wi.z * so);
    lobe.pdf = half_d / (wo.z + so);
    lobe.cos_h = dot(wo, wm);
    lobe.cos_t = lobe.cos_h;
    return lobe;
}

// wo.z > 0 and wi.z < 0, eta = index on wi's side over that on wo's side. Masking and shadowing
// lie on opposite sides of the surface, where heights are anti-correlated; the separable form is
// closest to that. [Walter et al. 2007, EGSR, equations 17 and 21, divided by eta^2 as radiance]
GgxLobe ggx_refraction(vec3 wo, vec3 wi, float alpha_x, float alpha_y, float eta) {
    GgxLobe lobe;
    lobe.f_cos = 0.0f;
    lobe.pdf = 0.0f;
    lobe.cos_h = 0.0f;
    lobe.cos_t = 0.0f;
    vec3 h = wo + eta * wi;
    float length_squared = dot(h, h);
    if (length_squared <= 0.0f) {
        return lobe;
    }
    vec3 wm = h * (h.z > 0.0f ? inversesqrt(length_squared) : -inversesqrt(length_squared));
    float cos_oh = dot(wo, wm);
    float cos_ih = dot(wi, wm);
    if (cos_oh <= 0.0f || cos_ih >= 0.0f) {
        return lobe;
    }
    float so = ggx_stretched(wo, alpha_x, alpha_y);
    float g1_i = -2.0f * wi.z / (ggx_stretched(wi, alpha_x, alpha_y) - wi.z);
    float root = cos_oh + eta * cos_ih;
    float visible = 2.0f * cos_oh * ggx_d(wm, alpha_x, alpha_y) / (wo.z + so);
    float jacobian_over_eta2 = -cos_ih / (root * root);
    lobe.f_cos = visible * g1_i * jacobian_over_eta2;
    lobe.pdf = visible * jacobian_over_eta2 * eta * eta;
    lobe.cos_h = cos_oh;
    lobe.cos_t = -cos_ih;
    return lobe;
}

#endif
