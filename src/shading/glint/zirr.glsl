// The method that counting came from, for comparison: binomial numbers in cells of position times
// slope, of the levels next to the footprint's size.
// Based on: Zirr and Kaplanyan 2016, "Real-time Rendering of Procedural Multiscale Materials", I3D.
// What we do otherwise: cells of slope space are those of facet_tree.glsl in place of the paper's
// map of half vectors; a footprint has a level along each texture axis. What it has of its own:
// each cell draws its count by itself and pixels mix the cells' densities, so that variance is lost
// between cells and long footprints that lie askew are widened (docs/water.md).
#ifndef GP_SHADING_GLINT_ZIRR_GLSL
#define GP_SHADING_GLINT_ZIRR_GLSL
#include "shading/glint/counting.glsl"

// Cells as large as the footprint along u and v, four each of the four grids about that size.
FacetTrees zirr_cells(IN(Glint) g, IN(CountingFootprint) f) {
    float density = counting_density(g);
    vec2 a = footprint_bounded2(g.d0, 1.0e9f);
    vec2 b = footprint_bounded2(g.d1, 1.0e9f);
    float spacing = inversesqrt(density);
    // Half a level finer than the ellipse's extent: linear reads are wider than their cells.
    vec2 level = vec2(log2(max(sqrt(a.x * a.x + b.x * b.x), spacing)),
                      log2(max(sqrt(a.y * a.y + b.y * b.y), spacing))) - vec2(0.5f);
    vec2 low = floor(level);
    vec2 between = level - low;
    FacetTrees trees = facet_trees_none(f.coarser);
    for (uint i = 0u; i < 16u; ++i) {
        vec2 up = vec2(float((i >> 2u) & 1u), float(i >> 3u));
        vec2 right = vec2(float(i & 1u), float((i >> 1u) & 1u));
        vec2 size = vec2(exp2_whole(low.x + up.x), exp2_whole(low.y + up.y));
        vec2 at = f.uv / size - vec2(0.5f);
        vec2 base = clamp(floor(at), vec2(-1.0e9f), vec2(1.0e9f));
        vec2 w = clamp(at - base, vec2(0.0f), vec2(1.0f));
        w = vec2(mix(1.0f - w.x, w.x, right.x), mix(1.0f - w.y, w.y, right.y));
        w *= vec2(mix(1.0f - between.x, between.x, up.x), mix(1.0f - between.y, between.y, up.y));
        uint key = hash_u32(f.seed ^ (uint(int(low.x + up.x)) * 0x85EBCA6Bu)
                            ^ (uint(int(low.y + up.y)) * 0xC2B2AE35u) ^ 0x5A17u);
        uvec3 own = hash_u32x3(uvec3(uint(int(base.x)) + (i & 1u),
                                     uint(int(base.y)) + ((i >> 1u) & 1u), key));
        float uneven = counting_unevenness(f.jitter, own.y ^ (own.z >> 7u));
        trees.keys[i] = own.x;
        trees.counts[i] = facet_trees_quadrant(density * (size.x * size.y) * uneven);
        trees.weights[i] = w.x * w.y;
    }
    trees.used = 16;
    return trees;
}

// As glint_counting.
CountedFacets glint_zirr(IN(Glint) g, vec2 s) {
    Slopes d = glint_slopes_within(g);
    float smooth_p22 = slopes_p22(d, s);
    if (!(smooth_p22 > 0.0f && counting_density(g) > 0.0f)) { return counted_smooth(smooth_p22); }
    CountingFootprint f = counting_footprint(g, d);
    if (!(f.facets < COUNTING_MOST_FACETS)) { return counted_smooth(smooth_p22); }
    return counted_facets(g, d, zirr_cells(g, f), s, smooth_p22);
}

// As glint_counting_sample.
vec2 glint_zirr_sample(IN(Glint) g, vec2 u, float u_way) {
    Slopes d = glint_slopes_within(g);
    if (!(counting_density(g) > 0.0f)) { return slopes_sample(d, u); }
    CountingFootprint f = counting_footprint(g, d);
    if (!(f.facets < COUNTING_MOST_FACETS)) { return slopes_sample(d, u); }
    return counted_sample(g, d, zirr_cells(g, f), u, u_way);
}

#endif
