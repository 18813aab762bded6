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
    s.low_cells = ellipse_of(p.footprint, uv, glint_cells_per_unit(p, level), GLINT_FILTER);
    s.high_cells = ellipse_of(p.footprint, uv, glint_cells_per_unit(p, level + 1),
                              GLINT_FILTER);
    s.share = p.level - float(level);
    return s;
}

// Cells that one turn of the loops below takes, and the most that a footprint has of them.
#define GLINT_BLOCK 16
#define GLINT_MOST_CELLS 112

// The mean over the cells of both levels, weighted within each and then by the levels' shares:
// rows of cells, then cells in blocks, in three steps each: hashes, look-ups along both axes, sums.
// All are loops that compilers turn into vectors. Out of line: then there is one copy, and
// compilers have no reason to leave a part of it scalar.
OUT_OF_LINE float glint_mean_of_cells(IN(GlintQuery) q, IN(GlintSteps) s) {
    int lefts[GLINT_MOST_CELLS + GLINT_BLOCK];  // x less the number of the cell: one for a row
    int ys[GLINT_MOST_CELLS + GLINT_BLOCK];
    int count = 0;
    int low_count = 0;
    int low_rows = ellipse_rows(s.low_cells);
    int rows_left = low_rows + (s.share > 0.0f ? ellipse_rows(s.high_cells) : 0);
    for (int first = 0; first < rows_left; first += 8) {
        int starts[8];
        int ends[8];
        for (int i = 0; i < 8; ++i) {
            int r = first + i;
            int on_high = int(r >= low_rows);
            EllipseRow row = ellipse_row(s.low_cells, s.low_cells.first + r);
            EllipseRow high = ellipse_row(s.high_cells, s.high_cells.first + r - low_rows);
            starts[i] = row.start + on_high * (high.start - row.start);
            ends[i] = row.end + on_high * (high.end - row.end);
        }
        for (int i = 0; i < min(8, rows_left - first); ++i) {
            int r = first + i;
            low_count = r == low_rows ? count : low_count;
            int y = r < low_rows ? s.low_cells.first + r : s.high_cells.first + r - low_rows;
            int left = starts[i] - count;
            int end = min(count + ends[i] - starts[i] + 1, GLINT_MOST_CELLS);
            for (; count < end; count += 8) {
                for (int k = 0; k < 8; ++k) {
                    lefts[count + k] = left;
                    ys[count + k] = y;
                }
            }
            count = end;
        }
    }
    low_count = rows_left == low_rows ? count : low_count;
    for (int k = 0; k < GLINT_BLOCK; ++k) {
        lefts[count + k] = lefts[0] - count;
        ys[count + k] = ys[0];
    }
    float sum_low = 0.0f;
    float sum_high = 0.0f;
    float all_low = 0.0f;
    float all_high = 0.0f;
    for (int first = 0; first < count; first += GLINT_BLOCK) {
        float low[GLINT_BLOCK];
        float high[GLINT_BLOCK];
        float shares[GLINT_BLOCK];
        uint rows[2 * GLINT_BLOCK];
        float places[2 * GLINT_BLOCK];
        float kernels[2 * GLINT_BLOCK];
        for (int i = 0; i < GLINT_BLOCK; ++i) {
            int k = first + i;
            int x = lefts[k] + k;
            int y = ys[k];
            int coarse = int(k >= low_count);
            low[i] = ellipse_weight(s.low_cells, x, y) * float(1 - coarse);
            high[i] = ellipse_weight(s.high_cells, x, y) * float(coarse * int(k < count));
            GlintCell c = glint_cell(glint_level_between(s.low, s.high, float(coarse)), x, y);
            shares[i] = c.share;
            rows[i] = c.row_x;
            rows[i + GLINT_BLOCK] = c.row_y;
            places[i] = abs(c.turn.c * q.slope.x + c.turn.s * q.slope.y);
            places[i + GLINT_BLOCK] = abs(c.turn.c * q.slope.y - c.turn.s * q.slope.x);
            kernels[i] = glint_kernel_along(q, c.turn.c, c.turn.s);
            kernels[i + GLINT_BLOCK] = glint_kernel_along(q, -c.turn.s, c.turn.c);
        }
        float densities[2 * GLINT_BLOCK];
        if (q.blurred) {
            for (int i = 0; i < 2 * GLINT_BLOCK; ++i) {
                densities[i] = glint_marginal(q.table, rows[i], glint_width(kernels[i]), places[i]);
            }
        } else {
            for (int i = 0; i < 2 * GLINT_BLOCK; ++i) {
                densities[i] = glint_marginal_sharp(q.table, rows[i], places[i]);
            }
        }
        for (int i = 0; i < GLINT_BLOCK; ++i) {
            float facets = densities[i] * densities[i + GLINT_BLOCK] * q.scale;
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
    // So far from the mean no cell has facets, whichever way it is turned; a 10^-7 of the Gaussian
    // lies there, and stays.
    if (!(dot(q.slope, q.slope) < 2.0f * GLINT_REACH * GLINT_REACH)) {
        return dot(q.slope, q.slope) < 1.0e30f ? q.gaussian : 0.0f;
    }
    GlintPyramid p = glint_pyramid(g);
    if (p.smooth_only) {
        return q.gaussian;
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
    for (int y = e.first; y <= e.last; ++y) {
        EllipseRow row = ellipse_row(e, y);
        for (int x = row.start; x <= row.end; ++x) {
            total += ellipse_weight(e, x, y);
        }
    }
    GlintChoice chosen;
    chosen.x = int(floor(e.centre.x + 0.5f));
    chosen.y = int(floor(e.centre.y + 0.5f));
    chosen.u = 0.0f;
    float left = u * total;
    for (int y = e.first; y <= e.last; ++y) {
        EllipseRow row = ellipse_row(e, y);
        for (int x = row.start; x <= row.end; ++x) {
            float weight = ellipse_weight(e, x, y);
            if (left < weight) {
                chosen.x = x;
                chosen.y = y;
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
