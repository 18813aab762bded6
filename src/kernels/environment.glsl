// Light from infinitely far: reading it, choosing a direction, the density of that choice.
// Resources: load_frame, load_environment (bilinear), load_environment_row_cdf, _column_cdf, _row_guide,
// _column_guide.
#ifndef GP_KERNELS_ENVIRONMENT_GLSL
#define GP_KERNELS_ENVIRONMENT_GLSL
#include "shading/constants.glsl"
#include "shading/light/environment.glsl"
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

vec3 environment_radiance(vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    if (f.environment_width == 0u) { return f.environment_color; }
    return f.environment_color * load_environment(environment_uv_from_direction(environment_from_world(f, direction)));
}

struct EnvironmentSample {
    vec3 wi;
    float pdf;  // 1/sr
};

// The cell of a row or column whose cumulative values hold u, and where in it.
float environment_search_row(float u, uint n) {
    uint cell = load_environment_row_guide(min(uint(u * float(n)), n - 1u));
    while (cell + 1u < n && load_environment_row_cdf(cell + 1u) <= u) { cell += 1u; }
    float lo = load_environment_row_cdf(cell);
    float hi = load_environment_row_cdf(cell + 1u);
    return float(cell) + clamp((u - lo) / max(hi - lo, 1.0e-20f), 0.0f, ONE_MINUS_EPSILON);
}

float environment_search_column(uint row, float u, uint n) {
    uint cell = load_environment_column_guide(row, min(uint(u * float(n)), n - 1u));
    while (cell + 1u < n && load_environment_column_cdf(row, cell + 1u) <= u) { cell += 1u; }
    float lo = load_environment_column_cdf(row, cell);
    float hi = load_environment_column_cdf(row, cell + 1u);
    return float(cell) + clamp((u - lo) / max(hi - lo, 1.0e-20f), 0.0f, ONE_MINUS_EPSILON);
}

// Density over the sphere of the cell (column, row). A cell's rows are chosen uniformly in the cosine of
// the polar angle, so that the density is constant over it.
float environment_cell_pdf(IN(FrameConstants) f, uint column, uint row) {
    float p_row = load_environment_row_cdf(row + 1u) - load_environment_row_cdf(row);
    float p_column = load_environment_column_cdf(row, column + 1u) - load_environment_column_cdf(row, column);
    float h = float(f.environment_height);
    float height_cos = cos(PI * float(row) / h) - cos(PI * float(row + 1u) / h);
    float width_phi = TWO_PI / float(f.environment_width);
    return p_row * p_column / (height_cos * width_phi);
}

EnvironmentSample environment_sample(vec2 u) {
    LET_REF(FrameConstants) f = load_frame();
    EnvironmentSample s;
    if (f.environment_width == 0u) {
        s.wi = square_to_uniform_sphere(u);
        s.pdf = INV_FOUR_PI;
        return s;
    }
    float y = environment_search_row(u.y, f.environment_height);
    uint row = min(uint(y), f.environment_height - 1u);
    float x = environment_search_column(row, u.x, f.environment_width);
    uint column = min(uint(x), f.environment_width - 1u);
    float h = float(f.environment_height);
    float c = mix(cos(PI * float(row) / h), cos(PI * float(row + 1u) / h), y - float(row));
    float v = acos(clamp(c, -1.0f, 1.0f)) * INV_PI;
    s.wi = world_from_environment(f, environment_direction_from_uv(vec2(x / float(f.environment_width), v)));
    s.pdf = environment_cell_pdf(f, column, row);
    return s;
}

float environment_pdf(vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    if (f.environment_width == 0u) { return INV_FOUR_PI; }
    vec2 uv = environment_uv_from_direction(environment_from_world(f, direction));
    uint column = min(uint(uv.x * float(f.environment_width)), f.environment_width - 1u);
    uint row = min(uint(uv.y * float(f.environment_height)), f.environment_height - 1u);
    return environment_cell_pdf(f, column, row);
}

#endif
