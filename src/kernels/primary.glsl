// Where a camera ray of a pixel starts.
// Resources: load_frame.
#ifndef GP_KERNELS_PRIMARY_GLSL
#define GP_KERNELS_PRIMARY_GLSL
#include "shading/camera.glsl"
#include "shading/sampling/sampler.glsl"
#include "shading/sampling/pixel_filter.glsl"
#include "shared/scene_structs.glsl"

#define CAMERA_LENS_DRAW 1u  // the first is the filter's
#define CAMERA_DRAWS 2u      // the path's own follow

// How far from its middle the pixel is seen. The filter is sampled, so that every path has the same
// weight. [Ernst, Stamminger and Greiner 2006, "Filter Importance Sampling"]
vec2 camera_offset(uint pixel_filter, float radius, Sampler draws) {
    return filter_sample(pixel_filter, radius, sampler_next_2d(draws));
}

// Through the pixel at its camera_offset; a point of the lens.
Ray camera_ray_of_pixel(IN(CameraParams) camera, uvec2 pixel, vec2 offset, INOUT(Sampler) draws) {
    LET_REF(FrameConstants) f = load_frame();
    vec2 film = vec2((float(pixel.x) + 0.5f + offset.x) / float(f.width),
                     (float(pixel.y) + 0.5f + offset.y) / float(f.height));
    vec2 u_lens = vec2(0.0f);
    draws.dimension = CAMERA_LENS_DRAW;
    if (camera.lens_radius > 0.0f) { u_lens = sampler_next_2d(draws); }
    draws.dimension = CAMERA_DRAWS;
    Ray ray = camera_ray(camera, film, u_lens);
    ray.t_max = f.ray_length;
    return ray;
}

#endif
