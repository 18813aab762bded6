// Glints by counting: how many of the facets under a footprint reflect is a binomial number, drawn
// by hashes at a fixed cost of 4 x 3 cells of grids that follow the footprint's shape.
// Based on: Deliot and Belcour 2023, "Real-Time Rendering of Glinty Appearances using Distributed
// Binomial Laws on Anisotropic Grids", HPG. What we do otherwise:
// - the number of facets is that of the footprint itself, shared out over all cells by their
//   weights (grids, simplex and slope cells alike): sums of binomial numbers are binomial, so that
//   mean and variance hold everywhere; the paper mixes results of simplex and slope cells, which
//   takes variance away;
// - one conditional law (counting_facets) whose mean is exact for any count, whole or not;
// - a triangulation of ratio and direction times levels by a staircase (counting_corner) in place
//   of tables of tetrahedra;
// - slopes about any mean and covariance; what a pixel sees of the half vectors (k0, k1) widens the
//   facets; hashes in place of a texture of noise.
// A pixel's own integral over slopes is random: 1 on average only (docs/water.md).
#ifndef GP_SHADING_GLINT_COUNTING_GLSL
#define GP_SHADING_GLINT_COUNTING_GLSL
#include "shading/glint/glint.glsl"
#include "shading/sampling/hash.glsl"
#include "shading/slope/footprint.glsl"
#include "shading/trigonometry.glsl"

// The slopes of one facet, as a share of all slopes' deviation: that of the dictionary's lobes.
#define COUNTING_LOBE 0.0566f
// Grids are longer than wide by 2^0 … 2^6; longer footprints are read as wider ones.
#define COUNTING_MAX_RATIO 6.0f

// What all cells of a footprint have in common.
struct CountingFootprint {
    vec2 uv;
    vec2 slope;         // in cells of slope space, mirrored into one quadrant: symmetric
    float slope_level;  // log2 of the slope cells' size where a pixel's kernel is wider
    float facets;       // under the footprint
    float hit;          // probability that one of them reflects
    float slope_area;   // of the slopes over which a facet does
    float major;        // of the footprint, never below the spacing of facets
    float minor;
    float turn;         // direction of the long axis, in half turns, 0 … 1
    float jitter;
    uint seed;
};

// A normal number from the bits of a hash: four bytes' sum, up to 3.5 deviations.
float counting_normal(uint bits) {
    uint sum = (bits & 255u) + ((bits >> 8u) & 255u) + ((bits >> 16u) & 255u) + (bits >> 24u);
    return (float(sum) - 510.0f) * (1.0f / 147.80f);
}

// 2^n for a whole number n between -126 and 127.
float counting_power_of_two(float n) {
    return uintBitsToFloat(uint(int(n) + 127) << 23u);
}

// How many of n facets are hit, each with this probability: 0, or else a normal number of the mean
// and variance that the binomial has above 0. [Deliot and Belcour 2023, section 4.2]
float counting_facets(float n, float hit, uint gate_bits, uint normal_bits) {
    // (1 - hit)^n = e^-x as (1 + x / 8)^-8, and 1 minus that without cancellation. The mean stays
    // exact whatever stands for it.
    float x = n * hit * (1.0f + 0.5f * hit);
    float q = 1.0f / (1.0f + 0.125f * x);
    float q2 = q * q;
    float q4 = q2 * q2;
    float none = q4 * q4;
    float some = 0.125f * x * q * (1.0f + q) * (1.0f + q2) * (1.0f + q4);
    float mean = n * hit / max(some, 1.0e-30f);
    float variance = mean * max(1.0f - hit - mean * none, 0.0f);
    // A soft edge, as wide as leaves the mean alone: facets fade in and out.
    float width = max(0.25f * min(some, none), 1.0e-9f);
    float u = float(gate_bits) * 2.3283064e-10f;
    float gate = clamp((some + width - u) / (2.0f * width), 0.0f, 1.0f);
    // Cut on both sides alike, which keeps the mean too.
    float count = clamp(mean + sqrt(variance) * counting_normal(normal_bits), 0.0f, 2.0f * mean);
    return gate * count;
}

// Facets of one cell over their mean number there, from bits of its hash.
// [Chermain et al. 2020, section 4.3: densities are log-normal, in levels of 4]
float counting_unevenness(float jitter, uint bits) {
    if (!(jitter > 0.0f)) { return 1.0f; }
    return exp(clamp(1.38629436f * jitter * counting_normal(bits), -20.0f, 20.0f));
}

