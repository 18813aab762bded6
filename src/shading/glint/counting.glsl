// Glints by counting: how many of the facets under a footprint reflect is a binomial number, drawn
// by hashes at a fixed cost: 12 cells of grids that follow the footprint's shape, and in each of
// them one way down a tree over slopes (facet_tree.glsl).
// Based on: Deliot and Belcour 2023, "Real-Time Rendering of Glinty Appearances using Distributed
// Binomial Laws on Anisotropic Grids", HPG. What we do otherwise:
// - the number of facets is that of the footprint itself, shared out over all cells by their
//   weights (grids and simplex cells alike): sums of binomial numbers are binomial, so that mean
//   and variance hold everywhere; the paper mixes results of simplex and slope cells, which takes
//   variance away;
// - the facets of a cell are shared out among all slopes by a tree, in place of cells of slopes
//   that know nothing of each other: what one slope has others have not, and facets can be drawn;
// - a triangulation of ratio and direction times levels by a staircase (counting_cells) in place
//   of tables of tetrahedra;
// - slopes about any mean and covariance; what a pixel sees of the half vectors (k0, k1) widens the
//   facets; hashes in place of a texture of noise.
// Cells with less than about one facet have it by chance: of footprints with few facets (below
// about 50) the integral over slopes is random, and 1 on average.
#ifndef GP_SHADING_GLINT_COUNTING_GLSL
#define GP_SHADING_GLINT_COUNTING_GLSL
#include "shading/glint/facet_tree.glsl"
#include "shading/glint/glint.glsl"
#include "shading/slope/footprint.glsl"

// The slopes of one facet, as a share of all slopes' deviation: that of the dictionary's lobes. As
// a Gaussian it counts as a square of sqrt(4 pi) times that, FACET_TREE_CELL.
#define COUNTING_LOBE 0.0566f
// Grids are longer than wide by 2^0 … 2^6; longer footprints are read as wider ones.
#define COUNTING_MAX_RATIO 6.0f
// So many facets that their number says no more than its mean: 0.1 % of deviation at the brightest.
#define COUNTING_MOST_FACETS 1.5e8f

// What all cells of a footprint have in common.
struct CountingFootprint {
    vec2 uv;
    float facets;   // under the footprint
    float major;    // of the footprint, never below the spacing of facets
    float minor;
    float turn;     // direction of the long axis, in half turns, 0 … 1
    float coarser;  // log2 of the slope cells' size where a pixel's kernel is wider than facets
    float jitter;
    uint seed;
};

// A normal number from the bits of a hash: four bytes' sum, up to 3.5 deviations.
float counting_normal(uint bits) {
    uint sum = (bits & 255u) + ((bits >> 8u) & 255u) + ((bits >> 16u) & 255u) + (bits >> 24u);
    return (float(sum) - 510.0f) * (1.0f / 147.80f);
}

// Facets of one cell over their mean number there, from bits of its hash.
// [Chermain et al. 2020, section 4.3: densities are log-normal, in levels of 4]
float counting_unevenness(float jitter, uint bits) {
    if (!(jitter > 0.0f)) { return 1.0f; }
    return exp(clamp(1.38629436f * jitter * counting_normal(bits), -20.0f, 20.0f));
}

// Directions of a ring, twice as many on each next one.
float counting_spokes(float ring) {
    return ring > 0.0f ? exp2(ring + 1.0f) : 1.0f;
}

// Three points of the triangulation of ratio and direction about a footprint, with their weights,
// in an order that neighbouring triangles share: by ring, then by spoke.
struct CountingTriangle {
    vec3 rings;
    vec3 spokes;
    vec3 weights;
};

// Around the centre, which has no direction, a fan.
CountingTriangle counting_fan(float out_share, float turn) {
    float t = 4.0f * turn;
    float k = min(floor(t), 3.0f);
    float w1 = out_share * (1.0f - (t - k));
    float w2 = out_share * (t - k);
    bool swapped = k == 3.0f;
    CountingTriangle c;
    c.rings = vec3(0.0f, 1.0f, 1.0f);
    c.spokes = vec3(0.0f, swapped ? 0.0f : k, swapped ? 3.0f : k + 1.0f);
    c.weights = vec3(1.0f - out_share, swapped ? w2 : w1, swapped ? w1 : w2);
    return c;
}

