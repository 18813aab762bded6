// Materials made of the library's models: a stack of parameters, bottom first, blended by weights
// and masks. Resources: load_bsdf, load_bsdf_layer, and those of shading_point.glsl.
#ifndef GP_KERNELS_LIBRARY_MATERIAL_GLSL
#define GP_KERNELS_LIBRARY_MATERIAL_GLSL
#include "kernels/shading_point.glsl"
#include "kernels/slope_map.glsl"
#include "shading/bsdf/blend.glsl"
#include "shading/bsdf/bsdf.glsl"
#include "shading/slope/mean_slope.glsl"

BsdfParams library_params(IN(MaterialRecord) m, IN(Surface) s, vec3 base, float u_lod) {
    BsdfParams b = load_bsdf(m.bsdf);
    for (uint i = 0u; i < m.layer_count; ++i) {
        LET_REF(BsdfLayerRecord) layer = load_bsdf_layer(m.first_layer + i);
        float share = layer.weight;
        if (layer.channel != NO_INDEX) {
            vec4 texel = read_slot(layer.mask_slot, s, u_lod);
            share *= layer.channel == 0u ? texel.x
                : layer.channel == 1u ? texel.y : layer.channel == 2u ? texel.z : texel.w;
        }
        b = bsdf_blended(b, load_bsdf(layer.bsdf), clamp(share, 0.0f, 1.0f));
    }
    b.base_color *= base;
    if ((m.flags & MATERIAL_PREPARE) != 0u) { b = bsdf_prepared(b); }
    return b;
}

// What the normal map holds within the footprint, in the frame that the material is evaluated in.
Slopes mapped_slopes(IN(MaterialRecord) m, IN(Surface) s, bool from_back) {
    vec2 uv = slot_position(m.normal_slot, s);
    // The square of the footprint's area, which is all that a ray cone says of it.
    float side = exp2(clamp(s.lod, -60.0f, 60.0f));
    Slopes d = read_slope_map(m.normal_slot.slope_map, uv, slot_change(m.normal_slot, side, 0.0f),
                              slot_change(m.normal_slot, 0.0f, side));
    d = slopes_scaled(d, vec2(m.normal_scale));
    if (m.anisotropy_rotation != 0.0f) {
        d = slopes_turned(d, cos(m.anisotropy_rotation), sin(m.anisotropy_rotation));
    }
    return from_back ? slopes_of_back(d) : d;
}

// Beside the renderer's own materials, out of their way.
OUT_OF_LINE ShadingPoint library_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, vec3 base,
                                       vec3 emission, float u_lod) {
    ShadingPoint p;
    p.bsdf = library_params(m, s, base, u_lod);
    p.emission = emission;
    p.attenuation = m.attenuation;
    p.flags = m.flags;
    // Surfaces of slopes stay in the frame of the geometry; the map bends and widens their slopes.
    bool by_slopes = m.normal_slot.slope_map != NO_INDEX && (m.textures & SLOT_NORMAL) != 0u;
    p.frame = by_slopes ? s.frame : mapped_frame(m, s, u_lod);
    if (m.anisotropy_rotation != 0.0f) {
        p.frame = turned_frame(
            p.frame, vec2(cos(m.anisotropy_rotation), sin(m.anisotropy_rotation)));
    }
    bool solid = (m.flags & MATERIAL_SOLID) != 0u;
    p.frame = face_viewer(s, p.frame, wo, solid);
    if (by_slopes) {
        Slopes d = slopes_added(glint_slopes(p.bsdf), mapped_slopes(m, s, s.front == 0u && !solid));
        // What is seen although its mean slope turns away from the viewer is bent until it is not.
        vec3 wo_local = local_from_world(p.frame, wo);
        if (wo_local.z > 0.0f) { d.mean = slope_mean_in_view(d.mean, wo_local); }
        p.bsdf = glint_with_slopes(p.bsdf, d);
    }
    return p;
}

#endif
