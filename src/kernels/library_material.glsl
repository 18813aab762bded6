// Materials made of the library's models: a stack of parameters, bottom first, blended by weights
// and masks. Resources: load_bsdf, load_bsdf_layer, and those of shading_point.glsl.
#ifndef GP_KERNELS_LIBRARY_MATERIAL_GLSL
#define GP_KERNELS_LIBRARY_MATERIAL_GLSL
#include "kernels/shading_point.glsl"
#include "shading/bsdf/blend.glsl"
#include "shading/bsdf/bsdf.glsl"

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

// Beside the renderer's own materials, out of their way.
OUT_OF_LINE ShadingPoint library_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, vec3 base,
                                       vec3 emission, float u_lod) {
    ShadingPoint p;
    p.bsdf = library_params(m, s, base, u_lod);
    p.emission = emission;
    p.attenuation = m.attenuation;
    p.flags = m.flags;
    p.frame = mapped_frame(m, s, u_lod);
    if (m.anisotropy_rotation != 0.0f) {
        p.frame = turned_frame(
            p.frame, vec2(cos(m.anisotropy_rotation), sin(m.anisotropy_rotation)));
    }
    p.frame = face_viewer(s, p.frame, wo, (m.flags & MATERIAL_SOLID) != 0u);
    return p;
}

#endif
