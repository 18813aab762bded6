// Eye adaptation: how bright the picture is, as a histogram of luminance in stops, and what
// exposure follows from it.
// Resources: load_output.
#ifndef GP_KERNELS_REALTIME_EXPOSURE_GLSL
#define GP_KERNELS_REALTIME_EXPOSURE_GLSL
#include "shading/colour.glsl"

// Bin 0 is for what is darker than 2^-16 of one; the bins go on in halves of a stop.
#define EXPOSURE_BINS 64u
#define EXPOSURE_FIRST_STOP -16.0f
#define EXPOSURE_BINS_A_STOP 2.0f

uint exposure_bin_of_pixel(ivec2 pixel) {
    float l = luminance(vec3(load_output(pixel)));
    if (!(l > 0.0f)) { return 0u; }
    float bin = (log2(l) - EXPOSURE_FIRST_STOP) * EXPOSURE_BINS_A_STOP + 1.0f;
    return uint(clamp(bin, 0.0f, float(EXPOSURE_BINS) - 1.0f));
}

// The luminance in the middle of a bin, in stops.
float exposure_bin_stop(uint bin) {
    return EXPOSURE_FIRST_STOP + (float(bin) - 0.5f) / EXPOSURE_BINS_A_STOP;
}

// The way from one exposure to another that an eye makes in `seconds`, by an exponential whose
// time constant is `adaptation_seconds`.
// [Pattanaik, Tumblin, Yee and Greenberg 2000, "Time-Dependent Visual Adaptation for Fast Realistic
//  Image Display", equation 6]
float exposure_adapted(float from, float to, float seconds, float adaptation_seconds) {
    return to + (from - to) * exp(-seconds / adaptation_seconds);
}

#endif
