// Light from infinitely far: reading it, choosing a direction, the density of that choice.
// Resources: load_frame, load_environment (bilinear), load_environment_cell.
#ifndef GP_KERNELS_ENVIRONMENT_GLSL
#define GP_KERNELS_ENVIRONMENT_GLSL
#include "shading/constants.glsl"
#include "shading/light/environment.glsl"
#include "shading/sampling/alias.glsl"
#include "shading/sampling/morton.glsl"
#include "shading/sampling/warps.glsl"
#include "shared/scene_structs.glsl"

// World to the image's own axes: the environment is turned about +Y.
vec3 environment_from_world(IN(FrameConstants) f, vec3 d) {
    return vec3(f.environment_cos * d.x - f.environment_sin * d.z, d.y,
                f.environment_sin * d.x + f.environment_cos * d.z);
}

vec3 world_from_environment(IN(FrameConstants) f, vec3 d) {
    return vec3(f.environment_cos * d.x + f.environment_sin * d.z, d.y,
                -f.environment_sin * d.x + f.environment_cos * d.z);
}

struct EnvironmentSample {
    vec3 wi;
    float pdf;  // 1/sr
    vec3 radiance;
};

// [Walker 1974, "New Fast Method for Generating Discrete Random Numbers"]: one look-up, whatever
// the size. Nearby numbers u.x lead to nearby cells, so that stratified numbers stay stratified
// over the sphere.
EnvironmentSample environment_sample(vec2 u) {
    LET_REF(FrameConstants) f = load_frame();
    EnvironmentSample s;
    if (f.environment_cells == 0u) {
        s.wi = square_to_uniform_sphere(u);
        s.pdf = INV_FOUR_PI;
        s.radiance = f.environment_color;
        return s;
    }
    float n = float(f.environment_cells);
    AliasPick pick = alias_pick(u, f.environment_cells * f.environment_cells);
    LET_REF(EnvironmentCell) entry = load_environment_cell(pick.index);
    bool keeps = pick.rest < entry.keep;
    float stretched =
        keeps ? pick.rest / entry.keep : (pick.rest - entry.keep) / (1.0f - entry.keep);
    uvec2 cell = cell_from_morton(keeps ? pick.index : entry.alias);
    vec2 uv = vec2((float(cell.x) + min(stretched, ONE_MINUS_EPSILON)) / n,
                   (float(cell.y) + pick.row) / n);
    vec3 direction = environment_direction_from_uv(uv);
    s.wi = world_from_environment(f, direction);
    s.pdf = environment_pdf_from_uv_pdf(keeps ? entry.pdf : entry.alias_pdf, direction);
    s.radiance = f.environment_color * load_environment(uv);
    return s;
}

// What comes from a direction of the image's own axes.
vec3 environment_radiance(vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    if (f.environment_cells == 0u) { return f.environment_color; }
    return f.environment_color * load_environment(environment_uv_from_direction(direction));
}

// How likely environment_sample would have chosen that direction, 1/sr.
float environment_pdf(vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    if (f.environment_cells == 0u) { return INV_FOUR_PI; }
    vec2 scaled = environment_uv_from_direction(direction) * float(f.environment_cells);
    uvec2 cell = min(uvec2(scaled), uvec2(f.environment_cells - 1u));
    float uv_pdf = load_environment_cell(morton_from_cell(cell)).pdf;
    return environment_pdf_from_uv_pdf(uv_pdf, direction);
}

#endif
