// What the water of the sea scatters towards a viewer in it, or one who looks into it.
// Resources: load_frame, load_instance, load_material.
#ifndef GP_KERNELS_SEA_LIGHT_GLSL
#define GP_KERNELS_SEA_LIGHT_GLSL
#include "shading/camera.glsl"
#include "shading/ocean/water_light.glsl"
#include "shared/scene_structs.glsl"

// Along a ray in the water to what it met. The surface is where the ray leaves it or comes to it
// (`from_surface`), else the sea's at rest: the water has its own colour in waves of any height.
// Out of line, as all that only scenes with clear water need.
OUT_OF_LINE vec3 sea_light(IN(Ray) ray, IN(Hit) hit, bool from_surface) {
    LET_REF(FrameConstants) f = load_frame();
    float down = -ray.direction.y;
    bool ends = hit.instance != HIT_NOTHING;
    float distance = ends ? hit.t : FLOAT_MAX;
    float depth = max(f.water_level - ray.origin.y, 0.0f);
    if (down >= 0.0f) {
        depth = from_surface ? 0.0f : depth;
    } else if (ends) {
        bool to_surface = false;
        if (hit.instance < HIT_LIGHT) {
            uint flags = load_material(load_instance(hit.instance).material).flags;
            to_surface = (flags & MATERIAL_SEA) != 0u;
        }
        float rise = -down * distance;
        depth = to_surface ? rise : max(depth, rise);
    }
    vec3 b = f.water_radiance;
    vec3 loss = f.water_attenuation;
    float stretch = f.water_stretch;
    return vec3(water_light(b.x, loss.x, stretch, depth, down, distance),
                water_light(b.y, loss.y, stretch, depth, down, distance),
                water_light(b.z, loss.z, stretch, depth, down, distance));
}

#endif
