// Before BMFR (bmfr_fit.glsl): all diffuse light becomes one channel, as that regression fits what
// textures have been taken out of, whatever way the light came.
#ifndef GP_KERNELS_REALTIME_BMFR_GATHER_GLSL
#define GP_KERNELS_REALTIME_BMFR_GATHER_GLSL
#include "kernels/realtime/edge_stop.glsl"

void bmfr_gather(ivec2 pixel, int) {
    vec4 direct = load_direct(pixel);
    vec3 diffuse = vec3(finite_or_zero_4(direct)) +
                   vec3(finite_or_zero_4(vec4(load_indirect_raw(pixel), 0.0f)));
    store_direct(pixel, vec4(diffuse, direct.w));
    store_indirect_raw(pixel, vec3(0.0f));
    // What the temporal pass finds fireflies by.
    store_luma(pixel, vec4(luminance(diffuse), 0.0f, load_luma(pixel).z, 0.0f));
}

#endif
