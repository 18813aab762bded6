// Textures of what glTF's material and glints both have: coat, sheen, transmission and a thin film.
// Resources: those of shading_point.glsl.
#ifndef GP_KERNELS_LAYER_TEXTURES_GLSL
#define GP_KERNELS_LAYER_TEXTURES_GLSL
#include "kernels/shading_point.glsl"

#define SLOTS_OF_LAYERS                                                              \
    (SLOT_COAT | SLOT_COAT_ROUGHNESS | SLOT_SHEEN_COLOR | SLOT_SHEEN_ROUGHNESS |     \
     SLOT_TRANSMISSION | SLOT_IRIDESCENCE | SLOT_IRIDESCENCE_THICKNESS)

// A width whose roughness is a texel's share of what it was.
float alpha_with_roughness(float alpha, float share) {
    return max(alpha * share * share, BSDF_MIN_ALPHA);
}

// Over their factors, which are in b already.
// [KHR_materials_clearcoat, _sheen, _transmission, _iridescence: each factor times its channel]
BsdfParams layers_textured(BsdfParams b, IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    if ((m.textures & SLOT_COAT) != 0u) { b.coat *= read_slot(m.coat_slot, s, u_lod).x; }
    if ((m.textures & SLOT_COAT_ROUGHNESS) != 0u) {
        b.coat_alpha = alpha_with_roughness(
            b.coat_alpha, read_slot(m.coat_roughness_slot, s, u_lod).y);
    }
    if ((m.textures & SLOT_SHEEN_COLOR) != 0u) {
        b.sheen_color *= vec3(read_slot(m.sheen_color_slot, s, u_lod));
    }
    if ((m.textures & SLOT_SHEEN_ROUGHNESS) != 0u) {
        b.sheen_alpha = alpha_with_roughness(
            b.sheen_alpha, read_slot(m.sheen_roughness_slot, s, u_lod).w);
    }
    if ((m.textures & SLOT_TRANSMISSION) != 0u) {
        b.transmission *= read_slot(m.transmission_slot, s, u_lod).x;
    }
    if ((m.textures & SLOT_IRIDESCENCE) != 0u) {
        b.iridescence *= read_slot(m.iridescence_slot, s, u_lod).x;
    }
    if ((m.textures & SLOT_IRIDESCENCE_THICKNESS) != 0u) {
        b.iridescence_thickness_nm =
            mix(m.iridescence_thickness_min_nm, m.iridescence_thickness_max_nm,
                read_slot(m.iridescence_thickness_slot, s, u_lod).y);
    }
    return b;
}

// The normal of the coat, of its map or of the surface as it is, on the side that p.frame faces;
// in the world. keep: of a solid body's outside.
vec3 coat_normal_of(IN(MaterialRecord) m, IN(Surface) s, bool keep, float u_lod) {
    vec3 n = s.frame.n;
    if ((m.textures & SLOT_COAT_NORMAL) != 0u) {
        n = world_from_local(
            s.frame, read_normal(m.coat_normal_slot, s, m.coat_normal_scale, u_lod));
    }
    return s.front == 0u && !keep ? -n : n;
}

#endif
