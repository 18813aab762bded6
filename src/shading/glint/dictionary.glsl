// The dictionary of glints: 1D distributions of slope, each of few or many narrow lobes, whose mean
// is the normal distribution. scene/glint_dictionary.cpp makes it; this is how it is read.
//
// Unit: the standard deviation, which is 1 in all of them. Rows are the nodes of two binary trees,
// each the mean of its two children, down to level 0 with one lobe and its mirror image; a level
// has half as many as the one below. The lobes below a node are stratified, one in each of as many
// equal shares of the normal distribution, so that the contrast of a product of two rows falls with
// the number of its facets as that of single facets does. A row is kept four times for four widths
// of kernel, in which lobes have the width 2^m / 16 and lie as much closer together that the
// variance stays. Width 4 is the normal distribution, the same for all.
//
// A row holds averages over bins of [0, 4], 64 | 32 | 16 | 16 of them. It is read linearly between
// centres of bins and mirrored at both ends, so that what is read integrates to what was stored,
// 1/2, exactly. Row `entry` of a level: glint_row; its children on the level below are `entry` and
// `entry` + glint_entries(level). After the last row 16 averages of the normal distribution.
// Based on: Chermain et al. 2020, "Procedural Physically based BRDF for Real-Time Rendering of
// Glints", section 5; bins for nodes, widths for MIP levels, trees and where means lie are ours.
#ifndef GP_SHADING_GLINT_DICTIONARY_GLSL
#define GP_SHADING_GLINT_DICTIONARY_GLSL

#define GLINT_LEVELS 10
#define GLINT_LEAVES 1024u  // of both trees: 2^GLINT_LEVELS, 10 bits of a cell's numbers
#define GLINT_ROW 128u
#define GLINT_NORMAL_ROW ((2u * GLINT_LEAVES - 2u) * GLINT_ROW)
#define GLINT_WORDS (GLINT_NORMAL_ROW + 16u)
#define GLINT_REACH 4.0f  // where the tables end

// How many rows a level has.
IN_LOOPS uint glint_entries(uint level) {
    return GLINT_LEAVES >> level;
}

// Where a row begins. Levels follow each other from 0 on.
IN_LOOPS uint glint_row(uint level, uint entry) {
    return (2u * GLINT_LEAVES - (2u * GLINT_LEAVES >> level) + entry) * GLINT_ROW;
}

// Where one width of a row lies.
struct GlintBins {
    uint base;
    uint count;
};

IN_LOOPS GlintBins glint_bins(uint row, uint width) {
    GlintBins b;
    b.base = width < 4u ? row + 128u - (128u >> width) : GLINT_NORMAL_ROW;
    b.count = max(64u >> width, 16u);
    return b;
}

// The density at x in [0, 4].
IN_LOOPS float glint_bins_read(uvec2 table, IN(GlintBins) b, float x) {
    float p = x * (float(int(b.count)) * (1.0f / GLINT_REACH)) + 0.5f;
    int k = int(p);
    float t = p - float(k);
    uint low = uint(max(k - 1, 0));
    uint high = uint(min(k, int(b.count) - 1));
    float at_low = table_float(table, b.base + low);
    return at_low + t * (table_float(table, b.base + high) - at_low);
}

// A width between two of the stored ones is a mixture of them.
struct GlintWidth {
    uint width;   // 0 … 3
    float share;  // of the next one
};

// Of a kernel with the variance `kernel` (of 1, all of it). What is left for lobes of width 1/16
// is 1 - kernel; the mixture has the same variance.
IN_LOOPS GlintWidth glint_width(float kernel) {
    float v = 1.0f + 255.0f * kernel;
    v = v < 256.0f ? v : 256.0f;
    GlintWidth w;
    // Sums for choices: no branches, so that compilers make vectors of it.
    w.width = uint(v >= 4.0f) + uint(v >= 16.0f) + uint(v >= 64.0f);
    w.share = (v / float(int(1u << (2u * w.width))) - 1.0f) * (1.0f / 3.0f);
    return w;
}

// The density of one entry at x >= 0; 0 beyond 4.
IN_LOOPS float glint_marginal(uvec2 table, uint row, IN(GlintWidth) w, float x) {
    float inside = min(x, GLINT_REACH);
    float a = glint_bins_read(table, glint_bins(row, w.width), inside);
    float b = glint_bins_read(table, glint_bins(row, w.width + 1u), inside);
    return (a + w.share * (b - a)) * (x < GLINT_REACH ? 1.0f : 0.0f);
}

// Without a kernel.
IN_LOOPS float glint_marginal_sharp(uvec2 table, uint row, float x) {
    float density = glint_bins_read(table, glint_bins(row, 0u), min(x, GLINT_REACH));
    return density * (x < GLINT_REACH ? 1.0f : 0.0f);
}

// A number of density glint_marginal(…, |x|): side, width and bin by their shares, then the tent
// between centres that linear reading spreads a bin's mass over.
float glint_marginal_sample(uvec2 table, uint row, IN(GlintWidth) w, float u) {
    float side = u < 0.5f ? -1.0f : 1.0f;
    u = u < 0.5f ? 2.0f * u : 2.0f * u - 1.0f;
    bool wider = u < w.share;
    u = wider ? u / w.share : (u - w.share) / (1.0f - w.share);
    GlintBins b = glint_bins(row, wider ? w.width + 1u : w.width);
    float step = GLINT_REACH / float(int(b.count));
    // Averages times the step sum to 1/2.
    float left = 0.5f * u / step;
    uint k = 0u;
    float mass = table_float(table, b.base);
    while (k + 1u < b.count && left >= mass) {
        left -= mass;
        ++k;
        mass = table_float(table, b.base + k);
    }
    float v = clamp(left / max(mass, 1.0e-30f), 0.0f, 1.0f);
    float tent = v < 0.5f ? sqrt(2.0f * v) - 1.0f : 1.0f - sqrt(2.0f - 2.0f * v);
    float x = abs((float(int(k)) + 0.5f + tent) * step);
    return side * min(x, 2.0f * GLINT_REACH - x);
}

#endif
