// What a real-time frame is, for its kernels. C++ reads it through shared/realtime_structs.h; vec3
// is always followed by one scalar, so that std430 and C++ agree on every offset.
#ifndef GP_SHARED_REALTIME_STRUCTS_GLSL
#define GP_SHARED_REALTIME_STRUCTS_GLSL

// depth of pixels that show the sky. Halves the largest float, so that differences stay finite.
#define DEPTH_NONE 1.0e30f

// Flags in `material`.
#define REALTIME_SKY 1u
#define REALTIME_NO_HISTORY 2u    // nothing is known of where it was
#define REALTIME_UNLIT 4u         // no light of the three channels reaches it

// How shadow rays choose among lights that are not directional; and what is kept of bounce rays.
#define LIGHT_REUSE_NONE 0u      // each by itself
#define LIGHT_REUSE_BIASED 1u    // with what pixels of the last frame found, as if all saw the same
#define LIGHT_REUSE_UNBIASED 2u  // the same, but those that could not have found it do not count

// What a pixel of `material` holds.
struct PixelMaterial {
    float roughness;
    float metallic;
    uint flags;
    uint mirrors;   // reflected or refracted so often before this surface
};

// Where an instance was in the last frame.
struct PreviousInstance {
    vec4 world_from_object[3];
    uint index;      // of the instance in the last frame; NO_INDEX: nothing is known
    uint pad0;
    uint pad1;
    uint pad2;
};

// A triangle's corners as they were in the last frame, in the space of the mesh.
struct PreviousCorners {
    vec3 p0;
    vec3 p1;
    vec3 p2;
};

// The rings of the sea's triangles now and in the last frame: they go with the camera, so that
// their numbers name other places of the water. Middles: (towards +X, towards -Z), metres.
struct SeaMotion {
    vec2 centre;
    vec2 previous_centre;
    float height;            // of the viewer that they are made for
    float previous_height;
    uint sectors;
    uint rings;
    uint instance;           // of this frame; NO_INDEX: no sea, or one that was not there
    uint pad0;
};

// gp::RealtimePlan and what a frame knows of the one before.
struct RealtimeConstants {
    ivec2 size;              // of rays and denoising
    ivec2 output_size;
    vec2 jitter;             // of this frame's rays, pixels from the centre
    uint frame_index;        // grows by one a frame
    uint has_previous;       // 0: the first frame, or one after a cut
    uint mirror_limit;       // of reflections and refractions before the surface that is shown
    uint repeats_draws;      // 1: a pixel of each block repeats the draws of the last frame
    uint previous_instances; // how many the last frame had
    uint resolves;           // 1: anti-aliasing over time, or upscaling; 0: a copy
    uint light_reuse;        // LIGHT_REUSE_
    uint previous_lights;    // how many the last frame had
    uint relights;           // 1: a denoiser has run over the indirect light
    uint indirect_reuse;     // LIGHT_REUSE_
    uint scene_changed;      // 1: something is not as it was in the last frame
    uint suns_apart;         // 1: surfaces of slopes keep their reflection of suns in `sun`
    SeaMotion sea;
#define X(name, initial, minimum, maximum, text) float name;
#include "shared/denoiser_parameters.def"
#undef X
};

#endif
