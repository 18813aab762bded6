// Minnaert's law, made for the moon: Lambert with both cosines to a power. k = 1 is Lambert, below
// it the rim grows brighter, without a limit at grazing angles; the scale keeps the albedo at 1 for
// a view from above, so that from k = 1 on energy is kept.
#ifndef GP_SHADING_BSDF_CLASSIC_MINNAERT_GLSL
#define GP_SHADING_BSDF_CLASSIC_MINNAERT_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// [Minnaert 1941, "The Reciprocity Principle in Lunar Photometry", ApJ 93]
BsdfValue minnaert_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    float k = minnaert_k(m);
    BsdfValue v;
    v.pdf = cosine_power_pdf(height_power(wi, k), k);
    v.f_cos = m.base_color * (pow(max(wo.z, GRAZING_COSINE), k - 1.0f) * v.pdf);
    return v;
}

// In proportion to the value.
BsdfSample minnaert_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_power(u, minnaert_k(m));
    return bsdf_sample_of(wi, minnaert_eval(m, wo, wi), LOBE_DIFFUSE);
}

vec3 minnaert_albedo(IN(BsdfParams) m, float cos_o) {
    float c = max(cos_o, GRAZING_COSINE);
    return cos_o > 0.0f ? m.base_color * pow(c, minnaert_k(m) - 1.0f) : vec3(0.0f);
}

bool minnaert_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
