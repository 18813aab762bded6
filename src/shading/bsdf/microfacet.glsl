// Reflection by microfacets, D F G / (4 cos_o cos_i), with every distribution, masking and Fresnel
// term of the library in any combination. Which of them belong together is the user's to know: only
// with masking by V-cavities or by Smith's (of the same distribution) is no light gained.
#ifndef GP_SHADING_BSDF_MICROFACET_GLSL
#define GP_SHADING_BSDF_MICROFACET_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/facet_sampling.glsl"
#include "shading/microfacet/smith_quadrature.glsl"
#include "shading/bsdf/params.glsl"

// The order of the names in parameters.def; the first four are those of masking.glsl.
#define MASKING_CHOICE_NONE 4u
#define MASKING_CHOICE_IMPLICIT 5u
#define MASKING_CHOICE_SCHLICK 6u
#define MASKING_CHOICE_KELEMEN 7u
#define MASKING_CHOICE_NEUMANN 8u
#define MASKING_CHOICE_KURT 9u
#define MASKING_CHOICE_WARD 10u
#define MASKING_CHOICE_DUER 11u
#define MASKING_CHOICE_ASHIKHMIN_PREMOZE 12u
#define MASKING_CHOICE_ASHIKHMIN_SHIRLEY 13u
#define MASKING_CHOICE_DISNEY_2012 14u

#define FRESNEL_CHOICE_NONE 0u
#define FRESNEL_CHOICE_SCHLICK 1u
#define FRESNEL_CHOICE_SCHLICK_GENERALISED 2u
#define FRESNEL_CHOICE_DIELECTRIC 3u
#define FRESNEL_CHOICE_CONDUCTOR 4u

Distribution microfacet_normals(IN(BsdfParams) m) {
    Distribution d;
    d.kind = microfacet_distribution(m);
    d.alpha_x = m.alpha_x;
    d.alpha_y = m.alpha_y;
    d.shape = microfacet_shape(m);
    d.fit.low = m.slot_e;
    d.fit.high = m.slot_f;
    return d;
}

// With the numbers of Smith's masking, which the other functions read; again after each change of
// distribution, widths or shape.
BsdfParams microfacet_prepared(BsdfParams m) {
    SmithFit f = smith_fit_of(microfacet_normals(m));
    m.slot_e = f.low;
    m.slot_f = f.high;
    return m;
}

vec3 microfacet_reflectance(IN(BsdfParams) m, float cos_h) {
    switch (microfacet_fresnel(m)) {
    case FRESNEL_CHOICE_SCHLICK: return fresnel_schlick(m.base_color, vec3(1.0f), cos_h);
    case FRESNEL_CHOICE_SCHLICK_GENERALISED:
        return fresnel_schlick_generalised(m.base_color, microfacet_f90(m),
                                           microfacet_fresnel_exponent(m), cos_h);
    case FRESNEL_CHOICE_DIELECTRIC: return vec3(fresnel_dielectric(cos_h, m.ior));
    case FRESNEL_CHOICE_CONDUCTOR:
        return fresnel_conductor(cos_h, microfacet_eta(m), microfacet_k(m));
    default: break;
    }
    return vec3(1.0f);
}

float microfacet_lambda(IN(BsdfParams) m, IN(Distribution) d, vec3 w) {
    bool rational = d.kind == DISTRIBUTION_BECKMANN && microfacet_rational_lambda(m);
    return rational ? beckmann_lambda_rational(w, d.alpha_x, d.alpha_y)
                    : distribution_lambda(d, w);
}

float microfacet_masking_value(IN(BsdfParams) m, vec3 wo, vec3 wi, vec3 wm, float cos_h) {
    switch (microfacet_masking(m)) {
    case MASKING_V_CAVITY: return masking_v_cavity(wo.z, wi.z, wm.z, cos_h);
    case MASKING_CHOICE_IMPLICIT: return masking_implicit(wo.z, wi.z);
    case MASKING_CHOICE_SCHLICK: return masking_schlick(wo.z, wi.z, sqrt(m.alpha_x * m.alpha_y));
    case MASKING_CHOICE_KELEMEN: return masking_kelemen(wo.z, wi.z, cos_h);
    case MASKING_CHOICE_NEUMANN: return masking_neumann(wo.z, wi.z);
    case MASKING_CHOICE_KURT:
        return masking_kurt(wo.z, wi.z, cos_h, microfacet_kurt_exponent(m));
    case MASKING_CHOICE_WARD: return masking_ward(wo.z, wi.z);
    case MASKING_CHOICE_DUER: return masking_duer(wo.z, wi.z, wm.z, cos_h);
    case MASKING_CHOICE_ASHIKHMIN_PREMOZE: return masking_ashikhmin_premoze(wo.z, wi.z);
    case MASKING_CHOICE_ASHIKHMIN_SHIRLEY: return masking_ashikhmin_shirley(wo.z, wi.z, cos_h);
    case MASKING_CHOICE_DISNEY_2012: {
        float alpha = masking_disney_alpha(sqrt(sqrt(m.alpha_x * m.alpha_y)));
        return ggx_g2_separable(wo, wi, alpha, alpha);
    }
    default: break;
    }
    return 1.0f;
}

bool microfacet_is_smith(IN(BsdfParams) m) {
    return microfacet_masking(m) <= MASKING_VAN_GINNEKEN;
}

bool microfacet_samples_cavities(IN(BsdfParams) m) {
    return microfacet_masking(m) == MASKING_V_CAVITY;
}

// [Torrance and Sparrow 1967; Walter et al. 2007, EGSR, equation 20]
BsdfValue microfacet_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    Distribution d = microfacet_normals(m);
    vec3 h = wo + wi;
    float h_length = length(h);
    vec3 wm = h / h_length;
    // The same number for wo and wi exchanged, which a dot product is not at grazing angles.
    float cos_h = 0.5f * h_length;
    float d_value = distribution_d(d, wm);
    float g = microfacet_is_smith(m)
            ? masking_smith(microfacet_masking(m), microfacet_lambda(m, d, wo),
                            microfacet_lambda(m, d, wi), wo, wi)
            : microfacet_masking_value(m, wo, wi, wm, cos_h);
    BsdfValue v;
    v.f_cos = microfacet_reflectance(m, cos_h) * (0.25f * d_value * g / wo.z);
    v.pdf = facet_reflection_pdf(d, microfacet_samples_cavities(m), wo, wm, cos_h, d_value);
    // Far out in a tail one of the two may be rounded to 0 before the other.
    if (v.pdf <= 0.0f) {
        return bsdf_no_value();
    }
    return v;
}

bool microfacet_is_specular(IN(BsdfParams) m) {
    return distribution_has_short_tail(microfacet_distribution(m))
        && alpha_is_specular(m.alpha_x, m.alpha_y);
}

BsdfSample microfacet_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wm = facet_sample(microfacet_normals(m), microfacet_samples_cavities(m), wo, u_lobe, u);
    vec3 wi = reflect(-wo, wm);
    uint lobe = microfacet_is_specular(m) ? LOBE_SPECULAR : LOBE_GLOSSY;
    return bsdf_sample_of(wi, microfacet_eval(m, wo, wi), lobe);
}

// As for Beckmann's conductor: the smooth surface's, darkened by what one scattering loses.
vec3 microfacet_albedo(IN(BsdfParams) m, float cos_o) {
    float kept = 1.0f - 0.34f * min(mean_alpha(m), 1.0f);
    return cos_o > 0.0f ? kept * microfacet_reflectance(m, cos_o) : vec3(0.0f);
}

#endif