CountingTriangle counting_triangle(float ratio, float turn) {
    float ring = min(floor(ratio), COUNTING_MAX_RATIO - 1.0f);
    float out_share = ratio - ring;
    if (ring <= 0.0f) { return counting_fan(out_share, turn); }
    float spokes = counting_spokes(ring);
    float t = turn * spokes;
    float k = min(floor(t), spokes - 1.0f);
    t -= k;
    // Of the strip between spokes k and k + 1: a triangle with its base inside, or one of the two
    // beside it with their bases outside.
    bool left = 2.0f * t < out_share;
    bool right = 2.0f * (1.0f - t) < out_share;
    float middle_weight = left ? 2.0f * t : right ? 2.0f * (1.0f - t) : out_share;
    bool inside = !left && !right;
    bool last = k == spokes - 1.0f;
    // Corner a is inside, c outside in the middle of the strip, b the third; by ring, then spoke.
    float a_spoke = right ? k + 1.0f : k;
    float a_weight = inside ? 1.0f - t - 0.5f * out_share : 1.0f - out_share;
    float b_spoke = inside ? k + 1.0f : left ? 2.0f * k : 2.0f * k + 2.0f;
    float b_weight = inside ? t - 0.5f * out_share : out_share - middle_weight;
    float c_spoke = 2.0f * k + 1.0f;
    CountingTriangle c;
    if (inside) {
        c.rings = vec3(ring, ring, ring + 1.0f);
        c.spokes = vec3(last ? 0.0f : a_spoke, last ? a_spoke : b_spoke, c_spoke);
        c.weights = vec3(last ? b_weight : a_weight, last ? a_weight : b_weight, middle_weight);
        return c;
    }
    // Spoke 2 k, or 2 (k + 1) where that wraps to 0, comes before 2 k + 1.
    bool b_first = left || last;
    c.rings = vec3(ring, ring + 1.0f, ring + 1.0f);
    c.spokes = vec3(a_spoke, b_first ? b_spoke : c_spoke, b_first ? c_spoke : b_spoke);
    c.weights = vec3(a_weight, b_first ? b_weight : middle_weight,
                     b_first ? middle_weight : b_weight);
    return c;
}

// The cells of one grid about the footprint: the corners of a triangle of the simplex grid.
struct CountingGrid {
    uvec3 first;  // x, y and the grid's key
    uint x1;      // of the second, and y of the third
    uint y2;
    vec3 shares;  // of the grid
};

// ring: log2 of length over width; spoke: its direction, in 1 / counting_spokes of half a turn;
// level: log2 of the width.
CountingGrid counting_grid(IN(CountingFootprint) f, float ring, float spoke, float level) {
    float spokes = counting_spokes(ring);
    float k = spoke - spokes * floor(spoke / spokes);
    SinCos turn = sincos_turns(0.5f * k / spokes);
    vec2 at = vec2(turn.c * f.uv.x + turn.s * f.uv.y, turn.c * f.uv.y - turn.s * f.uv.x);
    at = vec2(at.x * exp2_whole(-ring), at.y) * exp2_whole(-level);
    // [Perlin 2001, "Noise Hardware": squares skewed into triangles]
    vec2 skewed = vec2(at.x - 0.57735027f * at.y, 1.15470054f * at.y);
    // Far beyond what floats tell apart, all is one cell.
    vec2 base = clamp(floor(skewed), vec2(-1.0e9f), vec2(1.0e9f));
    vec2 w = clamp(skewed - base, vec2(0.0f), vec2(1.0f));
    uint x = uint(int(base.x));
    uint y = uint(int(base.y));
    bool upper = w.x + w.y > 1.0f;
    uint o = upper ? 1u : 0u;
    vec2 v = upper ? vec2(1.0f) - w : w;
    CountingGrid c;
    c.first = uvec3(x + o, y + o, hash_u32(f.seed ^ (uint(int(level)) * 0x85EBCA6Bu)
                    ^ ((uint(int(ring)) * 64u + uint(int(k))) * 0xC2B2AE35u)));
    c.x1 = x + 1u - o;
    c.y2 = y + 1u - o;
    c.shares = vec3(max(1.0f - v.x - v.y, 0.0f), v.x, v.y);
    return c;
}

// All cells of a footprint: the triangle's points at both levels about its width. Of these six
// corners of a prism four have weights, those of one tetrahedron: the upper ones fill up from the
// first corner on, like a staircase.
FacetTrees counting_cells(IN(CountingFootprint) f) {
    CountingTriangle c = counting_triangle(log2(f.major / f.minor), f.turn);
    float level = log2(f.minor);
    float bottom = floor(level);
    float above = level - bottom;
    FacetTrees trees = facet_trees_none(f.coarser);
    for (int i = 0; i < 6; ++i) {
        int corner = i >> 1;
        float whole = max(c.weights[corner], 0.0f);
        float upper = clamp(above, 0.0f, whole);
        float weight = (i & 1) == 0 ? whole - upper : upper;
        above -= (i & 1) == 0 ? 0.0f : c.weights[corner];
        // Rounding can leave a weight at a fifth corner, which does not count.
        if (!(weight > 0.0f) || trees.used + 3 > FACET_TREES) { continue; }
        CountingGrid grid = counting_grid(f, c.rings[corner], c.spokes[corner],
                                          bottom + float(i & 1));
        for (int v = 0; v < 3; ++v) {
            uvec3 id = grid.first;
            id.x = v == 1 ? grid.x1 : id.x;
            id.y = v == 2 ? grid.y2 : id.y;
            uvec3 own = hash_u32x3(id);
            float share = weight * grid.shares[v];
            float uneven = counting_unevenness(f.jitter, own.y ^ (own.z >> 7u));
            trees.keys[trees.used + v] = own.x;
            trees.counts[trees.used + v] = facet_trees_quadrant(f.facets * share * uneven);
            trees.weights[trees.used + v] = share;
        }
        trees.used += 3;
    }
    return trees;
}

