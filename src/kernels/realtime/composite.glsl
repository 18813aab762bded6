// The three channels and the surfaces' albedos together again.
// Resources: load_… of the G-buffer and the channels, store_color.
#ifndef GP_KERNELS_REALTIME_COMPOSITE_GLSL
#define GP_KERNELS_REALTIME_COMPOSITE_GLSL
#include "shading/ycocg.glsl"

vec3 indirect_color(float luma, vec4 indirect, vec2 chroma) {
    float share = indirect.x > 0.0f ? luma / indirect.x : 0.0f;
    return max(rgb_from_ycocg(vec3(luma, chroma * share)), vec3(0.0f));
}

void realtime_composite(ivec2 pixel) {
    vec4 emission = load_emission(pixel);
    vec4 indirect = load_indirect(pixel);
    vec3 diffuse = vec3(load_direct(pixel)) +
                   indirect_color(indirect.x, indirect, load_indirect_chroma(pixel));
    vec3 color = vec3(emission) + vec3(load_albedo(pixel)) * diffuse +
                 vec3(load_specular_albedo(pixel)) * vec3(load_specular(pixel));
    store_color(pixel, vec4(max(color, vec3(0.0f)), emission.w));
}

#endif
