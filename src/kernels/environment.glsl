// Light from infinitely far: reading it, choosing a direction, the density of that choice.
// The tables are larger than caches and read at random, so whoever knows early what it will read
// says so, and does other work until then.
// Resources: load_frame, load_environment (bilinear), load_environment_cell,
// load_environment_density; prefetch_environment, prefetch_environment_cell and
// prefetch_environment_density, which may do nothing.
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
    vec2 uv;    // where environment_radiance_at finds the radiance
};

vec3 environment_radiance_at(vec2 uv) {
    LET_REF(FrameConstants) f = load_frame();
    return f.environment_cells == 0u ? f.environment_color
                                     : f.environment_color * load_environment(uv);
}

// environment_sample will be called with the same numbers.
void environment_expect_sample(vec2 u) {
    LET_REF(FrameConstants) f = load_frame();
    if (f.environment_cells == 0u) { return; }
    prefetch_environment_cell(alias_pick(u, f.environment_cells * f.environment_cells).index);
}

// [Walker 1974, "New Fast Method for Generating Discrete Random Numbers"]: one look-up, whatever
// the size. Nearby numbers u.x lead to nearby cells, so that stratified numbers stay stratified
// over the sphere. The radiance is left to the caller, and on its way.
EnvironmentSample environment_sample(vec2 u) {
    LET_REF(FrameConstants) f = load_frame();
    EnvironmentSample s;
    if (f.environment_cells == 0u) {
        s.wi = square_to_uniform_sphere(u);
        s.pdf = INV_FOUR_PI;
        s.uv = vec2(0.0f);
        return s;
    }
    float n = float(f.environment_cells);
    AliasPick pick = alias_pick(u, f.environment_cells * f.environment_cells);
    LET_REF(EnvironmentCell) entry = load_environment_cell(pick.index);
    bool keeps = pick.rest < entry.keep;
    float stretched =
        keeps ? pick.rest / entry.keep : (pick.rest - entry.keep) / (1.0f - entry.keep);
    uint index = keeps ? pick.index : entry.alias;
    uvec2 cell = cell_from_morton(index);
    s.uv = vec2((float(cell.x) + min(stretched, ONE_MINUS_EPSILON)) / n,
                (float(cell.y) + pick.row) / n);
    prefetch_environment(s.uv);
    vec3 direction = environment_direction_from_uv(s.uv);
    s.wi = world_from_environment(f, direction);
    s.pdf = environment_pdf_from_uv_pdf(load_environment_density(index), direction);
    return s;
}

// Radiance from a direction of the world, and how likely environment_sample would have chosen it.
struct EnvironmentLight {
    vec3 radiance;
    float pdf;  // 1/sr; 0 where it was not asked for
};

uint environment_cell_at(vec2 uv, uint side) {
    return morton_from_cell(min(uvec2(uv * float(side)), uvec2(side - 1u)));
}

EnvironmentLight environment_light(vec3 direction, bool with_pdf) {
    LET_REF(FrameConstants) f = load_frame();
    EnvironmentLight light;
    light.radiance = f.environment_color;
    light.pdf = with_pdf ? INV_FOUR_PI : 0.0f;
    if (f.environment_cells == 0u) { return light; }
    vec3 d = environment_from_world(f, direction);
    vec2 uv = environment_uv_from_direction(d);
    light.radiance = environment_radiance_at(uv);
    if (with_pdf) {
        float uv_pdf = load_environment_density(environment_cell_at(uv, f.environment_cells));
        light.pdf = environment_pdf_from_uv_pdf(uv_pdf, d);
    }
    return light;
}

// environment_light may be called with the same direction.
void environment_expect_light(vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    if (f.environment_cells == 0u) { return; }
    vec2 uv = environment_uv_from_direction(environment_from_world(f, direction));
    prefetch_environment(uv);
    prefetch_environment_density(environment_cell_at(uv, f.environment_cells));
}

#endif
