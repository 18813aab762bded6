// D, F and G as the literature prints them, alone or multiplied, as a reflectance to look at: the
// functions of src/shading/microfacet that are no part of a whole model, and combinations with the
// divisors that papers and programs have used. What it shows need not be physical.
#ifndef GP_SHADING_BSDF_FORMULA_GLSL
#define GP_SHADING_BSDF_FORMULA_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/microfacet/blinn_phong.glsl"
#include "shading/microfacet/empirical.glsl"
#include "shading/microfacet/ggx.glsl"
#include "shading/microfacet/masking.glsl"
#include "shading/sampling/cosine_power.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// The order of the names in parameters.def.
#define FORMULA_D_BECKMANN 1u
#define FORMULA_D_GGX 2u
#define FORMULA_D_TROWBRIDGE_REITZ 3u
#define FORMULA_D_BLINN_PHONG 4u
#define FORMULA_D_PHONG 5u
#define FORMULA_D_GAUSSIAN 6u
#define FORMULA_D_EXPONENTIAL 7u
#define FORMULA_D_NISHINO 8u

#define FORMULA_F_SCHLICK 1u
#define FORMULA_F_DIELECTRIC 2u

#define FORMULA_G_V_CAVITY 1u
#define FORMULA_G_SMITH_GGX 2u
#define FORMULA_G_SCHLICK 3u
#define FORMULA_G_KELEMEN 4u
#define FORMULA_G_NEUMANN 5u
#define FORMULA_G_KURT 6u
#define FORMULA_G_WARD 7u
#define FORMULA_G_DUER 8u
#define FORMULA_G_ASHIKHMIN_PREMOZE 9u
#define FORMULA_G_ASHIKHMIN_SHIRLEY 10u

#define FORMULA_OVER_COSINES 1u
#define FORMULA_OVER_FOUR_COSINES 2u
#define FORMULA_OVER_PI_COSINES 3u
#define FORMULA_OVER_VIEWER 4u

// `normalized` is the factor that makes the projected area one, where the published form has the
// value one at the normal; of Phong's lobe that about the mirror direction.
float formula_distribution_value(IN(BsdfParams) m, vec3 wo, vec3 wi, vec3 wm) {
    float width = formula_width(m);
    float n = formula_exponent(m);
    bool normalized = formula_normalized(m);
    float power_norm = normalized ? (n + 2.0f) * INV_TWO_PI : 1.0f;
    switch (formula_distribution(m)) {
    case FORMULA_D_BECKMANN: return beckmann_d(wm, width, width);
    case FORMULA_D_GGX: return ggx_d(wm, width, width);
    case FORMULA_D_TROWBRIDGE_REITZ:
        return trowbridge_reitz_d(wm, width) * (normalized ? INV_PI / (width * width) : 1.0f);
    case FORMULA_D_BLINN_PHONG: return power_norm * height_power(wm, n);
    case FORMULA_D_PHONG:
        return power_norm * cosine_power(vec3(-wi.x, -wi.y, wi.z), wo, n);
    case FORMULA_D_GAUSSIAN: return gaussian_angle_d(wm, width);
    case FORMULA_D_EXPONENTIAL:
        return exponential_angle_d(wm, width)
             / (normalized ? exponential_angle_area(width) : 1.0f);
    case FORMULA_D_NISHINO: return nishino_d(wm.z, formula_kappa(m), n);
    default: break;
    }
    return 1.0f;
}

float formula_fresnel_value(IN(BsdfParams) m, float cos_h) {
    switch (formula_fresnel(m)) {
    case FORMULA_F_SCHLICK: return fresnel_schlick(formula_f0(m), 1.0f, cos_h);
    case FORMULA_F_DIELECTRIC: return fresnel_dielectric(cos_h, m.ior);
    default: break;
    }
    return 1.0f;
}

float formula_masking_value(IN(BsdfParams) m, vec3 wo, vec3 wi, float h, float cos_h) {
    float own_width = formula_masking_width(m);
    float width = own_width > 0.0f ? own_width : formula_width(m);
    switch (formula_masking(m)) {
    case FORMULA_G_V_CAVITY: return masking_v_cavity(wo.z, wi.z, h, cos_h);
    case FORMULA_G_SMITH_GGX: return ggx_g2_separable(wo, wi, width, width);
    case FORMULA_G_SCHLICK: return masking_schlick(wo.z, wi.z, width);
    case FORMULA_G_KELEMEN: return masking_kelemen(wo.z, wi.z, cos_h);
    case FORMULA_G_NEUMANN: return masking_neumann(wo.z, wi.z);
    case FORMULA_G_KURT: return masking_kurt(wo.z, wi.z, cos_h, formula_kurt_exponent(m));
    case FORMULA_G_WARD: return masking_ward(wo.z, wi.z);
    case FORMULA_G_DUER: return masking_duer(wo.z, wi.z, h, cos_h);
    case FORMULA_G_ASHIKHMIN_PREMOZE: return masking_ashikhmin_premoze(wo.z, wi.z);
    case FORMULA_G_ASHIKHMIN_SHIRLEY: return masking_ashikhmin_shirley(wo.z, wi.z, cos_h);
    default: break;
    }
    return 1.0f;
}

// Held at a cosine of 1e-6: most divisors have no limit at the horizon.
float formula_divided(IN(BsdfParams) m, float value, float cos_o, float cos_i) {
    float o = max(cos_o, 1.0e-6f);
    float i = max(cos_i, 1.0e-6f);
    switch (formula_divisor(m)) {
    case FORMULA_OVER_COSINES: return value / (o * i);
    case FORMULA_OVER_FOUR_COSINES: return value / (4.0f * o * i);
    case FORMULA_OVER_PI_COSINES: return value / (PI * o * i);
    case FORMULA_OVER_VIEWER: return value / o;
    default: break;
    }
    return value;
}

BsdfValue formula_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    vec3 sum = wo + wi;
    float sum_length = length(sum);
    vec3 wm = sum / sum_length;
    float cos_h = 0.5f * sum_length;
    float product = formula_scale(m) * formula_distribution_value(m, wo, wi, wm)
                  * formula_fresnel_value(m, cos_h)
                  * formula_masking_value(m, wo, wi, wm.z, cos_h);
    BsdfValue v;
    v.pdf = cosine_hemisphere_pdf(wi);
    v.f_cos = (m.base_color + vec3(formula_divided(m, product, wo.z, wi.z))) * wi.z;
    return v;
}

// By the cosine: it can be anything.
BsdfSample formula_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, formula_eval(m, wo, wi), LOBE_DIFFUSE);
}

vec3 formula_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? min(PI * m.base_color + vec3(formula_scale(m)), vec3(1.0f)) : vec3(0.0f);
}

bool formula_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
