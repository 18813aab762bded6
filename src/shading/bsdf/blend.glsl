// Between two materials of one model: its parameters are blended, not what they reflect, so that a
// mask's grey makes a material of its own and the cost stays that of one.
// [Burley 2012, "Physically-Based Shading at Disney", 5.7]
#ifndef GP_SHADING_BSDF_BLEND_GLSL
#define GP_SHADING_BSDF_BLEND_GLSL
#include "shading/bsdf/params.glsl"

// t = 0: a, t = 1: b. Model, sidedness and choices must be the same in both; neither is prepared
// (bsdf_prepared).
BsdfParams bsdf_blended(IN(BsdfParams) a, IN(BsdfParams) b, float t) {
    BsdfParams m = a;
    m.base_color = mix(a.base_color, b.base_color, t);
    m.metallic = mix(a.metallic, b.metallic, t);
    m.alpha_x = mix(a.alpha_x, b.alpha_x, t);
    m.alpha_y = mix(a.alpha_y, b.alpha_y, t);
    m.ior = mix(a.ior, b.ior, t);
    m.specular = mix(a.specular, b.specular, t);
    m.specular_color = mix(a.specular_color, b.specular_color, t);
    m.coat = mix(a.coat, b.coat, t);
    m.coat_alpha = mix(a.coat_alpha, b.coat_alpha, t);
    m.sheen_color = mix(a.sheen_color, b.sheen_color, t);
    m.sheen_alpha = mix(a.sheen_alpha, b.sheen_alpha, t);
    m.transmission = mix(a.transmission, b.transmission, t);
    m.iridescence = mix(a.iridescence, b.iridescence, t);
    m.iridescence_ior = mix(a.iridescence_ior, b.iridescence_ior, t);
    m.iridescence_thickness_nm = mix(a.iridescence_thickness_nm, b.iridescence_thickness_nm, t);
    m.slot_a = mix(a.slot_a, b.slot_a, t);
    m.slot_b = mix(a.slot_b, b.slot_b, t);
    m.slot_c = mix(a.slot_c, b.slot_c, t);
    m.slot_d = mix(a.slot_d, b.slot_d, t);
    m.slot_e = mix(a.slot_e, b.slot_e, t);
    m.slot_f = mix(a.slot_f, b.slot_f, t);
    m.slot_g = mix(a.slot_g, b.slot_g, t);
    m.slot_h = mix(a.slot_h, b.slot_h, t);
    m.slot_i = mix(a.slot_i, b.slot_i, t);
    m.slot_j = mix(a.slot_j, b.slot_j, t);
    return m;
}

#endif
