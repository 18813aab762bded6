// What a path knows between two surfaces, and the water that it is in.
// Resources: load_frame, load_instance, load_material.
#ifndef GP_KERNELS_PATH_STATE_GLSL
#define GP_KERNELS_PATH_STATE_GLSL
#include "kernels/light_choice.glsl"
#include "kernels/sea_light.glsl"
#include "kernels/surface.glsl"
#include "shading/sampling/sampler.glsl"

// The light that a path brings to its pixel, by how often it was reflected.
struct PathLight {
    vec3 emission;
    vec3 direct;
    vec3 indirect;
};

// What the first surface leaves for guides and layers.
struct PathGuides {
    vec3 albedo;
    float coverage;
    vec3 normal;
    float depth;      // metres along the ray
    float roughness;
    float metallic;
    uint instance;    // 1 + index, 0: nothing
};

// The vertex that a ray leaves, as far as the weight of what it meets depends on it.
struct PathVertex {
    vec3 position;
    float pdf;          // of the ray's direction; 0: not to be weighted (camera, mirror-like)
    vec3 normal;        // of the surface; the zero vector where light from both sides counts
    LightGroups groups; // what its shadow ray was chosen among
};

// Bits of PathState::water.
#define PATH_IN_WATER 1u     // the sea's
#define PATH_LIT_THROUGH 2u  // the far light that comes down through its surface to the last
                             // surface has been counted: what goes up there finds none
#define PATH_IN_BODY 4u      // in something clear that lies in the water
#define PATH_AT_SURFACE 8u   // the ray starts at the sea's surface, into the water

// A path between two surfaces.
struct PathState {
    Ray ray;            // the camera's, or what left the last surface
    Hit hit;            // what it met
    RayCone cone;       // at the ray's start
    Sampler draws;      // at the path's first draw
    PathVertex from;    // where the ray starts
    vec3 throughput;
    float eta_scale;    // radiance is compressed by refraction, and guides are narrower than
                        // materials; roulette must not see either
    vec3 attenuation;   // of the medium around, 1/m
    uint water;         // PATH_ bits
    uint depth;         // surfaces met so far
    uint ended;         // 1: light and guides are final, there is no ray
    PathLight light;
    PathGuides guides;
};

// PATH_ bits, of a ray that starts where the sea's water may be.
void path_set_water(INOUT(PathState) path, uint water) {
    path.water = water;
    path.attenuation =
        (water & PATH_IN_WATER) != 0u ? load_frame().water_attenuation : vec3(0.0f);
}

// Into something clear in the water, or out of it.
void path_change_body(INOUT(PathState) path, bool entering) {
    if (entering) {
        path.water |= PATH_IN_BODY;
    } else {
        path_set_water(path, path.water & ~PATH_IN_BODY);
    }
}

// The PATH_ bits of a ray that leaves a surface with these flags.
uint path_water_from(uint water, uint material_flags) {
    bool surface = (material_flags & MATERIAL_SEA) != 0u && (water & PATH_IN_WATER) != 0u;
    return surface ? water | PATH_AT_SURFACE : water & ~PATH_AT_SURFACE;
}

// What the water sends along the path's ray, which has met path.hit.
vec3 path_water_light(IN(PathState) path) {
    if ((path.water & (PATH_IN_WATER | PATH_IN_BODY)) != PATH_IN_WATER) { return vec3(0.0f); }
    return sea_light(path.ray, path.hit, (path.water & PATH_AT_SURFACE) != 0u);
}

// Whether no shadow ray can reach what is infinitely far, or none should.
bool path_sea_hides(uint water, uint material_flags) {
    if ((material_flags & MATERIAL_SEA) != 0u) { return (water & PATH_LIT_THROUGH) != 0u; }
    return (water & PATH_IN_WATER) != 0u && (load_frame().water & WATER_BENDS) == 0u;
}

#endif
