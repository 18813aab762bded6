// How the G-buffer of a real-time frame packs what it says of a pixel.
#ifndef GP_KERNELS_REALTIME_GBUFFER_GLSL
#define GP_KERNELS_REALTIME_GBUFFER_GLSL
#include "shared/realtime_structs.glsl"

// The bits of a packed material that tell surfaces apart: sky, unlit, first person, mirrors on the
// way. Roughness and metallic vary over one surface, and whether its past is known says nothing.
#define MATERIAL_SURFACE_BITS 0xFF0D0000u

uint pack_material(IN(PixelMaterial) m) {
    uint roughness = uint(clamp(m.roughness, 0.0f, 1.0f) * 255.0f + 0.5f);
    uint metallic = uint(clamp(m.metallic, 0.0f, 1.0f) * 255.0f + 0.5f);
    return roughness | (metallic << 8u) | ((m.flags & 0xFFu) << 16u) |
           (min(m.mirrors, 255u) << 24u);
}

float material_roughness(uint word) {
    return float(word & 0xFFu) * (1.0f / 255.0f);
}

PixelMaterial unpack_material(uint word) {
    PixelMaterial m;
    m.roughness = material_roughness(word);
    m.metallic = float((word >> 8u) & 0xFFu) * (1.0f / 255.0f);
    m.flags = (word >> 16u) & 0xFFu;
    m.mirrors = word >> 24u;
    return m;
}

#endif
