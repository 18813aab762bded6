// The three channels and the surfaces' albedos together again.
// Resources: load_realtime, load_… of the G-buffer and the channels, store_color.
#ifndef GP_KERNELS_REALTIME_COMPOSITE_GLSL
#define GP_KERNELS_REALTIME_COMPOSITE_GLSL
#include "shading/frame.glsl"
#include "shading/indirect_light.glsl"

// Filtered over many mapped normals, indirect light is that of the unmapped one; as the rays left
// it, it is that of the pixel's own.
vec3 composite_indirect(ivec2 pixel) {
    if (load_realtime().relights == 0u) { return load_indirect_raw(pixel); }
    return indirect_relit(load_indirect(pixel), load_indirect_chroma(pixel),
                          octahedral_decode(load_unmapped_normal(pixel)),
                          octahedral_decode(load_normal(pixel)));
}

void realtime_composite(ivec2 pixel, int) {
    vec4 emission = load_emission(pixel);
    vec3 diffuse = vec3(load_direct(pixel)) + composite_indirect(pixel);
    vec3 color = vec3(emission) + vec3(load_albedo(pixel)) * diffuse +
                 vec3(load_specular_albedo(pixel)) * vec3(load_specular(pixel));
    if (load_realtime().suns_apart != 0u) { color += load_sun(pixel); }
    store_color(pixel, vec4(max(color, vec3(0.0f)), emission.w));
}

#endif
