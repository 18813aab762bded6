// Glints: the slopes of the single facets that a footprint holds. A surface of countable facets has
// the distribution of its slopes only on average; what a pixel sees are the facets in it.
//
// A virtual pyramid of cells covers the surface; each cell has facets of its own, of a dictionary
// (cells.glsl, dictionary.glsl), and a pixel sees the mean over the cells of its footprint, between
// two levels of the pyramid. Means of densities are densities: they integrate to 1 whatever the
// footprint. All cells are symmetric about the mean slope, as sheared_cavity.glsl wants them.
// Conventions of slopes are those of slope/slopes.glsl: the frame is that of the geometry.
// Based on: Chermain et al. 2020, "Procedural Physically based BRDF for Real-Time Rendering of
// Glints", and 2021, "Real-Time Geometric Glint Anti-Aliasing with Normal Map Filtering".
#ifndef GP_SHADING_GLINT_GLINT_GLSL
#define GP_SHADING_GLINT_GLINT_GLSL
#include "shading/glint/cells.glsl"
#include "shading/glint/description.glsl"
#include "shading/glint/footprint.glsl"

// The pyramid under a footprint.
struct GlintPyramid {
    GlintFootprint footprint;
    float base;    // log2 of the side of cells of level 0, in units of uv
    float level;   // between which two levels, >= 0
    float facets;  // logarithm to base 4 of the facets in a cell of level 0
    float spread;
    float area;
    bool smooth_only;  // nothing but the Gaussian
};

GlintPyramid glint_pyramid(IN(Glint) g) {
    GlintPyramid p;
    p.footprint = glint_footprint(g.d0, g.d1);
    float log4_density = (0.5f * 1.44269504f) * glint_limited(
        g.log_density, -GLINT_LARGEST_LOG_DENSITY, GLINT_LARGEST_LOG_DENSITY);
    p.area = glint_limited(g.area, 0.0f, 1.0f);
    p.base = floor(-log4_density);
    p.level = max(log2(max(p.footprint.minor, 1.0e-30f)) - p.base, 0.0f);
    p.facets = log4_density + p.base;
    p.spread = glint_limited(g.jitter, 0.0f, GLINT_LARGEST_JITTER) * 3.46410162f;
    // As many facets in every cell as the last level stands for, or numbers that are none.
    float fewest = p.facets + floor(p.level) - 0.5f * p.spread
                 + 0.5f * log2(max(p.area, GLINT_LEAST_AREA));
    bool places = abs(g.uv.x) < 1.0e30f && abs(g.uv.y) < 1.0e30f && p.footprint.minor < 1.0e15f;
    p.smooth_only = !(places && fewest < float(GLINT_LEVELS) && g.log_density == g.log_density)
                 || p.area < GLINT_LEAST_AREA || !table_exists(g.dictionary);
    return p;
}

// One of the two levels.
GlintLevel glint_level(IN(GlintPyramid) p, int level, uint seed) {
    GlintLevel l;
    l.shift = uint(min(level, 31));
    // Facets of the share: a cell with less than one has them with that probability, but then a
    // larger share of it; the mean share is `area` either way.
    float cell = p.facets + float(level);
    float expected = exp2(2.0f * min(cell, 16.0f)) * p.area;
    l.occupied = clamp(expected, p.area, 1.0f);
    l.share = p.area / l.occupied;
    l.facets = max(cell + 0.5f * log2(p.area), 0.0f);
    l.spread = p.spread;
    l.seed = seed;
    return l;
}

float glint_cells_per_unit(IN(GlintPyramid) p, int level) {
    return exp2(-(p.base + float(level)));
}

// The two levels of a footprint.
struct GlintSteps {
    GlintLevel low;
    GlintLevel high;
    Ellipse low_cells;
    Ellipse high_cells;
    float share;  // of the high one; 0: there is none
};

GlintSteps glint_steps(IN(GlintPyramid) p, vec2 uv, uint seed) {
    int level = int(p.level);
    GlintSteps s;
    s.low = glint_level(p, level, seed);
    s.high = glint_level(p, level + 1, seed);
    s.low_cells = ellipse_of(p.footprint, uv, glint_cells_per_unit(p, level));
    s.high_cells = ellipse_of(p.footprint, uv, glint_cells_per_unit(p, level + 1));
    s.share = p.level - float(level);
    return s;
}

