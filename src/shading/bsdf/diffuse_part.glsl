// The diffuse part of a reflectance, which a denoiser treats by itself: the lobe that depends on
// the view only by a factor, so that light over albedo is the same for all viewers.
#ifndef GP_SHADING_BSDF_DIFFUSE_PART_GLSL
#define GP_SHADING_BSDF_DIFFUSE_PART_GLSL
#include "shading/bsdf/bsdf.glsl"

// Whether f is its diffuse part and nothing else.
bool bsdf_is_diffuse(IN(BsdfParams) m) {
    return m.model == MODEL_LAMBERT;
}

// f |cos_i| of the diffuse lobe; the rest of bsdf_eval is never negative. Models of the library
// count as a whole as not diffuse.
vec3 bsdf_diffuse_part(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (m.model == MODEL_LAMBERT) {
        return lambert_eval(m, wo, wi).f_cos;
    }
    return m.model == MODEL_GLTF ? gltf_diffuse_part(m, wo, wi) : vec3(0.0f);
}

// How much of uniform light the diffuse lobe returns, about: zero where there is none.
vec3 bsdf_diffuse_albedo(IN(BsdfParams) m, float cos_o) {
    if (m.model == MODEL_LAMBERT) {
        return m.base_color;
    }
    return m.model == MODEL_GLTF ? gltf_diffuse_albedo(m, cos_o) : vec3(0.0f);
}

#endif
