// What surrounds the scene: the environment, and before it sky geometry, which all rays that meet
// nothing else see from one point, however far they have come: hills, towers, domes of clouds.
// Resources: trace_sky, load_background (bilinear), and those of environment.glsl and
// shading_point.glsl.
#ifndef GP_KERNELS_SKY_GLSL
#define GP_KERNELS_SKY_GLSL
#include "kernels/environment.glsl"
#include "kernels/shading_point.glsl"
#include "shading/camera.glsl"
#include "shading/light/cube_map.glsl"

// Whether a ray sees the background itself, and not what the environment's table says of it.
bool sky_is_traced(bool of_camera) {
    LET_REF(FrameConstants) f = load_frame();
    return (f.sky & (SKY_TRACED | SKY_DRAWN)) != 0u &&
           (of_camera || (f.sky & SKY_DRAWN) == 0u);
}

// No light falls on sky geometry: it shows its colour, and what it glows. Textures are read where
// they are between two sizes by the nearer one; `spread` 0 is the finest, for all whose weights
// need the same answer from every ray.
vec3 sky_geometry_color(IN(Hit) hit, vec3 direction, float spread) {
    LET_REF(MaterialRecord) material = load_material(load_instance(hit.instance).material);
    RayCone cone;
    cone.width = spread * hit.t;
    cone.spread = spread;
    Surface s = load_surface(hit, direction, cone, SURFACE_UV);
    if (!(spread > 0.0f)) { s.lod = FINEST_LEVEL; }
    vec3 color = read_base_color(material, s, 0.5f);
    if ((material.flags & MATERIAL_EMISSIVE) != 0u) { color += read_emission(material, s, 0.5f); }
    return color;
}

// Radiance from a direction of the world; `spread`: how wide the ray is, as in RayCone. Out of
// line: scenes without sky geometry must not pay.
OUT_OF_LINE vec3 sky_background(vec3 direction, float spread) {
    LET_REF(FrameConstants) f = load_frame();
    if ((f.sky & SKY_TRACED) != 0u) {
        Ray ray;
        ray.origin = f.sky_viewer;
        ray.direction = direction;
        ray.t_min = 0.0f;
        ray.t_max = FLOAT_MAX;
        Hit hit = trace_sky(ray);
        if (hit.instance != HIT_NOTHING) { return sky_geometry_color(hit, direction, spread); }
    }
    if (f.background_image == 0u) { return f.background_color; }
    vec2 uv = environment_uv_from_direction(environment_from_world(f, direction));
    return f.background_color * load_background(uv);
}

// One texel of a cube of all directions: the mean of samples * samples rays through it.
vec3 sky_cube_texel(uint face, uvec2 texel, uint size, uint samples) {
    float n = float(samples);
    vec3 sum = vec3(0.0f);
    for (uint i = 0u; i < samples * samples; ++i) {
        vec2 st = vec2(float(texel.x) + (float(i % samples) + 0.5f) / n,
                       float(texel.y) + (float(i / samples) + 0.5f) / n) / float(size);
        sum += sky_background(normalize(cube_direction(face, st)), 2.0f / (n * float(size)));
    }
    return sum / (n * n);
}

#endif
