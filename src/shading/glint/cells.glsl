// A cell of the glint pyramid: from its place to its own distribution of slopes.
//
// Cells of level 0 are the area of about one facet, those of level l are 2^l times as wide. A cell
// takes its random numbers from the place of its lower left corner, so that it shares them with one
// of the four cells below and one above it: glints stay while the level changes.
// Based on: Chermain et al. 2020, "Procedural Physically based BRDF for Real-Time Rendering of
// Glints", section 4; the anchoring at the density and the shares of area below 1 are ours.
#ifndef GP_SHADING_GLINT_CELLS_GLSL
#define GP_SHADING_GLINT_CELLS_GLSL
#include "shading/glint/description.glsl"
#include "shading/glint/dictionary.glsl"
#include "shading/sampling/hash.glsl"
#include "shading/trigonometry.glsl"

// What the cells of one level have in common.
struct GlintLevel {
    uint shift;      // to the cells of level 0
    float facets;    // logarithm to base 4 of the facets in a cell that has any
    float spread;    // of the density jitter, between its extremes
    float occupied;  // share of cells with facets
    float share;     // of such a cell's area that carries them
    uint seed;
};

// One of two, in loops: number by number, for a reference to either would be a branch.
IN_LOOPS GlintLevel glint_level_either(IN(GlintLevel) a, IN(GlintLevel) b, bool second) {
    GlintLevel l = a;
    l.shift = second ? b.shift : a.shift;
    l.facets = second ? b.facets : a.facets;
    l.occupied = second ? b.occupied : a.occupied;
    l.share = second ? b.share : a.share;
    return l;
}

// One cell.
struct GlintCell {
    uint row_x;   // of the dictionary
    uint row_y;
    SinCos turn;  // of the axes
    float share;  // of facets; 0: smooth
};

// 16 random bits as a number.
IN_LOOPS float glint_bits(uint bits) {
    return float(int(bits & 65535u)) * (1.0f / 65536.0f);
}

IN_LOOPS GlintCell glint_cell(IN(GlintLevel) level, int x, int y) {
    uvec3 h = hash_u32x3(uvec3(uint(x) << level.shift, uint(y) << level.shift, level.seed));
    // Between two levels of the dictionary cells take either, by the fraction: no level where all
    // of them change at once.
    float l = level.facets + level.spread * (glint_bits(h.x) - 0.5f) + glint_bits(h.x >> 16u);
    int at = max(int(l), 0);
    GlintCell c;
    // Integers for conditions: no branches, so that compilers make vectors of it.
    int facets = int(at < GLINT_LEVELS) & int(glint_bits(h.y) < level.occupied);
    c.share = level.share * float(facets);
    uint row = uint(min(at, GLINT_LEVELS - 1));
    uint entries = glint_entries(row) - 1u;
    // The lower bits say the row, the ones above which of its children: a cell with fewer facets
    // that has the numbers of this one has facets of this one.
    c.row_x = glint_row(row, (h.z >> 6u) & entries);
    c.row_y = glint_row(row, (h.z >> 22u) & entries);
    // A quarter turn would do no more than exchange the rows.
    c.turn = sincos_eighth(0.25f * glint_bits(h.y >> 16u) - 0.125f);
    return c;
}

// What is asked of all cells of a footprint.
struct GlintQuery {
    uvec2 table;
    vec2 slope;     // whitened
    vec2 k0;        // the kernel, whitened, in standard deviations
    vec2 k1;
    float scale;    // from products of what is read of the table to densities of slopes
    float gaussian; // the smooth density at the slope
};

// Variance of the kernel along a direction of the whitened slopes.
IN_LOOPS float glint_kernel_along(IN(GlintQuery) q, float x, float y) {
    float a = q.k0.x * x + q.k0.y * y;
    float b = q.k1.x * x + q.k1.y * y;
    return a * a + b * b;
}

// A whitened slope out of a cell's facets, u uniform. Their density is the product of the marginals
// along both axes, even in both, hence symmetric.
vec2 glint_cell_sample(IN(GlintQuery) q, IN(GlintCell) c, vec2 u) {
    float along = glint_marginal_sample(
        q.table, c.row_x, glint_width(glint_kernel_along(q, c.turn.c, c.turn.s)), u.x);
    float across = glint_marginal_sample(
        q.table, c.row_y, glint_width(glint_kernel_along(q, -c.turn.s, c.turn.c)), u.y);
    return vec2(c.turn.c * along - c.turn.s * across, c.turn.s * along + c.turn.c * across);
}

#endif
