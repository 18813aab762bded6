// What a surface is at one point, and what all kinds of materials read alike: textures, the frame
// with its normal map, base colour, emission.
// Resources: sample_texture, load_texture_layer.
#ifndef GP_KERNELS_SHADING_POINT_GLSL
#define GP_KERNELS_SHADING_POINT_GLSL
#include "kernels/surface.glsl"
#include "kernels/texture_layers.glsl"
#include "shading/bsdf/bsdf.glsl"

struct ShadingPoint {
    BsdfParams bsdf;
    Frame frame;     // with the normal map; on the side of wo, but for solid bodies: outside
    vec3 emission;   // towards wo
    vec3 attenuation;// of the inside, 1/m
    uint flags;      // MATERIAL_ bits
};

#define FINEST_LEVEL -1000.0f  // a Surface::lod that reads level 0 of any texture

// Where a slot reads, and how that changes with texture coordinates.
vec2 slot_position(IN(TextureSlot) slot, IN(Surface) s) {
    vec2 uv = slot.tex_coord == 0u ? s.uv0 : s.uv1;
    return vec2(slot.row_u.x * uv.x + slot.row_u.y * uv.y + slot.row_u.z,
                slot.row_v.x * uv.x + slot.row_v.y * uv.y + slot.row_v.z);
}

vec2 slot_change(IN(TextureSlot) slot, vec2 d) {
    return vec2(slot.row_u.x * d.x + slot.row_u.y * d.y, slot.row_v.x * d.x + slot.row_v.y * d.y);
}

// u_lod in [0, 1) chooses between the two nearest levels of detail: one look-up, linear on average.
vec4 read_slot(IN(TextureSlot) slot, IN(Surface) s, float u_lod) {
    return sample_texture(slot.texture_index, slot_position(slot, s), s.lod, u_lod);
}

// A tangent-space normal from a map, its slope scaled.
vec3 read_normal(IN(TextureSlot) slot, IN(Surface) s, float scale, float u_lod) {
    vec3 n = vec3(read_slot(slot, s, u_lod)) * 2.0f - 1.0f;
    return normalize(vec3(n.x * scale, n.y * scale, max(n.z, 1.0e-3f)));
}

// Which side of the surface w, in the material's frame, is on: above 0 the outside. Models of
// slopes about a mean stand in the frame of the geometry, and their surface is the plane of that
// mean; of all others it is the frame's normal that says.
float side_of(IN(BsdfParams) m, vec3 w) {
    return m.model == MODEL_GLINT ? slope_facing(glint_mean(m), w) : w.z;
}

// Whether light that turns from one direction to the other is reflected, not sent through.
bool same_side(IN(BsdfParams) m, vec3 wo_local, vec3 wi_local) {
    return (side_of(m, wi_local) > 0.0f) == (side_of(m, wo_local) > 0.0f);
}

// The normal of that side, for pictures of it and for all who filter by it.
vec3 shown_normal(IN(ShadingPoint) p) {
    if (p.bsdf.model != MODEL_GLINT) { return p.frame.n; }
    return world_from_local(p.frame, normalize(mesosurface_normal(glint_mean(p.bsdf))));
}

float frame_handedness(IN(Frame) f) {
    return dot(cross(f.n, f.t), f.b) < 0.0f ? -1.0f : 1.0f;
}

// With the tangent turned: `direction` is where it goes, along tangent and bitangent, any length.
Frame turned_frame(IN(Frame) f, vec2 direction) {
    float l = length(direction);
    if (!(l > 1.0e-6f)) { return f; }
    vec3 t = (f.t * direction.x + f.b * direction.y) / l;
    return frame_from_normal_tangent(f.n, t, frame_handedness(f));
}

// The surface's frame with the normal map.
Frame mapped_frame(IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    if ((m.textures & SLOT_NORMAL) == 0u) { return s.frame; }
    vec3 n = world_from_local(s.frame, read_normal(m.normal_slot, s, m.normal_scale, u_lod));
    return frame_from_normal_tangent(n, s.frame.t, frame_handedness(s.frame));
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
    return n == f.n ? f : frame_from_normal_tangent(n, f.t, frame_handedness(f));
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
    p.flags = m.flags & ~(MATERIAL_TRANSMISSIVE | MATERIAL_SOLID | MATERIAL_SEA);
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

// Out of line, and found behind the flag of vertex colours: materials without must not pay.
OUT_OF_LINE vec3 add_texture_layers(vec3 base, uint first, IN(Surface) s, float u_lod) {
    vec3 color = base;
    for (uint i = first;; ++i) {
        LET_REF(TextureLayerRecord) layer = load_texture_layer(i);
        vec4 over = layer.color;
        if (layer.has_texture != 0u) { over *= read_slot(layer.slot, s, u_lod); }
        color = layer_over(color, over, layer.blend);
        if (layer.is_last != 0u) { return color * layer.tint; }
    }
    return color;
}

vec3 read_base_color(IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    vec3 base = vec3(m.base_color);
    if ((m.textures & SLOT_BASE_COLOR) != 0u) {
        base *= vec3(read_slot(m.base_color_slot, s, u_lod));
    }
    if ((m.flags & MATERIAL_VERTEX_COLOR) != 0u) {
        if ((m.textures & SLOT_LAYERS) != 0u) {
            base = add_texture_layers(base, m.first_texture_layer, s, u_lod);
        }
        base *= vec3(s.color);
    }
    return base;
}

#endif