// The mean over the cells of both levels, weighted within each and then by the levels' shares. It
// takes 16 of them at a time and in three steps, each a loop that compilers turn into vectors:
// hashes, look-ups along both axes, sums. Out of line: then there is one copy, and compilers have
// no reason to leave a part of it scalar.
OUT_OF_LINE float glint_mean_of_cells(IN(GlintQuery) q, IN(GlintSteps) s) {
    float sum_low = 0.0f;
    float sum_high = 0.0f;
    float all_low = 0.0f;
    float all_high = 0.0f;
    Ellipse e = s.low_cells;
    int level = 0;
    ivec3 row = ellipse_first_row(e);
    while (level < 2) {
        int xs[24];
        int ys[24];
        float levels[24];
        for (int i = 0; i < 16; ++i) {
            xs[i] = 0;
            ys[i] = 0;
            levels[i] = 0.0f;
        }
        int count = 0;
        while (count < 16 && level < 2) {
            for (int i = 0; i < 8; ++i) {
                xs[count + i] = row.x + i;
                ys[count + i] = row.z;
                levels[count + i] = float(level);
            }
            int taken = clamp(row.y - row.x + 1, 0, min(16 - count, 8));
            count += taken;
            row.x += taken;
            if (row.x > row.y) {
                row = ellipse_row(e, row.z + 1);
                if (row.z > e.last) {
                    level += s.share > 0.0f ? 1 : 2;
                    e = s.high_cells;
                    row = ellipse_first_row(e);
                }
            }
        }
        float low[16];
        float high[16];
        float shares[16];
        uint rows[32];
        float places[32];
        float kernels[32];
        for (int i = 0; i < 16; ++i) {
            float known = float(i < count);
            low[i] = ellipse_weight(s.low_cells, xs[i], ys[i]) * (1.0f - levels[i]) * known;
            high[i] = ellipse_weight(s.high_cells, xs[i], ys[i]) * levels[i] * known;
            GlintCell c = glint_cell(glint_level_between(s.low, s.high, levels[i]), xs[i], ys[i]);
            shares[i] = c.share;
            rows[i] = c.row_x;
            rows[i + 16] = c.row_y;
            places[i] = abs(c.turn.c * q.slope.x + c.turn.s * q.slope.y);
            places[i + 16] = abs(c.turn.c * q.slope.y - c.turn.s * q.slope.x);
            kernels[i] = glint_kernel_along(q, c.turn.c, c.turn.s);
            kernels[i + 16] = glint_kernel_along(q, -c.turn.s, c.turn.c);
        }
        float densities[32];
        if (q.blurred) {
            for (int i = 0; i < 32; ++i) {
                densities[i] = glint_marginal(q.table, rows[i], glint_width(kernels[i]), places[i]);
            }
        } else {
            for (int i = 0; i < 32; ++i) {
                densities[i] = glint_marginal_sharp(q.table, rows[i], places[i]);
            }
        }
        for (int i = 0; i < 16; ++i) {
            float facets = densities[i] * densities[i + 16] * q.scale;
            float value = q.gaussian + shares[i] * (facets - q.gaussian);
            sum_low += low[i] * value;
            sum_high += high[i] * value;
            all_low += low[i];
            all_high += high[i];
        }
    }
    float mean = sum_low / all_low;
    return s.share > 0.0f ? mean + s.share * (sum_high / all_high - mean) : mean;
}

GlintQuery glint_query(IN(Glint) g, IN(Slopes) d, IN(Whitening) w, vec2 s) {
    GlintQuery q;
    q.table = g.dictionary;
    q.slope = whitened(w, s - d.mean);
    float deviation = sqrt(NDF_PIXEL_VARIANCE);
    q.k0 = whitened(w, g.k0 * deviation);
    q.k1 = whitened(w, g.k1 * deviation);
    q.blurred = !(g.k0 == vec2(0.0f, 0.0f) && g.k1 == vec2(0.0f, 0.0f));
    q.scale = w.xx * w.yy;
    q.gaussian = slopes_p22(d, s);
    return q;
}

// Density of slopes (not centred) over the footprint, per horizontal area. Finite and >= 0 whatever
// the input; 0 for slopes that are not finite.
float glint_p22(IN(Glint) g, vec2 s) {
    Slopes d = glint_slopes_within(g);
    GlintQuery q = glint_query(g, d, whitening_of(d), s);
    GlintPyramid p = glint_pyramid(g);
    bool known = abs(q.slope.x) < 1.0e15f && abs(q.slope.y) < 1.0e15f;
    if (p.smooth_only || !known) {
        return known ? q.gaussian : 0.0f;
    }
    return glint_mean_of_cells(q, glint_steps(p, g.uv, g.seed));
}

// The cell of an ellipse that a uniform number falls into, by their weights; and the number again,
// uniform within it.
struct GlintChoice {
    int x;
    int y;
    float u;
};

GlintChoice glint_choose_cell(IN(Ellipse) e, float u) {
    float total = 0.0f;
    for (ivec3 row = ellipse_first_row(e); row.z <= e.last; row = ellipse_row(e, row.z + 1)) {
        for (int x = row.x; x <= row.y; ++x) {
            total += ellipse_weight(e, x, row.z);
        }
    }
    GlintChoice chosen;
    chosen.x = int(floor(e.centre.x + 0.5f));
    chosen.y = int(floor(e.centre.y + 0.5f));
    chosen.u = 0.0f;
    float left = u * total;
    for (ivec3 row = ellipse_first_row(e); row.z <= e.last; row = ellipse_row(e, row.z + 1)) {
        for (int x = row.x; x <= row.y; ++x) {
            float weight = ellipse_weight(e, x, row.z);
            if (left < weight) {
                chosen.x = x;
                chosen.y = row.z;
                chosen.u = left / weight;
                return chosen;
            }
            left -= weight;
        }
    }
    return chosen;
}

// A slope with the density glint_p22, which is symmetric about g.slopes.mean. All numbers uniform
// in [0, 1); u_cell chooses level, cell and part.
vec2 glint_sample(IN(Glint) g, vec2 u, float u_cell) {
    Slopes d = glint_slopes_within(g);
    GlintPyramid p = glint_pyramid(g);
    if (p.smooth_only) {
        return slopes_sample(d, u);
    }
    GlintSteps s = glint_steps(p, g.uv, g.seed);
    bool next = u_cell < s.share;
    u_cell = next ? u_cell / s.share : (u_cell - s.share) / (1.0f - s.share);
    GlintChoice chosen = glint_choose_cell(next ? s.high_cells : s.low_cells, u_cell);
    GlintCell cell = glint_cell(next ? s.high : s.low, chosen.x, chosen.y);
    if (chosen.u >= cell.share) {
        return slopes_sample(d, u);
    }
    Whitening w = whitening_of(d);
    GlintQuery q = glint_query(g, d, w, d.mean);
    return d.mean + unwhitened(w, glint_cell_sample(q, cell, u));
}

#endif
