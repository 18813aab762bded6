// The modified Phong model: Lambert plus Phong's lobe as a reflectance that is reciprocal and, with
// base_color + specular_color at most 1, keeps energy.
#ifndef GP_SHADING_BSDF_CLASSIC_MODIFIED_PHONG_GLSL
#define GP_SHADING_BSDF_CLASSIC_MODIFIED_PHONG_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// [Lafortune and Willems 1994]
PowerLobe modified_phong_lobe(IN(BsdfParams) m, vec3 wo) {
    PowerLobe l;
    l.diffuse = m.base_color;
    l.specular = m.specular_color;
    l.axis = mirror_direction(wo);
    l.exponent = modified_phong_exponent(m);
    return l;
}

BsdfValue modified_phong_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    return power_lobe_eval(modified_phong_lobe(m, wo), wo, wi);
}

BsdfSample modified_phong_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    return power_lobe_sample(modified_phong_lobe(m, wo), wo, u_lobe, u);
}

vec3 modified_phong_albedo(IN(BsdfParams) m, float cos_o) {
    return power_lobe_albedo(modified_phong_lobe(m, vec3(0.0f, 0.0f, cos_o)), cos_o);
}

bool modified_phong_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
