// The frame in which the sea's slopes are.
#ifndef GP_KERNELS_SEA_FRAME_GLSL
#define GP_KERNELS_SEA_FRAME_GLSL
#include "shading/frame.glsl"

// x towards +X, y towards -Z, up: the frame of scene/sea.h.
Frame sea_frame() {
    Frame f;
    f.t = vec3(1.0f, 0.0f, 0.0f);
    f.b = vec3(0.0f, 0.0f, -1.0f);
    f.n = vec3(0.0f, 1.0f, 0.0f);
    return f;
}

#endif
