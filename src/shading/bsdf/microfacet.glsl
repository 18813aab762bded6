// Reflection by microfacets, D F G / (4 cos_o cos_i), with every distribution, masking and Fresnel
// term of the library in any combination. Which of them belong together is the user's to know: only
// with masking by V-cavities or by Smith's (of the same distribution) is no light gained.
#ifndef GP_SHADING_BSDF_MICROFACET_GLSL
#define GP_SHADING_BSDF_MICROFACET_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/smith_quadrature.glsl"
#include "shading/bsdf/params.glsl"

// The order of the names in parameters.def.
#define MASKING_CHOICE_CORRELATED 0u
#define MASKING_CHOICE_SEPARABLE 1u
#define MASKING_CHOICE_VAN_GINNEKEN 2u
#define MASKING_CHOICE_V_CAVITY 3u
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

// Smith's masking; lambda_o is known already.
float microfacet_smith(IN(BsdfParams) m, IN(Distribution) d, vec3 wo, vec3 wi, float lambda_o) {
    float lambda_i = microfacet_lambda(m, d, wi);
    switch (microfacet_masking(m)) {
    case MASKING_CHOICE_SEPARABLE: return masking_separable(lambda_o, lambda_i);
    case MASKING_CHOICE_VAN_GINNEKEN:
        return masking_van_ginneken(lambda_o, lambda_i, azimuth_between(wo, wi));
    default: break;
    }
    return masking_correlated(lambda_o, lambda_i);
}

float microfacet_masking_value(IN(BsdfParams) m, vec3 wo, vec3 wi, vec3 wm, float cos_h) {
    switch (microfacet_masking(m)) {
    case MASKING_CHOICE_V_CAVITY: return masking_v_cavity(wo.z, wi.z, wm.z, cos_h);
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
    return microfacet_masking(m) <= MASKING_CHOICE_VAN_GINNEKEN;
}

// How normals are chosen: as wo sees them between V-cavities, as wo sees them on a surface of GGX
// or Beckmann, else without regard to wo.
bool microfacet_samples_cavities(IN(BsdfParams) m) {
    return microfacet_masking(m) == MASKING_CHOICE_V_CAVITY;
}

// The density of wi, from d_value = D at its half vector.
// [Walter et al. 2007, EGSR, equation 14; visible normals: Heitz and d'Eon 2014, EGSR, equation 2]
float microfacet_pdf(IN(BsdfParams) m, IN(Distribution) d, vec3 wo, vec3 wm, float cos_h,
                     float d_value) {
    if (microfacet_samples_cavities(m)) {
        // wm and its mirror image share their chance. [Heitz and d'Eon 2014, EGSR]
        float mirrored = max(dot(wo, vec3(-wm.x, -wm.y, wm.z)), 0.0f);
        return distribution_sample_pdf(d, wm) / (2.0f * (cos_h + mirrored));
    }
    if (d.kind == DISTRIBUTION_GGX) {
        return 0.5f * d_value / (wo.z + ggx_stretched(wo, d.alpha_x, d.alpha_y));
    }
    if (d.kind == DISTRIBUTION_BECKMANN) {
        return 0.25f * d_value * beckmann_g1(wo, d.alpha_x, d.alpha_y) / wo.z;
    }
    return distribution_sample_pdf(d, wm) / (4.0f * cos_h);
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
            ? microfacet_smith(m, d, wo, wi, microfacet_lambda(m, d, wo))
            : microfacet_masking_value(m, wo, wi, wm, cos_h);
    BsdfValue v;
    v.f_cos = microfacet_reflectance(m, cos_h) * (0.25f * d_value * g / wo.z);
    v.pdf = microfacet_pdf(m, d, wo, wm, cos_h, d_value);
    // Far out in a tail one of the two may be rounded to 0 before the other.
    if (v.pdf <= 0.0f) {
        return bsdf_no_value();
    }
    return v;
}

// A normal as wo sees them between grooves: seen from the side, one of the two slopes of a groove
// hides the other. [Heitz and d'Eon 2014, EGSR, "V-cavities"]
vec3 microfacet_sample_cavity(IN(Distribution) d, vec3 wo, float u_side, vec2 u) {
    vec3 wm = distribution_sample(d, u);
    vec3 mirrored = vec3(-wm.x, -wm.y, wm.z);
    float seen = max(dot(wo, wm), 0.0f);
    float mirrored_seen = max(dot(wo, mirrored), 0.0f);
    return u_side * (seen + mirrored_seen) < mirrored_seen ? mirrored : wm;
}

vec3 microfacet_sample_normal(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    Distribution d = microfacet_normals(m);
    if (microfacet_samples_cavities(m)) {
        return microfacet_sample_cavity(d, wo, u_lobe, u);
    }
    if (d.kind == DISTRIBUTION_GGX) {
        return ggx_sample_vndf(wo, d.alpha_x, d.alpha_y, u);
    }
    if (d.kind == DISTRIBUTION_BECKMANN) {
        return beckmann_sample_vndf(wo, d.alpha_x, d.alpha_y, u);
    }
    return distribution_sample(d, u);
}

// Long tails are no mirror, however narrow the peak.
bool microfacet_is_specular(IN(BsdfParams) m) {
    uint kind = microfacet_distribution(m);
    bool short_tail = kind <= DISTRIBUTION_BECKMANN || kind == DISTRIBUTION_BLINN_PHONG;
    return short_tail && alpha_is_specular(m.alpha_x, m.alpha_y);
}

BsdfSample microfacet_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wi = reflect(-wo, microfacet_sample_normal(m, wo, u_lobe, u));
    uint lobe = microfacet_is_specular(m) ? LOBE_SPECULAR : LOBE_GLOSSY;
    return bsdf_sample_of(wi, microfacet_eval(m, wo, wi), lobe);
}

// As for Beckmann's conductor: the smooth surface's, darkened by what one scattering loses.
vec3 microfacet_albedo(IN(BsdfParams) m, float cos_o) {
    float kept = 1.0f - 0.34f * min(mean_alpha(m), 1.0f);
    return cos_o > 0.0f ? kept * microfacet_reflectance(m, cos_o) : vec3(0.0f);
}

#endif
