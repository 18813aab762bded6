// Materials made of the library's models: a stack of parameters, bottom first, blended by weights
// and masks. Resources: load_bsdf, load_bsdf_layer, and those of material_slopes.glsl.
#ifndef GP_KERNELS_LIBRARY_MATERIAL_GLSL
#define GP_KERNELS_LIBRARY_MATERIAL_GLSL
#include "kernels/layer_textures.glsl"
#include "kernels/material_slopes.glsl"
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
            share *= layer.squared != 0u ? share : 1.0f;
        }
        b = bsdf_blended(b, load_bsdf(layer.bsdf), clamp(share, 0.0f, 1.0f));
    }
    b.base_color *= base;
    if ((m.flags & MATERIAL_PREPARE) != 0u) { b = bsdf_prepared(b); }
    return b;
}

// What the maps hold within the footprint, in the frame that the material is evaluated in.
Slopes mapped_slopes(IN(MaterialRecord) m, IN(Surface) s, IN(PixelTurns) t, bool from_back) {
    Slopes d = material_slopes(m, s, t);
    if (m.anisotropy_rotation != 0.0f) {
        d = slopes_turned(d, cos(m.anisotropy_rotation), sin(m.anisotropy_rotation));
    }
    return from_back ? slopes_of_back(d) : d;
}

// The change of the half vector's slope along one axis of the pixel, where the light comes from the
// mirror direction: glints are near it, and for all of them the change is about the same. That
// light comes from nearby is neglected. [Chermain et al. 2021, section 5]
vec2 glint_kernel_axis(IN(PixelTurn) t, IN(Frame) f, vec3 wo, float inv_viewer) {
    vec3 wi = f.n * (2.0f * dot(f.n, wo)) - wo;
    vec3 change = half_vector_turn(t, f, wo, wi, inv_viewer, 0.0f);
    return vec2(-change.x, -change.y);
}

// Cones wider than this, in radians, come out of rough lobes and not out of pixels.
#define GLINT_LARGEST_SPREAD 0.05f

// How much of a cone's turns is the pixel's. The directions of a rough lobe are sampled by paths;
// as a kernel they would make all that lies behind a matte surface rough, and cavities lose the
// more light the rougher they are (metal of alpha 0.1 in a white room: a sixth); and from below,
// calm water would look as rough as a storm's.
float glint_kernel_share(float spread) {
    return GLINT_LARGEST_SPREAD / max(abs(spread), GLINT_LARGEST_SPREAD);
}

// What the pixel sees of the facets: where in the texture coordinates, how much of them, how the
// half vector changes from one of its edges to the other; and what the slope maps, of which the
// normal map is one, have there.
BsdfParams glint_params_at(BsdfParams b, IN(MaterialRecord) m, IN(Surface) s, IN(Frame) frame,
                           vec3 wo) {
    PixelTurns t = pixel_turns(s.hit, -wo, s.cone);
    vec2 d0 = coordinate_change(s, 0u, t.a.corners);
    vec2 d1 = coordinate_change(s, 0u, t.b.corners);
    // Without texture coordinates there is nothing to count facets in.
    if (d0 == vec2(0.0f) && d1 == vec2(0.0f)) { b.slot_b.x = float(GLINT_SMOOTH); }
    // The distance to where the cone is a point.
    float inv_viewer = abs(s.cone.spread) / max(abs(s.cone.width), 1.0e-8f);
    float share = glint_kernel_share(s.cone.spread);
    vec2 k0 = glint_kernel_axis(t.a, frame, wo, inv_viewer) * share;
    vec2 k1 = glint_kernel_axis(t.b, frame, wo, inv_viewer) * share;
    b.slot_c.x = s.uv0.x;
    b.slot_c.y = s.uv0.y;
    b.slot_d = vec4(d0, d1);
    b.slot_e = vec4(k0, k1);
    if (has_slope_maps(m)) {
        bool from_back = s.front == 0u && (m.flags & MATERIAL_SOLID) == 0u;
        b = glint_with_slopes(
            b, slopes_added(glint_material_slopes(b), mapped_slopes(m, s, t, from_back)));
    }
    // What is seen although its mean slope turns away from the viewer is bent until it is not.
    vec3 wo_local = local_from_world(frame, wo);
    if (wo_local.z > 0.0f) {
        vec2 mean = slope_mean_in_view(glint_mean(b), wo_local);
        b.slot_a.x = mean.x;
        b.slot_a.y = mean.y;
    }
    GlintBase base = glint_base_at(b);
    GLINT_SET_BASE(b, base)
    return b;
}

// glTF's textures over the factors of roughness and metal, and over those of the layers.
// [Khronos glTF 2.0, section 3.9.2]
BsdfParams glint_textured(BsdfParams b, IN(MaterialRecord) m, IN(Surface) s, float u_lod) {
    if ((m.textures & SLOT_METALLIC_ROUGHNESS) != 0u) {
        vec4 texel = read_slot(m.metallic_roughness_slot, s, u_lod);
        b.metallic *= texel.z;
        b = glint_with_roughness(b, texel.y);
    }
    return (m.textures & SLOTS_OF_LAYERS) != 0u ? layers_textured(b, m, s, u_lod) : b;
}

// The coat lies on the surface as it is, not as the maps of what is below it bend it: its normal in
// the frame of the layers. [KHR_materials_clearcoat, "Normal textures"]
BsdfParams glint_coat_at(BsdfParams b, IN(MaterialRecord) m, IN(Surface) s, IN(Frame) frame,
                         float u_lod) {
    vec3 n = frame.n;
    if ((m.textures & SLOT_COAT_NORMAL) != 0u) {
        n = coat_normal_of(m, s, (m.flags & MATERIAL_SOLID) != 0u, u_lod);
    }
    b.coat_normal = local_from_world(mesosurface_frame(glint_mean(b)), local_from_world(frame, n));
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
    // Facets are told their slopes over the surface as it is; all other models are bent.
    if (has_slope_maps(m) && (m.flags & MATERIAL_GLINT) == 0u) {
        SlopedShape shape =
            sloped_shape(m, s, wo, p.frame, p.bsdf.alpha_x, p.bsdf.alpha_y);
        p.frame = shape.frame;
        p.bsdf.alpha_x = shape.alpha_x;
        p.bsdf.alpha_y = shape.alpha_y;
    }
    p.frame = face_viewer(s, p.frame, wo, (m.flags & MATERIAL_SOLID) != 0u);
    if ((m.flags & MATERIAL_GLINT) != 0u) {
        p.bsdf = glint_params_at(glint_textured(p.bsdf, m, s, u_lod), m, s, p.frame, wo);
        if (p.bsdf.coat > 0.0f) { p.bsdf = glint_coat_at(p.bsdf, m, s, p.frame, u_lod); }
    }
    return p;
}

#endif
