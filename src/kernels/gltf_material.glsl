// The glTF material at one point: textures read, everything multiplied out.
#ifndef GP_KERNELS_GLTF_MATERIAL_GLSL
#define GP_KERNELS_GLTF_MATERIAL_GLSL
#include "kernels/layer_textures.glsl"
#include "kernels/material_slopes.glsl"

float alpha_from_roughness(float roughness) {
    return max(roughness * roughness, BSDF_MIN_ALPHA);
}

// [KHR_materials_specular: each factor times its channel]
BsdfParams read_layers(BsdfParams b, IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    if ((m.textures & SLOT_SPECULAR) != 0u) {
        b.specular *= read_slot(m.specular_slot, s, u_lod).w;
    }
    if ((m.textures & SLOT_SPECULAR_COLOR) != 0u) {
        b.specular_color *= vec3(read_slot(m.specular_color_slot, s, u_lod));
    }
    b.coat_alpha = alpha_from_roughness(m.coat_roughness);
    b.sheen_alpha = alpha_from_roughness(m.sheen_roughness);
    b.iridescence_thickness_nm = m.iridescence_thickness_max_nm;
    return layers_textured(b, m, s, u_lod);
}

// The tangent turned by the anisotropy's direction, and the two widths.
// [KHR_materials_anisotropy, "Individual lobes": alpha along the tangent mixes towards 1]
ShadingPoint apply_anisotropy(ShadingPoint p, IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    float strength = m.anisotropy;
    vec2 direction = vec2(cos(m.anisotropy_rotation), sin(m.anisotropy_rotation));
    if ((m.textures & SLOT_ANISOTROPY) != 0u) {
        vec4 texel = read_slot(m.anisotropy_slot, s, u_lod);
        vec2 d = vec2(texel.x * 2.0f - 1.0f, texel.y * 2.0f - 1.0f);
        direction =
            vec2(d.x * direction.x - d.y * direction.y, d.x * direction.y + d.y * direction.x);
        strength *= texel.z;
    }
    p.frame = turned_frame(p.frame, direction);
    p.bsdf.alpha_x = mix(p.bsdf.alpha_x, 1.0f, strength * strength);
    return p;
}

// Everything that a material has. One variable is filled, field by field, and returned: a copy of
// BsdfParams would move the slots of the library's models as well, which are not set here.
ShadingPoint gltf_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, vec3 base, vec3 emission,
                        float u_lod) {
    float metallic = m.metallic;
    float roughness = m.roughness;
    if ((m.textures & SLOT_METALLIC_ROUGHNESS) != 0u) {
        vec4 texel = read_slot(m.metallic_roughness_slot, s, u_lod);
        roughness *= texel.y;
        metallic *= texel.z;
    }
    ShadingPoint p;
    // Without reflection at its surface the material is its diffuse base alone.
    bool matte = (m.flags & MATERIAL_MATTE) != 0u;
    p.bsdf.model = matte ? MODEL_LAMBERT : m.model;
    p.bsdf.base_color = base;
    p.bsdf.metallic = metallic;
    p.bsdf.alpha_x = alpha_from_roughness(roughness);
    p.bsdf.alpha_y = p.bsdf.alpha_x;
    p.bsdf.ior = m.ior;
    p.bsdf.specular = m.specular;
    p.bsdf.specular_color = m.specular_color;
    p.bsdf.coat = m.coat;
    p.bsdf.coat_alpha = BSDF_MIN_ALPHA;
    p.bsdf.coat_normal = vec3(0.0f, 0.0f, 1.0f);
    p.bsdf.sheen_color = m.sheen_color;
    p.bsdf.sheen_alpha = BSDF_MIN_ALPHA;
    p.bsdf.transmission = m.transmission;
    p.bsdf.thin = (m.flags & MATERIAL_SOLID) != 0u ? 0u : 1u;
    p.bsdf.iridescence = m.iridescence;
    p.bsdf.iridescence_ior = m.iridescence_ior;
    p.bsdf.iridescence_thickness_nm = 400.0f;  // of no effect without a film, which is a layer
    if ((m.flags & MATERIAL_LAYERED) != 0u) { p.bsdf = read_layers(p.bsdf, m, s, u_lod); }
    p.frame = mapped_frame(m, s, u_lod);
    p.emission = emission;
    p.attenuation = m.attenuation;
    p.flags = m.flags;
    if (m.anisotropy > 0.0f) { p = apply_anisotropy(p, m, s, u_lod); }
    if (has_slope_maps(m)) {
        SlopedShape shape =
            sloped_shape(m, s, wo, p.frame, p.bsdf.alpha_x, p.bsdf.alpha_y);
        p.frame = shape.frame;
        p.bsdf.alpha_x = shape.alpha_x;
        p.bsdf.alpha_y = shape.alpha_y;
    }
    bool solid = (m.flags & (MATERIAL_SOLID | MATERIAL_TRANSMISSIVE)) ==
                 (MATERIAL_SOLID | MATERIAL_TRANSMISSIVE);
    p.frame = face_viewer(s, p.frame, wo, solid);
    if (m.coat > 0.0f) {
        p.bsdf.coat_normal = local_from_world(p.frame, coat_normal_of(m, s, solid, u_lod));
    }
    return p;
}

#endif