// The share of the facets of one cell (weight: its share of the footprint) that reflects, over
// four cells of slopes. id: of the cell and its grid.
float counting_cell(IN(CountingFootprint) f, uvec3 id, float weight) {
    if (weight <= 0.0f) { return 0.0f; }
    uvec3 own = hash_u32x3(id);
    // Each cell changes to larger slope cells at a time of its own.
    float level = floor(f.slope_level + float(own.x & 0xFFFFu) * (1.0f / 65536.0f));
    vec2 s = f.slope * counting_power_of_two(-level)
           + vec2(float(own.y & 0xFFFFu), float(own.z & 0xFFFFu)) * (1.0f / 65536.0f);
    vec2 corner = floor(s);
    vec2 w = s - corner;
    uint x = uint(int(corner.x));
    uint y = uint(int(corner.y));
    uint stream = own.x ^ (uint(int(level)) * 0x9E3779B9u);
    float density = counting_unevenness(f.jitter, own.y ^ (own.z >> 7u));
    float n = f.facets * density * weight;
    // A loop that compilers turn into vectors.
    float counts[4];
    for (uint i = 0u; i < 4u; ++i) {
        float right = float(i & 1u);
        float up = float(i >> 1u);
        uvec3 random = hash_u32x3(uvec3(x + (i & 1u), y + (i >> 1u), stream));
        float share = mix(1.0f - w.x, w.x, right) * mix(1.0f - w.y, w.y, up);
        counts[i] = counting_facets(n * share, f.hit, random.x, random.y);
    }
    return (counts[0] + counts[1] + counts[2] + counts[3]) / (f.facets * density);
}

// The cells of one grid about the footprint: the corners of a triangle of the simplex grid.
// ring: log2 of length over width; spoke of `spokes`: its direction, in 1/spokes of half a turn;
// level: log2 of the width.
float counting_grid(IN(CountingFootprint) f, float ring, float spoke, float spokes, float level,
                    float weight) {
    if (weight <= 0.0f) { return 0.0f; }
    SinCos turn = sincos_turns(0.5f * spoke / spokes);
    vec2 at = vec2(turn.c * f.uv.x + turn.s * f.uv.y, turn.c * f.uv.y - turn.s * f.uv.x);
    at = vec2(at.x * counting_power_of_two(-ring), at.y) * counting_power_of_two(-level);
    // [Perlin 2001, "Noise Hardware": squares skewed into triangles]
    vec2 skewed = vec2(at.x - 0.57735027f * at.y, 1.15470054f * at.y);
    // Far beyond what floats tell apart, all is one cell.
    vec2 base = clamp(floor(skewed), vec2(-1.0e9f), vec2(1.0e9f));
    vec2 w = clamp(skewed - base, vec2(0.0f), vec2(1.0f));
    uint x = uint(int(base.x));
    uint y = uint(int(base.y));
    uint key = hash_u32(f.seed ^ (uint(int(level)) * 0x85EBCA6Bu)
                        ^ ((uint(int(ring)) * 64u + uint(int(spoke))) * 0xC2B2AE35u));
    bool upper = w.x + w.y > 1.0f;
    uint o = upper ? 1u : 0u;
    vec2 v = upper ? vec2(1.0f) - w : w;
    return counting_cell(f, uvec3(x + o, y + o, key), weight * max(1.0f - v.x - v.y, 0.0f))
         + counting_cell(f, uvec3(x + 1u - o, y + o, key), weight * v.x)
         + counting_cell(f, uvec3(x + o, y + 1u - o, key), weight * v.y);
}

// A corner of the triangulation of ratio and direction: both levels of it. `above` is the share of
// the upper level that earlier corners have not used up: of the six corners of the prism four have
// weights, those of one tetrahedron: they fill up from the first corner on, like a staircase.
float counting_corner(IN(CountingFootprint) f, float ring, float spoke, float level, float weight,
                      float above) {
    float spokes = ring > 0.0f ? exp2(ring + 1.0f) : 1.0f;
    float k = spoke - spokes * floor(spoke / spokes);
    float upper = clamp(above, 0.0f, weight);
    return counting_grid(f, ring, k, spokes, level, weight - upper)
         + counting_grid(f, ring, k, spokes, level + 1.0f, upper);
}