// Facets per area of uv, after the share of the surface that has any.
float counting_density(IN(Glint) g) {
    return exp(clamp(g.log_density, -40.0f, 60.0f)) * clamp(g.area, 0.0f, 1.0f);
}

CountingFootprint counting_footprint(IN(Glint) g, IN(Slopes) d) {
    // A facet reflects into the pixel over its own slopes and those that the pixel's half vectors
    // have. That area, 4 pi times the deviations' product, is as large as a Gaussian's square is.
    float own = COUNTING_LOBE * COUNTING_LOBE;
    float xx = own * d.var_x + (g.k0.x * g.k0.x + g.k1.x * g.k1.x) * (1.0f / 12.0f);
    float yy = own * d.var_y + (g.k0.y * g.k0.y + g.k1.y * g.k1.y) * (1.0f / 12.0f);
    float xy = own * d.cov + (g.k0.x * g.k0.y + g.k1.x * g.k1.y) * (1.0f / 12.0f);
    float spread = own * sqrt(max(d.var_x * d.var_y - d.cov * d.cov, 1.0e-30f));
    CountingFootprint f;
    f.coarser = glint_limited(
        0.5f * log2(max(sqrt(max(xx * yy - xy * xy, 0.0f)), spread) / spread), 0.0f, 4.0f);
    // Below one facet a pixel sees that facet, as large as it is.
    float density = counting_density(g);
    float spacing = inversesqrt(density);
    FootprintEllipse e = footprint_ellipse(g.d0, g.d1);
    f.major = max(e.major, spacing);
    f.minor = max(max(e.minor, spacing), f.major * exp2(-COUNTING_MAX_RATIO));
    f.facets = density * (f.major * f.minor);
    float turn = 2.0f * turns_from_vector(e.axis.y, e.axis.x);
    f.turn = turn - floor(turn);
    f.uv = footprint_bounded2(g.uv, 1.0e9f);
    f.jitter = clamp(g.jitter, 0.0f, 8.0f);
    f.seed = g.seed;
    return f;
}

// What a pixel's facets are at a slope, and over all slopes: that is what is reflected too much or
// too little where facets are there by chance.
struct CountedFacets {
    float p22;
    float whole;
};

CountedFacets counted_smooth(float smooth_p22) {
    CountedFacets c;
    c.p22 = smooth_p22;
    c.whole = 1.0f;
    return c;
}

// The facets of trees beside the part of the surface that is smooth.
CountedFacets counted_facets(IN(Glint) g, IN(Slopes) d, IN(FacetTrees) trees, vec2 s,
                             float smooth_p22) {
    float area = clamp(g.area, 0.0f, 1.0f);
    FacetShare share = facet_trees_at(trees, whitened(whitening_of(d), s - d.mean));
    CountedFacets c;
    c.p22 = smooth_p22 * (1.0f + area * (share.at - 1.0f));
    c.whole = 1.0f + area * (share.whole - 1.0f);
    return c;
}

// A slope with the density p22 / whole of counted_facets, and without facets the smooth one.
vec2 counted_sample(IN(Glint) g, IN(Slopes) d, IN(FacetTrees) trees, vec2 u, float u_way) {
    float area = clamp(g.area, 0.0f, 1.0f);
    float facets = area * facet_trees_whole(trees);
    FacetChoice c = facet_choose(u_way, 1.0f - area, facets);
    if (!(facets > 0.0f) || !c.second) { return slopes_sample(d, u); }
    return d.mean + unwhitened(whitening_of(d), facet_trees_sample(trees, u, c.u));
}

// Density of the slopes of a footprint's facets at s. Finite and >= 0 whatever the input.
CountedFacets glint_counting(IN(Glint) g, vec2 s) {
    Slopes d = glint_slopes_within(g);
    float smooth_p22 = slopes_p22(d, s);
    if (!(smooth_p22 > 0.0f && counting_density(g) > 0.0f)) { return counted_smooth(smooth_p22); }
    CountingFootprint f = counting_footprint(g, d);
    if (!(f.facets < COUNTING_MOST_FACETS)) { return counted_smooth(smooth_p22); }
    return counted_facets(g, d, counting_cells(f), s, smooth_p22);
}

// As glint_sample: a slope with the density p22 / whole of glint_counting (where `whole` is 0, the
// smooth one), symmetric about the mean. All numbers uniform in [0, 1).
vec2 glint_counting_sample(IN(Glint) g, vec2 u, float u_way) {
    Slopes d = glint_slopes_within(g);
    if (!(counting_density(g) > 0.0f)) { return slopes_sample(d, u); }
    CountingFootprint f = counting_footprint(g, d);
    if (!(f.facets < COUNTING_MOST_FACETS)) { return slopes_sample(d, u); }
    return counted_sample(g, d, counting_cells(f), u, u_way);
}

#endif
