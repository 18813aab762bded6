// The material of a surface at one point: textures read, everything multiplied out.
// Resources: load_material, sample_texture.
#ifndef GP_KERNELS_MATERIAL_GLSL
#define GP_KERNELS_MATERIAL_GLSL
#include "kernels/surface.glsl"
#include "shading/bsdf/bsdf.glsl"

struct ShadingPoint {
    BsdfParams bsdf;
    Frame frame;     // with the normal map; on the side of wo, but for solid bodies: outside
    vec3 emission;   // towards wo
    vec3 attenuation;// of the inside, 1/m
    uint flags;      // MATERIAL_ bits
};

#define FINEST_LEVEL -1000.0f  // a Surface::lod that reads level 0 of any texture

// u_lod in [0, 1) chooses between the two nearest levels of detail: one look-up, linear on average.
vec4 read_slot(IN(TextureSlot) slot, IN(Surface) s, float u_lod) {
    vec2 uv = slot.tex_coord == 0u ? s.uv0 : s.uv1;
    vec2 moved = vec2(slot.row_u.x * uv.x + slot.row_u.y * uv.y + slot.row_u.z,
                      slot.row_v.x * uv.x + slot.row_v.y * uv.y + slot.row_v.z);
    return sample_texture(slot.texture_index, moved, s.lod, u_lod);
}

float alpha_from_roughness(float roughness) {
    return max(roughness * roughness, BSDF_MIN_ALPHA);
}

// A tangent-space normal from a map, its slope scaled.
vec3 read_normal(IN(TextureSlot) slot, IN(Surface) s, float scale, float u_lod) {
    vec3 n = vec3(read_slot(slot, s, u_lod)) * 2.0f - 1.0f;
    return normalize(vec3(n.x * scale, n.y * scale, max(n.z, 1.0e-3f)));
}

// [KHR_materials_clearcoat, _specular, _sheen, _transmission, _iridescence: each factor times its
// channel]
BsdfParams read_layers(BsdfParams b, IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    if ((m.textures & SLOT_SPECULAR) != 0u) {
        b.specular *= read_slot(m.specular_slot, s, u_lod).w;
    }
    if ((m.textures & SLOT_SPECULAR_COLOR) != 0u) {
        b.specular_color *= vec3(read_slot(m.specular_color_slot, s, u_lod));
    }
    if ((m.textures & SLOT_COAT) != 0u) { b.coat *= read_slot(m.coat_slot, s, u_lod).x; }
    float coat_roughness = m.coat_roughness;
    if ((m.textures & SLOT_COAT_ROUGHNESS) != 0u) {
        coat_roughness *= read_slot(m.coat_roughness_slot, s, u_lod).y;
    }
    b.coat_alpha = alpha_from_roughness(coat_roughness);
    if ((m.textures & SLOT_SHEEN_COLOR) != 0u) {
        b.sheen_color *= vec3(read_slot(m.sheen_color_slot, s, u_lod));
    }
    float sheen_roughness = m.sheen_roughness;
    if ((m.textures & SLOT_SHEEN_ROUGHNESS) != 0u) {
        sheen_roughness *= read_slot(m.sheen_roughness_slot, s, u_lod).w;
    }
    b.sheen_alpha = alpha_from_roughness(sheen_roughness);
    if ((m.textures & SLOT_TRANSMISSION) != 0u) {
        b.transmission *= read_slot(m.transmission_slot, s, u_lod).x;
    }
    if ((m.textures & SLOT_IRIDESCENCE) != 0u) {
        b.iridescence *= read_slot(m.iridescence_slot, s, u_lod).x;
    }
    float thickness = 1.0f;
    if ((m.textures & SLOT_IRIDESCENCE_THICKNESS) != 0u) {
        thickness = read_slot(m.iridescence_thickness_slot, s, u_lod).y;
    }
    b.iridescence_thickness_nm =
        mix(m.iridescence_thickness_min_nm, m.iridescence_thickness_max_nm, thickness);
    return b;
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
    float l = length(direction);
    if (l > 1.0e-6f) {
        vec3 t = (p.frame.t * direction.x + p.frame.b * direction.y) / l;
        float handedness = dot(cross(p.frame.n, p.frame.t), p.frame.b) < 0.0f ? -1.0f : 1.0f;
        p.frame = frame_from_normal_tangent(p.frame.n, t, handedness);
    }
    p.bsdf.alpha_x = mix(p.bsdf.alpha_x, 1.0f, strength * strength);
    return p;
}

