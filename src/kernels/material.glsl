// The material of a surface at one point, whichever kind it is.
// Resources: those of the files included.
#ifndef GP_KERNELS_MATERIAL_GLSL
#define GP_KERNELS_MATERIAL_GLSL
#include "kernels/gltf_material.glsl"
#include "kernels/library_material.glsl"
#include "kernels/ocean_surface.glsl"

// Whether load_shading_point will take it for the sea.
bool is_sea(IN(MaterialRecord) m, bool diffuse) {
    return (m.flags & MATERIAL_SEA) != 0u && !diffuse;
}

// SURFACE_ bits of what load_shading_point will use.
uint surface_needs(IN(MaterialRecord) m, bool diffuse) {
    if (is_sea(m, diffuse)) { return SURFACE_PLACE; }
    bool uv = m.textures != 0u || (m.flags & MATERIAL_NEEDS_UV) != 0u;
    bool mapped = (m.textures & (SLOT_NORMAL | SLOT_COAT_NORMAL | SLOT_SLOPES)) != 0u ||
                  m.anisotropy > 0.0f;
    bool footprint = ((m.flags & MATERIAL_GLINT) != 0u || has_slope_maps(m)) && !diffuse;
    return (uv ? SURFACE_UV : 0u) | (mapped && !diffuse ? SURFACE_UV | SURFACE_TANGENT : 0u) |
           (footprint ? SURFACE_UV | SURFACE_FOOTPRINT : 0u);
}

ShadingPoint load_shading_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, float u_lod,
                                bool diffuse) {
    vec3 base = read_base_color(m, s, u_lod);
    vec3 emission = vec3(0.0f);
    if ((m.flags & MATERIAL_EMISSIVE) != 0u) { emission = read_emission(m, s, u_lod); }
    if ((m.flags & MATERIAL_LIBRARY) != 0u) {
        if (is_sea(m, diffuse)) { return ocean_point(m, s, wo); }
        if (diffuse) { base = library_params(m, s, base, u_lod).base_color; }
        else { return library_point(m, s, wo, base, emission, u_lod); }
    }
    if (diffuse) { return diffuse_point(m, s, wo, base, emission); }
    return gltf_point(m, s, wo, base, emission, u_lod);
}

#endif
