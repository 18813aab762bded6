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
#include "shading/powers.glsl"

// The pyramid under a footprint.
struct GlintPyramid {
    GlintFootprint footprint;
    float base;    // log2 of the side of cells of level 0, in units of uv
    float level;   // the lower of two levels, a whole number >= 0
    float share;   // of the next one
    float facets;  // logarithm to base 4 of the facets in a cell of level 0
    float spread;
    float area;
    float log4_area;
    bool smooth_only;  // nothing but the Gaussian
};

float glint_cells_per_unit(IN(GlintPyramid) p, int level) {
    return exp2_whole(-(p.base + float(level)));
}

GlintPyramid glint_pyramid(IN(Glint) g) {
    GlintPyramid p;
    p.footprint = glint_footprint(g.d0, g.d1);
    float log4_density = (0.5f * 1.44269504f) * glint_limited(
        g.log_density, -GLINT_LARGEST_LOG_DENSITY, GLINT_LARGEST_LOG_DENSITY);
    p.area = glint_limited(g.area, 0.0f, 1.0f);
    p.base = floor(-log4_density);
    // The level from the exponent and how far it is to the next from the logarithm: cells need not
    // wait for that.
    float minor2 = max(p.footprint.minor2, 1.0e-37f);
    p.level = max(float(log4_floor(minor2)) - p.base, 0.0f);
    float cells = glint_cells_per_unit(p, int(p.level));
    p.share = clamp(0.5f * log2_above_0(max(minor2 * cells * cells, 1.0e-30f)), 0.0f, 1.0f);
    p.facets = log4_density + p.base;
    p.spread = glint_limited(g.jitter, 0.0f, GLINT_LARGEST_JITTER) * 3.46410162f;
    p.log4_area = 0.5f * log2_above_0(max(p.area, GLINT_LEAST_AREA));
    // As many facets in every cell as the last level stands for, or numbers that are none.
    float fewest = p.facets + p.level - 0.5f * p.spread + p.log4_area;
    fewest += 0.0f * g.log_density;  // not a number where the density is none
    // Reasons are counted: of conditions that stand together compilers make branches.
    float reasons = fewest < float(GLINT_LEVELS) ? 0.0f : 1.0f;
    reasons += p.area >= GLINT_LEAST_AREA ? 0.0f : 1.0f;
    reasons += abs(g.uv.x) + abs(g.uv.y) < 1.0e30f ? 0.0f : 1.0f;
    reasons += p.footprint.minor2 < 1.0e30f ? 0.0f : 1.0f;
    reasons += table_exists(g.dictionary) ? 0.0f : 1.0f;
    p.smooth_only = reasons > 0.0f;
    return p;
}

// One of the two levels.
GlintLevel glint_level(IN(GlintPyramid) p, int level, uint seed) {
    GlintLevel l;
    l.shift = uint(min(level, 31));
    // Facets of the share: a cell with less than one has them with that probability, but then a
    // larger share of it; the mean share is `area` either way.
    float cell = p.facets + float(level);
    float expected = exp2_within_126(2.0f * min(cell, 16.0f)) * p.area;
    l.occupied = clamp(expected, p.area, 1.0f);
    l.share = p.area / l.occupied;
    l.facets = max(cell + p.log4_area, 0.0f);
    l.spread = p.spread;
    l.seed = seed;
    return l;
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
    s.share = p.share;
    return s;
}

// Cells that one turn of the loop below takes, and the most rows and cells of a row that a
// footprint has, by GLINT_ANISOTROPY.
#define GLINT_BLOCK 8
#define GLINT_MOST_ROWS 24
#define GLINT_LONGEST_ROW 16

