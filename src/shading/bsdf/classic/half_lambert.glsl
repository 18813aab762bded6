// Half-Lambert, "wrap" lighting: the cosine is lifted before it is used, so that the dark side of
// an object keeps some shape. No physical reflectance: more light leaves than comes (albedo 7/6 for
// Valve's values), and light grows where cos_i does not. Light from behind stays outside, since the
// surface hides it. wrap 0, exponent 1 is Lambert.
#ifndef GP_SHADING_BSDF_CLASSIC_HALF_LAMBERT_GLSL
#define GP_SHADING_BSDF_CLASSIC_HALF_LAMBERT_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// From here on the lifted cosine is near enough to a constant to be sampled as one; the inverse of
// its integral would cancel.
#define HALF_LAMBERT_FLAT_WRAP 0.98f

// What replaces the cosine. [Mitchell, McTaggart and Green 2006, "Shading in Valve's Source
// Engine", "Half Lambert": wrap 1/2, exponent 2]
float half_lambert_shade(IN(BsdfParams) m, float cos_i) {
    float wrap = half_lambert_wrap(m);
    return pow(max(cos_i + wrap * (1.0f - cos_i), 0.0f), half_lambert_exponent(m));
}

// The integral of that over the hemisphere, over 2 pi.
float half_lambert_mean(IN(BsdfParams) m) {
    float wrap = half_lambert_wrap(m);
    float n = half_lambert_exponent(m) + 1.0f;
    return wrap > HALF_LAMBERT_FLAT_WRAP ? 1.0f : (1.0f - pow(wrap, n)) / ((1.0f - wrap) * n);
}

BsdfValue half_lambert_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    float shade = half_lambert_shade(m, wi.z);
    bool flat_lobe = half_lambert_wrap(m) > HALF_LAMBERT_FLAT_WRAP;
    BsdfValue v;
    v.f_cos = m.base_color * (INV_PI * shade);
    v.pdf = INV_TWO_PI * (flat_lobe ? 1.0f : shade / half_lambert_mean(m));
    return v;
}

// In proportion to the value.
BsdfSample half_lambert_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    float wrap = half_lambert_wrap(m);
    float n = half_lambert_exponent(m) + 1.0f;
    vec3 wi = square_to_uniform_hemisphere(u);
    if (wrap <= HALF_LAMBERT_FLAT_WRAP) {
        float lowest = pow(wrap, n);
        float lifted = pow(mix(lowest, 1.0f, u.x), 1.0f / n);
        float z = clamp((lifted - wrap) / (1.0f - wrap), 0.0f, 1.0f);
        wi = direction_from_height(z, TWO_PI * u.y);
    }
    return bsdf_sample_of(wi, half_lambert_eval(m, wo, wi), LOBE_DIFFUSE);
}

vec3 half_lambert_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? 2.0f * half_lambert_mean(m) * m.base_color : vec3(0.0f);
}

bool half_lambert_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
