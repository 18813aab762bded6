// Kelemen and Szirmay-Kalos' coupled matte and specular reflection: Beckmann facets whose masking
// is replaced by the one factor that keeps the albedo below 1, and below them a matte part that
// gets what they do not reflect. The paper tabulates the albedo of the facets; here it is a fit.
#ifndef GP_SHADING_BSDF_CLASSIC_KELEMEN_GLSL
#define GP_SHADING_BSDF_CLASSIC_KELEMEN_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/microfacet/multiple_scattering.glsl"
#include "shading/bsdf/classic/lobes.glsl"

// Albedo of the facets with F = 1, and weighted by (1 - cos_h)^5: our own fits to quadratures of
// 28,800 half vectors at 25 widths from 0.005 on and 54 cosines from 0.002 on. Errors: 0.0046 and
// 0.0035.
GgxAlbedo kelemen_albedo_terms(float cos_o, float alpha) {
    float a = max(alpha, 0.005f);
    float v = cos_o / (cos_o + a);
    float w0 = 0.964219f + a * (0.15512f + a * (-0.229051f + a * 0.101702f));
    float w1 = -0.770368f + a * (-4.1013f + a * (3.58806f - a * 1.58152f));
    float w2 = 0.669058f + a * (28.975f + a * (-25.1244f + a * 5.93539f));
    float w3 = 0.841289f + a * (-79.6183f + a * (44.8819f + a * 6.14883f));
    float w4 = -0.146944f + a * (91.8884f + a * (-17.2462f - a * 36.8961f));
    float w5 = -0.5609f + a * (-37.6944f + a * (-6.42039f + a * 22.5485f));
    float r = sqrt(a);
    float s = sqrt(cos_o);
    float q0 = 0.996775f + r * (0.0249367f + r * (-0.662847f
             + r * (0.330393f + r * 0.0610542f)));
    float q1 = 0.0601924f + r * (-0.20926f + r * (-2.91871f + r * (7.47681f - r * 4.65469f)));
    float q2 = -1.65033f + r * (9.8797f + r * (-21.7822f + r * (12.3377f + r * 0.962533f)));
    float q3 = 1.43904f + r * (-27.8847f + r * (96.6146f + r * (-112.94f + r * 42.789f)));
    float q4 = -0.868894f + r * (20.0426f + r * (-80.4696f + r * (108.372f - r * 47.2372f)));
    float q = clamp(q0 + s * (q1 + s * (q2 + s * (q3 + s * q4))), 0.0f, 1.0f);
    GgxAlbedo e;
    e.white = clamp(w0 + v * (w1 + v * (w2 + v * (w3 + v * (w4 + v * w5)))), 0.0f, 1.0f);
    e.schlick = e.white * (q * q) * (q * q) * q;
    return e;
}

// Their averages over the hemisphere, weighted by the cosine. Errors: 0.0023 and 0.0008.
GgxAlbedo kelemen_albedo_average(float a) {
    GgxAlbedo e;
    e.white = 1.003167f + a * (-0.1990401f + a * (-1.466359f + a * (1.897423f - a * 0.7492253f)));
    e.white = min(e.white, 1.0f);
    e.schlick = 0.04882406f + a * (-0.1105068f + a * (0.1045211f
              + a * (-0.02580155f - a * 0.009334948f)));
    return e;
}

// What the facets let through to the matte part.
vec3 kelemen_through(IN(BsdfParams) m, GgxAlbedo e) {
    return max(vec3(1.0f) - ggx_albedo_fresnel(e, m.specular_color, vec3(1.0f)), vec3(0.0f));
}

// (1 - E(o)) (1 - E(i)) over (1 - E_avg) pi. Where nearly all is reflected the errors of the fits
// are more than what is left; the limit keeps their quotient small.
// [Kelemen and Szirmay-Kalos 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model with
// Importance Sampling"]
vec3 kelemen_matte(IN(BsdfParams) m, vec3 through_o, float cos_i) {
    vec3 through_i = kelemen_through(m, kelemen_albedo_terms(cos_i, m.alpha_x));
    vec3 average = max(kelemen_through(m, kelemen_albedo_average(m.alpha_x)), vec3(0.02f));
    return coupled_diffuse(m.base_color, through_o, through_i, average);
}

float kelemen_share(IN(BsdfParams) m, vec3 through_o) {
    float facets = max_component(vec3(1.0f) - through_o);
    return lobe_share(facets, max_component(m.base_color * through_o));
}

// P F / (2 (1 + wo wi)) with P Beckmann's distribution, and the matte part.
// [Kelemen and Szirmay-Kalos 2001]
BsdfValue kelemen_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    HalfVector h = half_vector(wo, wi);
    float d = beckmann_d(h.wm, m.alpha_x, m.alpha_x);
    vec3 through_o = kelemen_through(m, kelemen_albedo_terms(wo.z, m.alpha_x));
    float p = kelemen_share(m, through_o);
    vec3 f = fresnel_schlick(m.specular_color, vec3(1.0f), h.cos_h);
    BsdfValue v;
    v.f_cos = (f * (d / h.sum2) + kelemen_matte(m, through_o, wi.z)) * wi.z;
    v.pdf = p * reflection_pdf(d * h.wm.z, h.cos_h) + (1.0f - p) * cosine_hemisphere_pdf(wi);
    return v;
}

BsdfSample kelemen_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 through_o = kelemen_through(m, kelemen_albedo_terms(wo.z, m.alpha_x));
    bool glossy = u_lobe < kelemen_share(m, through_o);
    vec3 wi = glossy ? reflect(-wo, beckmann_sample_d(u, m.alpha_x, m.alpha_x))
                     : square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, kelemen_eval(m, wo, wi), glossy ? LOBE_GLOSSY : LOBE_DIFFUSE);
}

vec3 kelemen_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    vec3 through = kelemen_through(m, kelemen_albedo_terms(min(cos_o, 1.0f), m.alpha_x));
    return vec3(1.0f) - through + m.base_color * through;
}

bool kelemen_is_specular(IN(BsdfParams) m) {
    return m.base_color == vec3(0.0f) && alpha_is_specular(m.alpha_x, m.alpha_x);
}

#endif
