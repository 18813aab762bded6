// An image of slope moments under a pixel's footprint (shading/slope/lean.glsl).
// Resources: load_slope_map (its size), load_slopes (a texel of a level, wrapped as it says).
#ifndef GP_KERNELS_SLOPE_MAP_GLSL
#define GP_KERNELS_SLOPE_MAP_GLSL
#include "shading/slope/lean.glsl"
#include "shared/scene_structs.glsl"

// One level, bilinear; exact for the moments, which four plain reads of raw ones would give.
Slopes read_slope_level(uint map, IN(SlopeMapSize) size, int level, vec2 uv) {
    int w = max(int(size.width >> uint(level)), 1);
    int h = max(int(size.height >> uint(level)), 1);
    float x = uv.x * float(w) - 0.5f;
    float y = uv.y * float(h) - 0.5f;
    int ix = int(floor(x));
    int iy = int(floor(y));
    float fx = x - float(ix);
    Slopes top = slopes_mixed(load_slopes(map, level, ix, iy),
                              load_slopes(map, level, ix + 1, iy), fx);
    Slopes low = slopes_mixed(load_slopes(map, level, ix, iy + 1),
                              load_slopes(map, level, ix + 1, iy + 1), fx);
    return slopes_mixed(top, low, y - float(iy));
}

// d0, d1: change of uv per pixel along its two axes.
Slopes read_slope_map(uint map, vec2 uv, vec2 d0, vec2 d1) {
    SlopeMapSize size = load_slope_map(map);
    SlopeProbes probes = slope_probes(d0, d1, vec2(float(size.width), float(size.height)));
    float finest = min(floor(probes.level), float(size.levels) - 1.0f);
    float share = finest + 1.0f < float(size.levels) ? probes.level - finest : 0.0f;
    // Far outside, float coordinates lose the texel: two whole repeats change nothing, and they
    // keep NaN out of integers.
    vec2 first = size.repeats != 0u ? uv - 2.0f * floor(0.5f * uv) : uv;
    first = footprint_bounded2(first, 1.0e3f) - probes.step * (0.5f * float(probes.count - 1));
    Slopes all = slopes_constant(vec2(0.0f));
    for (int i = 0; i < probes.count; ++i) {
        vec2 at = first + probes.step * float(i);
        Slopes one = read_slope_level(map, size, int(finest), at);
        if (share > 0.0f) {
            one = slopes_mixed(one, read_slope_level(map, size, int(finest) + 1, at), share);
        }
        all = slopes_mixed(all, one, 1.0f / float(i + 1));
    }
    return all;
}

#endif
