// The method that counting came from, for comparison: binomial numbers in cells of position times
// slope, of the levels next to the footprint's size.
// Based on: Zirr and Kaplanyan 2016, "Real-time Rendering of Procedural Multiscale Materials", I3D.
// What we do otherwise: cells of slope space are those of counting.glsl (deviations of a Gaussian,
// one level by the pixel's kernel) in place of the paper's map of half vectors; a footprint has a
// level along each texture axis. What it has of its own: each cell draws its count by itself and
// pixels mix the cells' densities, so that variance is lost between cells and long footprints that
// lie askew are widened; a normal number rounded to a count above zero has a mean of up to 4 % too
// much (docs/water.md).
#ifndef GP_SHADING_GLINT_ZIRR_GLSL
#define GP_SHADING_GLINT_ZIRR_GLSL
#include "shading/glint/counting.glsl"

// One hit at most where less than one is expected, else a rounded normal number.
float zirr_facets(float n, float hit, uint bits, uint normal_bits) {
    float mean = n * hit;
    if (mean < 1.0f) { return float(bits) * 2.3283064e-10f < mean ? 1.0f : 0.0f; }
    float count = mean + sqrt(mean * max(1.0f - hit, 0.0f)) * counting_normal(normal_bits);
    return max(floor(count + 0.5f), 0.0f);
}

// The share of a cell's n facets that reflects.
float zirr_cell(IN(CountingFootprint) f, uvec3 id, float n) {
    uvec3 own = hash_u32x3(id);
    float level = floor(f.slope_level + 0.5f);
    vec2 s = floor(f.slope * counting_power_of_two(-level)
                   + vec2(float(own.y & 0xFFFFu), float(own.z & 0xFFFFu)) * (1.0f / 65536.0f));
    uvec3 random = hash_u32x3(uvec3(uint(int(s.x)), uint(int(s.y)),
                                    own.x ^ (uint(int(level)) * 0x9E3779B9u)));
    float facets = n * counting_unevenness(f.jitter, own.y ^ (own.z >> 7u));
    return zirr_facets(facets, f.hit, random.x, random.y) / facets;
}

// Four cells of one grid, of these levels (log2 of a cell's size) along u and v.
float zirr_grid(IN(CountingFootprint) f, vec2 level, float density, float weight) {
    if (weight <= 0.0f) { return 0.0f; }
    vec2 size = vec2(counting_power_of_two(level.x), counting_power_of_two(level.y));
    vec2 at = f.uv / size - vec2(0.5f);
    vec2 base = clamp(floor(at), vec2(-1.0e9f), vec2(1.0e9f));
    vec2 w = clamp(at - base, vec2(0.0f), vec2(1.0f));
    uint x = uint(int(base.x));
    uint y = uint(int(base.y));
    uint key = hash_u32(f.seed ^ (uint(int(level.x)) * 0x85EBCA6Bu)
                        ^ (uint(int(level.y)) * 0xC2B2AE35u) ^ 0x5A17u);
    float n = density * (size.x * size.y);
    float low = mix(zirr_cell(f, uvec3(x, y, key), n), zirr_cell(f, uvec3(x + 1u, y, key), n), w.x);
    float high = mix(zirr_cell(f, uvec3(x, y + 1u, key), n),
                     zirr_cell(f, uvec3(x + 1u, y + 1u, key), n), w.x);
    return weight * mix(low, high, w.y);
}

// Density of slopes at s, as glint_p22.
float glint_zirr_p22(IN(Glint) g, vec2 s) {
    float smooth_p22 = slopes_p22(g.slopes, s);
    float density = counting_density(g);
    if (!(smooth_p22 > 0.0f && density > 0.0f)) { return smooth_p22; }
    CountingFootprint f = counting_footprint(g, s, smooth_p22);
    if (!(f.facets * f.hit < 1.0e6f)) { return smooth_p22; }
    vec2 a = footprint_bounded2(g.d0, 1.0e9f);
    vec2 b = footprint_bounded2(g.d1, 1.0e9f);
    float spacing = inversesqrt(density);
    // Half a level finer than the ellipse's extent: linear reads are wider than their cells.
    vec2 level = vec2(log2(max(sqrt(a.x * a.x + b.x * b.x), spacing)),
                      log2(max(sqrt(a.y * a.y + b.y * b.y), spacing))) - vec2(0.5f);
    vec2 low = floor(level);
    vec2 w = level - low;
    float found = zirr_grid(f, low, density, (1.0f - w.x) * (1.0f - w.y))
                + zirr_grid(f, low + vec2(1.0f, 0.0f), density, w.x * (1.0f - w.y))
                + zirr_grid(f, low + vec2(0.0f, 1.0f), density, (1.0f - w.x) * w.y)
                + zirr_grid(f, low + vec2(1.0f), density, w.x * w.y);
    return mix(smooth_p22, found / f.slope_area, clamp(g.area, 0.0f, 1.0f));
}

#endif