// The mean over the cells of both levels, weighted within each and then by the levels' shares:
// rows of cells, then cells in blocks, in three steps each: hashes and where both axes are looked
// up, look-ups, sums. All but the look-ups are loops that compilers turn into vectors; what these
// choose from must be local, as a reference would be a branch. Out of line: then there is one copy,
// and compilers have no reason to leave a part of it scalar.
OUT_OF_LINE float glint_mean_of_cells(IN(GlintQuery) q, IN(GlintSteps) s) {
    GlintLevel low_level = s.low;
    GlintLevel high_level = s.high;
    Ellipse low_cells = s.low_cells;
    Ellipse high_cells = s.high_cells;
    int low_rows = ellipse_rows(low_cells);
    int rows = min(low_rows + (s.share > 0.0f ? ellipse_rows(high_cells) : 0), GLINT_MOST_ROWS);
    int high_first = high_cells.first - low_rows;
    // Of each cell the number of its row in 5 bits, and above them its x less its own number, which
    // is the same for all of a row.
    int places[GLINT_MOST_ROWS * GLINT_LONGEST_ROW + GLINT_BLOCK];
    int count = 0;
    for (int first = 0; first < rows; first += 8) {
        int starts[8];
        int lengths[8];
        for (int i = 0; i < 8; ++i) {
            int r = first + i;
            bool coarse = r >= low_rows;
            EllipseRow row = ellipse_row(ellipse_either(low_cells, high_cells, coarse),
                                         r + (coarse ? high_first : low_cells.first));
            starts[i] = (row.start << 5u) + r;
            lengths[i] = min(max(row.end - row.start + 1, 0), GLINT_LONGEST_ROW) * int(r < rows);
        }
        // More than a row has is written over by the next.
        for (int i = 0; i < 8; ++i) {
            int place = starts[i] - (count << 5u);
            for (int k = 0; k < 8; ++k) {
                places[count + k] = place;
            }
            if (lengths[i] > 8) {
                for (int k = 8; k < GLINT_LONGEST_ROW; ++k) {
                    places[count + k] = place;
                }
            }
            count += lengths[i];
        }
    }
    for (int k = 0; k < GLINT_BLOCK; ++k) {
        places[count + k] = places[0];
    }
    float trace = dot(q.k0, q.k0) + dot(q.k1, q.k1);  // along any two axes at a right angle
    float scale = q.scale;
    float all_low[GLINT_BLOCK];  // weights, a sum for each place in a block
    float all_high[GLINT_BLOCK];
    float sum_low[GLINT_BLOCK];  // weighted
    float sum_high[GLINT_BLOCK];
    for (int i = 0; i < GLINT_BLOCK; ++i) {
        all_low[i] = 0.0f;
        all_high[i] = 0.0f;
        sum_low[i] = 0.0f;
        sum_high[i] = 0.0f;
    }
    for (int first = 0; first < count; first += GLINT_BLOCK) {
        float low[GLINT_BLOCK];
        float high[GLINT_BLOCK];
        float shares[GLINT_BLOCK];
        float scales[GLINT_BLOCK];
        uint at_x[GLINT_BLOCK];
        uint at_y[GLINT_BLOCK];
        float between_x[GLINT_BLOCK];
        float between_y[GLINT_BLOCK];
        float wider_x[GLINT_BLOCK];
        float wider_y[GLINT_BLOCK];
        for (int i = 0; i < GLINT_BLOCK; ++i) {
            int k = first + i;
            int row = places[k] & 31;
            bool coarse = row >= low_rows;
            int x = (places[k] >> 5u) + k;
            int y = row + (coarse ? high_first : low_cells.first);
            float weight = ellipse_weight(ellipse_either(low_cells, high_cells, coarse), x, y);
            weight = k < count ? weight : 0.0f;
            low[i] = coarse ? 0.0f : weight;
            high[i] = coarse ? weight : 0.0f;
            GlintCell c = glint_cell(glint_level_either(low_level, high_level, coarse), x, y);
            shares[i] = c.share;
            float slope_x = abs(c.turn.c * q.slope.x + c.turn.s * q.slope.y);
            float slope_y = abs(c.turn.c * q.slope.y - c.turn.s * q.slope.x);
            scales[i] = max(slope_x, slope_y) < GLINT_REACH ? scale : 0.0f;
            float kernel_x = glint_kernel_along(q, c.turn.c, c.turn.s);
            GlintPlace place_x = glint_place(slope_x);
            GlintPlace place_y = glint_place(slope_y);
            GlintWidth width_x = glint_width(kernel_x);
            GlintWidth width_y = glint_width(trace - kernel_x);
            at_x[i] = glint_at(c.row_x, width_x.width, place_x.bin);
            at_y[i] = glint_at(c.row_y, width_y.width, place_y.bin);
            between_x[i] = place_x.t;
            between_y[i] = place_y.t;
            wider_x[i] = width_x.share;
            wider_y[i] = width_y.share;
        }
        uvec2 words_x[GLINT_BLOCK];
        uvec2 words_y[GLINT_BLOCK];
        for (int i = 0; i < GLINT_BLOCK; ++i) {
            words_x[i] = table_uint2(q.table, at_x[i]);
            words_y[i] = table_uint2(q.table, at_y[i]);
        }
        for (int i = 0; i < GLINT_BLOCK; ++i) {
            float facets = scales[i]
                         * glint_read(words_x[i].x, words_x[i].y, between_x[i], wider_x[i])
                         * glint_read(words_y[i].x, words_y[i].y, between_y[i], wider_y[i]);
            float value = q.gaussian + shares[i] * (facets - q.gaussian);
            all_low[i] += low[i];
            all_high[i] += high[i];
            sum_low[i] += low[i] * value;
            sum_high[i] += high[i] * value;
        }
    }
    // By halves: sums that wait for each other take longer.
    for (int i = 0; i < GLINT_BLOCK / 2; ++i) {
        all_low[i] += all_low[i + GLINT_BLOCK / 2];
        all_high[i] += all_high[i + GLINT_BLOCK / 2];
        sum_low[i] += sum_low[i + GLINT_BLOCK / 2];
        sum_high[i] += sum_high[i + GLINT_BLOCK / 2];
    }
    float mean = ((sum_low[0] + sum_low[1]) + (sum_low[2] + sum_low[3]))
               / ((all_low[0] + all_low[1]) + (all_low[2] + all_low[3]));
    float high_mean = ((sum_high[0] + sum_high[1]) + (sum_high[2] + sum_high[3]))
                    / ((all_high[0] + all_high[1]) + (all_high[2] + all_high[3]));
    return s.share > 0.0f ? mean + s.share * (high_mean - mean) : mean;
}

