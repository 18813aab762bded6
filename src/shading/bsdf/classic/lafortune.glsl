// Lafortune's generalised cosine lobe, above Lambert: Phong's lobe with a weight for each axis in
// the scalar product, so that it may lie off the mirror direction or point back. (-1, -1, 1) is the
// modified Phong model, (1, 1, 1) a retro-reflector. Conserves energy while the weights are at most
// 1 and the colors add up to at most 1.
#ifndef GP_SHADING_BSDF_CLASSIC_LAFORTUNE_GLSL
#define GP_SHADING_BSDF_CLASSIC_LAFORTUNE_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// The paper hides colour and normalisation in the weights, C = (specular (n + 2) / (2 pi))^(1/n);
// here they are apart. The length of the weighted direction is a factor of its own.
// [Lafortune, Foo, Torrance and Greenberg 1997, "Non-Linear Approximation of Reflectance
// Functions"]
PowerLobe lafortune_lobe(IN(BsdfParams) m, vec3 wo) {
    float n = lafortune_exponent(m);
    vec3 axis = vec3(lafortune_x(m) * wo.x, lafortune_y(m) * wo.y, lafortune_z(m) * wo.z);
    float l2 = dot(axis, axis);
    PowerLobe l;
    l.diffuse = m.base_color;
    // Weights above 1 to a power of 1,000 leave the range of floats.
    float gain = l2 > 0.0f ? exp(min(0.5f * n * log(l2), 60.0f)) : 0.0f;
    l.specular = m.specular_color * gain;
    l.axis = l2 > 0.0f ? axis * inversesqrt(l2) : vec3(0.0f, 0.0f, 1.0f);
    l.exponent = n;
    return l;
}

BsdfValue lafortune_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    return power_lobe_eval(lafortune_lobe(m, wo), wo, wi);
}

BsdfSample lafortune_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    return power_lobe_sample(lafortune_lobe(m, wo), wo, u_lobe, u);
}

// Towards the azimuth in which the lobe is strongest.
vec3 lafortune_albedo(IN(BsdfParams) m, float cos_o) {
    float r = sqrt(max(1.0f - cos_o * cos_o, 0.0f));
    bool along_x = abs(lafortune_x(m)) > abs(lafortune_y(m));
    vec3 wo = along_x ? vec3(r, 0.0f, cos_o) : vec3(0.0f, r, cos_o);
    return power_lobe_albedo(lafortune_lobe(m, wo), cos_o);
}

bool lafortune_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