// The grids around a footprint: rings of ratios, with twice as many directions on each next one.
float counting_grids(IN(CountingFootprint) f, float ratio, float turn, float level) {
    float ring = min(floor(ratio), COUNTING_MAX_RATIO - 1.0f);
    float out_share = ratio - ring;
    float bottom = floor(level);
    float above = level - bottom;
    if (ring <= 0.0f) {
        // Around the centre, which has no direction, a fan.
        float t = 4.0f * turn;
        float k = min(floor(t), 3.0f);
        float w1 = out_share * (1.0f - (t - k));
        float w2 = out_share * (t - k);
        // Neighbouring triangles must see their common corners in the same order.
        bool swapped = k == 3.0f;
        float first = swapped ? w2 : w1;
        return counting_corner(f, 0.0f, 0.0f, bottom, 1.0f - out_share, above)
             + counting_corner(f, 1.0f, swapped ? 0.0f : k, bottom, first,
                               above - (1.0f - out_share))
             + counting_corner(f, 1.0f, swapped ? 3.0f : k + 1.0f, bottom, swapped ? w1 : w2,
                               above - (1.0f - out_share) - first);
    }
    float spokes = exp2(ring + 1.0f);
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
    if (inside) {
        float low = last ? b_weight : a_weight;
        float high = last ? a_weight : b_weight;
        return counting_corner(f, ring, last ? 0.0f : a_spoke, bottom, low, above)
             + counting_corner(f, ring, last ? a_spoke : b_spoke, bottom, high, above - low)
             + counting_corner(f, ring + 1.0f, c_spoke, bottom, middle_weight,
                               above - a_weight - b_weight);
    }
    // Spoke 2 k, or 2 (k + 1) where that wraps to 0, comes before 2 k + 1.
    bool b_first = left || last;
    float low = b_first ? b_weight : middle_weight;
    return counting_corner(f, ring, a_spoke, bottom, a_weight, above)
         + counting_corner(f, ring + 1.0f, b_first ? b_spoke : c_spoke, bottom, low,
                           above - a_weight)
         + counting_corner(f, ring + 1.0f, b_first ? c_spoke : b_spoke, bottom,
                           b_first ? middle_weight : b_weight, above - a_weight - low);
}

// Facets per area of uv, after the share of the surface that has any.
float counting_density(IN(Glint) g) {
    return exp(clamp(g.log_density, -40.0f, 60.0f)) * clamp(g.area, 0.0f, 1.0f);
}

// smooth_p22: density of all slopes at s, above 0.
CountingFootprint counting_footprint(IN(Glint) g, vec2 s, float smooth_p22) {
    // A facet reflects into the pixel over its own slopes and those that the pixel's half vectors
    // have. That area, 4 pi times the deviations' product, is as large as a Gaussian's square is.
    float own = COUNTING_LOBE * COUNTING_LOBE;
    float xx = own * g.slopes.var_x + (g.k0.x * g.k0.x + g.k1.x * g.k1.x) * (1.0f / 12.0f);
    float yy = own * g.slopes.var_y + (g.k0.y * g.k0.y + g.k1.y * g.k1.y) * (1.0f / 12.0f);
    float xy = own * g.slopes.cov + (g.k0.x * g.k0.y + g.k1.x * g.k1.y) * (1.0f / 12.0f);
    float spread = sqrt(g.slopes.var_x * g.slopes.var_y - g.slopes.cov * g.slopes.cov);
    float lobe = max(sqrt(max(xx * yy - xy * xy, 0.0f)), own * spread);
    CountingFootprint f;
    f.slope_area = 2.0f * TWO_PI * min(lobe, 0.5f * spread);
    f.slope_level = max(0.5f * log2(min(lobe, 0.5f * spread) / (own * spread)), 0.0f);
    f.hit = min(smooth_p22 * f.slope_area, 1.0f);
    // Deviations by the Cholesky factor, in cells as large as a facet's own slopes.
    vec2 c = s - g.slopes.mean;
    float l_xx = sqrt(g.slopes.var_x);
    float across = (c.y - c.x * g.slopes.cov / g.slopes.var_x) * l_xx / spread;
    f.slope = vec2(abs(c.x) / l_xx, abs(across)) * (1.0f / (3.5449077f * COUNTING_LOBE));
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

// Density of the slopes of a footprint's facets at s, as glint_p22. Whoever samples draws from
// g.slopes, whose density is its mean over all surfaces.
float glint_counting_p22(IN(Glint) g, vec2 s) {
    float smooth_p22 = slopes_p22(g.slopes, s);
    if (!(smooth_p22 > 0.0f && counting_density(g) > 0.0f)) { return smooth_p22; }
    CountingFootprint f = counting_footprint(g, s, smooth_p22);
    // So many that their number says no more than its mean: 0.1 % of deviation.
    if (!(f.facets * f.hit < 1.0e6f)) { return smooth_p22; }
    float found = counting_grids(f, log2(f.major / f.minor), f.turn, log2(f.minor));
    return mix(smooth_p22, found / f.slope_area, clamp(g.area, 0.0f, 1.0f));
}

#endif
