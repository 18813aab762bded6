// Lambert: the same radiance in every direction.
#ifndef GP_SHADING_BSDF_LAMBERT_GLSL
#define GP_SHADING_BSDF_LAMBERT_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// [Lambert 1760, "Photometria"]
BsdfValue lambert_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    BsdfValue v;
    v.pdf = wo.z > 0.0f && wi.z > 0.0f ? wi.z * INV_PI : 0.0f;
    v.f_cos = m.base_color * v.pdf;
    return v;
}

BsdfSample lambert_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, lambert_eval(m, wo, wi), LOBE_DIFFUSE);
}

vec3 lambert_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? m.base_color : vec3(0.0f);
}

bool lambert_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