// The frame that the material is evaluated in: a reflecting surface turns it to the viewer, a
// solid body keeps it outside.
Frame face_viewer(IN(Surface) s, Frame frame, vec3 wo, bool keep) {
    bool flip = s.front == 0u && !keep;
    Frame f = frame;
    if (flip) {
        f.n = -f.n;
        f.b = -f.b;  // stays as right- or left-handed as it was
    }
    // wo is on the side of ng if the ray came from the front, or the frame was turned.
    bool inside = s.front == 0u && keep;
    vec3 n = inside ? -bend_to_viewer(-f.n, wo) : bend_to_viewer(f.n, wo);
    float handedness = dot(cross(f.n, f.t), f.b) < 0.0f ? -1.0f : 1.0f;
    return n == f.n ? f : frame_from_normal_tangent(n, f.t, handedness);
}

// Only what a plain-diffuse picture needs.
ShadingPoint diffuse_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, vec3 base,
                           vec3 emission) {
    ShadingPoint p;
    p.bsdf = bsdf_default();
    p.bsdf.model = MODEL_LAMBERT;
    p.bsdf.base_color = base;
    p.frame = face_viewer(s, s.frame, wo, false);
    p.attenuation = vec3(0.0f);
    p.emission = emission;
    p.flags = m.flags & ~(MATERIAL_TRANSMISSIVE | MATERIAL_SOLID);
    return p;
}

vec3 read_emission(IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    vec3 e = m.emission;
    if ((m.textures & SLOT_EMISSION) != 0u) {
        // Of the finest level, as shadow rays read it: a wide ray that saw a lamp's mean instead
        // would find another light than they do, and the weights between the two would not sum up.
        Surface finest = s;
        finest.lod = FINEST_LEVEL;
        e *= vec3(read_slot(m.emission_slot, finest, u_lod));
    }
    bool shines = s.front != 0u || (m.flags & MATERIAL_DOUBLE_SIDED) != 0u;
    return shines ? e : vec3(0.0f);
}

vec3 read_base_color(IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    vec3 base = vec3(m.base_color);
    if ((m.textures & SLOT_BASE_COLOR) != 0u) {
        base *= vec3(read_slot(m.base_color_slot, s, u_lod));
    }
    if ((m.flags & MATERIAL_VERTEX_COLOR) != 0u) { base *= vec3(s.color); }
    return base;
}

// Everything that a material has. One variable is filled, field by field, and returned: a copy of
// BsdfParams would move the slots of the library's models as well, which are not set here.
ShadingPoint full_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, vec3 base, vec3 emission,
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
    p.frame = s.frame;
    p.emission = emission;
    p.attenuation = m.attenuation;
    p.flags = m.flags;
    if ((m.textures & SLOT_NORMAL) != 0u) {
        vec3 n = world_from_local(s.frame, read_normal(m.normal_slot, s, m.normal_scale, u_lod));
        float handedness = dot(cross(s.frame.n, s.frame.t), s.frame.b) < 0.0f ? -1.0f : 1.0f;
        p.frame = frame_from_normal_tangent(n, s.frame.t, handedness);
    }
    vec3 coat_normal = s.frame.n;
    if ((m.textures & SLOT_COAT_NORMAL) != 0u) {
        coat_normal = world_from_local(
            s.frame, read_normal(m.coat_normal_slot, s, m.coat_normal_scale, u_lod));
    }
    if (m.anisotropy > 0.0f) { p = apply_anisotropy(p, m, s, u_lod); }
    bool solid = (m.flags & (MATERIAL_SOLID | MATERIAL_TRANSMISSIVE)) ==
                 (MATERIAL_SOLID | MATERIAL_TRANSMISSIVE);
    p.frame = face_viewer(s, p.frame, wo, solid);
    if (m.coat > 0.0f) {
        vec3 c = s.front == 0u && !solid ? -coat_normal : coat_normal;
        p.bsdf.coat_normal = local_from_world(p.frame, c);
    }
    return p;
}

ShadingPoint load_shading_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, float u_lod,
                                bool diffuse) {
    vec3 base = read_base_color(m, s, u_lod);
    vec3 emission = vec3(0.0f);
    if ((m.flags & MATERIAL_EMISSIVE) != 0u) { emission = read_emission(m, s, u_lod); }
    if (diffuse) { return diffuse_point(m, s, wo, base, emission); }
    return full_point(m, s, wo, base, emission, u_lod);
}

#endif
