// From radiance to what a display shows.
#ifndef GP_KERNELS_TONEMAP_GLSL
#define GP_KERNELS_TONEMAP_GLSL
#include "shading/colour.glsl"

// gp::Tonemap.
#define TONEMAP_AGX 0u
#define TONEMAP_ACES 1u
#define TONEMAP_REINHARD 2u

// Linear Rec. 709 radiance to sRGB-encoded 0..1. Alpha passes unchanged.
IN_LOOPS vec4 tonemap_pixel(vec4 color, float exposure_scale, uint tonemap) {
    vec3 c = max(vec3(color) * exposure_scale, vec3(0.0f));
    if (tonemap == TONEMAP_AGX) {
        c = tonemap_agx(c);
    } else if (tonemap == TONEMAP_ACES) {
        c = tonemap_aces(c);
    } else if (tonemap == TONEMAP_REINHARD) {
        c = tonemap_reinhard(c);
    }
    return vec4(srgb_encode(clamp(c, vec3(0.0f), vec3(1.0f))), clamp(color.w, 0.0f, 1.0f));
}

#endif
