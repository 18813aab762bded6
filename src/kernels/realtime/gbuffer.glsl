// What a pixel of the G-buffer holds, packed and unpacked.
#ifndef GP_KERNELS_REALTIME_GBUFFER_GLSL
#define GP_KERNELS_REALTIME_GBUFFER_GLSL
#include "shading/constants.glsl"
#include "shared/realtime_structs.glsl"

uint unorm8_encode(float v) {
    return uint(clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f);
}

uint pack_material(IN(PixelMaterial) m) {
    return unorm8_encode(m.roughness) | (unorm8_encode(m.metallic) << 8u) |
           ((m.flags & 255u) << 16u) | (min(m.mirrors, 255u) << 24u);
}

// The bits that tell surfaces apart: sky, unlit, first person, mirrors on the way. Roughness and
// metallic vary over one surface, and whether its past is known says nothing.
#define MATERIAL_SURFACE_BITS 0xFF0D0000u

float material_roughness(uint bits) {
    return float(bits & 255u) * (1.0f / 255.0f);
}

PixelMaterial unpack_material(uint bits) {
    PixelMaterial m;
    m.roughness = material_roughness(bits);
    m.metallic = float((bits >> 8u) & 255u) * (1.0f / 255.0f);
    m.flags = (bits >> 16u) & 255u;
    m.mirrors = bits >> 24u;
    return m;
}

// As the 8 bits of an image will give it back: what is divided by it now is multiplied by the same
// number later.
vec3 unorm8_rounded(vec3 v) {
    return floor(clamp(v, vec3(0.0f), vec3(1.0f)) * 255.0f + 0.5f) * (1.0f / 255.0f);
}

uint pack_barycentrics(float u, float v) {
    return uint(clamp(u, 0.0f, 1.0f) * 65535.0f + 0.5f) |
           (uint(clamp(v, 0.0f, 1.0f) * 65535.0f + 0.5f) << 16u);
}

vec2 unpack_barycentrics(uint bits) {
    return vec2(float(bits & 65535u), float(bits >> 16u)) * (1.0f / 65535.0f);
}

#endif