GlintQuery glint_query(IN(Glint) g, IN(Slopes) d, IN(Whitening) w, vec2 s) {
    GlintQuery q;
    q.table = g.dictionary;
    q.slope = whitened(w, s - d.mean);
    float deviation = sqrt(NDF_PIXEL_VARIANCE);
    q.k0 = whitened(w, g.k0 * deviation);
    q.k1 = whitened(w, g.k1 * deviation);
    q.scale = w.xx * w.yy * (GLINT_ROOT * GLINT_ROOT * GLINT_ROOT * GLINT_ROOT);
    q.gaussian = slopes_p22(d, s);
    return q;
}

// So far from the mean no cell has facets, whichever way it is turned.
bool glint_within_reach(IN(GlintQuery) q) {
    return dot(q.slope, q.slope) < 2.0f * GLINT_REACH * GLINT_REACH;
}

// Where no cells are read: out there lies a 10^-7 of the Gaussian, and stays.
float glint_without_cells(IN(GlintQuery) q) {
    return dot(q.slope, q.slope) < 1.0e30f ? q.gaussian : 0.0f;
}

// Density of slopes (not centred) over the footprint, per horizontal area. Finite and >= 0 whatever
// the input; 0 for slopes that are not finite.
float glint_p22(IN(Glint) g, vec2 s) {
    Slopes d = glint_slopes_within(g);
    GlintQuery q = glint_query(g, d, whitening_of(d), s);
    if (!glint_within_reach(q)) { return glint_without_cells(q); }
    GlintPyramid p = glint_pyramid(g);
    if (p.smooth_only) { return glint_without_cells(q); }
    return glint_mean_of_cells(q, glint_steps(p, g.uv, g.seed));
}

// The same for many points: all that goes before the cells are read.
struct GlintLookup {
    GlintQuery query;
    GlintSteps steps;
    float alone;  // where no cells are read; else below 0
};

// Without branches, so that loops become vectors.
IN_LOOPS GlintLookup glint_lookup(IN(Glint) g, vec2 s) {
    Slopes d = glint_slopes_within(g);
    GlintPyramid p = glint_pyramid(g);
    GlintLookup l;
    l.query = glint_query(g, d, whitening_of(d), s);
    l.steps = glint_steps(p, g.uv, g.seed);
    float whole = glint_without_cells(l.query);
    l.alone = glint_within_reach(l.query) ? -1.0f : whole;
    l.alone = p.smooth_only ? whole : l.alone;
    return l;
}

float glint_looked_up(IN(GlintLookup) l) {
    return l.alone >= 0.0f ? l.alone : glint_mean_of_cells(l.query, l.steps);
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
