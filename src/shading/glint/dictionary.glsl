// The dictionary of glints: 1D distributions of slope, each of few or many narrow lobes, whose mean
// is the normal distribution. scene/glint_dictionary.cpp makes it; this is how it is read.
//
// Unit: the standard deviation, which is 1 in all of them. Rows are the nodes of two binary trees,
// each the mean of its two children, down to level 0 with one lobe and its mirror image; a level
// has half as many as the one below. The lobes below a node are stratified, one in each of as many
// equal shares of the normal distribution, so that the contrast of a product of two rows falls with
// the number of its facets as that of single facets does. A row is kept five times for five widths
// of kernel, in which lobes have the width 2^m / 16 and lie as much closer together that the
// variance stays. Width 4 is the normal distribution, the same for all.
//
// A copy holds averages over 64 bins of [0, 4], and before and after them the first and the last
// again. It is read linearly between centres of bins and so mirrored at both ends, so that what is
// read integrates to what was stored, 1/2, exactly. Reads are what glints cost, and all that one
// needs lies side by side: the words of a row are those of the copies 0 to 3, and each word has a
// bin of its copy (low half) and of the next one as square roots, in units of GLINT_ROOT: 16 bits
// keep a density of 1 to 4e-5 and one of 0.001 to 1e-6. Row `entry` of a level: glint_row; its
// children on the level below are `entry` and `entry` + glint_entries(level).
// Based on: Chermain et al. 2020, "Procedural Physically based BRDF for Real-Time Rendering of
// Glints", section 5; bins for nodes, widths for MIP levels, trees and where means lie are ours.
#ifndef GP_SHADING_GLINT_DICTIONARY_GLSL
#define GP_SHADING_GLINT_DICTIONARY_GLSL
#include "shading/powers.glsl"

#define GLINT_LEVELS 10
#define GLINT_LEAVES 1024u  // of both trees: 2^GLINT_LEVELS, 10 bits of a cell's numbers
#define GLINT_BINS 64u
#define GLINT_COPY (GLINT_BINS + 2u)
#define GLINT_ROW (4u * GLINT_COPY)
#define GLINT_WORDS ((2u * GLINT_LEAVES - 2u) * GLINT_ROW)
#define GLINT_REACH 4.0f  // where the tables end
#define GLINT_BINS_PER_UNIT (float(GLINT_BINS) / GLINT_REACH)
#define GLINT_ROOT (1.0f / 25600.0f)  // of densities up to 6.55; a lobe and its mirror image: 6.38

// How many rows a level has.
IN_LOOPS uint glint_entries(uint level) {
    return GLINT_LEAVES >> level;
}

// Where a row begins. Levels follow each other from 0 on.
IN_LOOPS uint glint_row(uint level, uint entry) {
    return (2u * GLINT_LEAVES - (2u * GLINT_LEAVES >> level) + entry) * GLINT_ROW;
}

// A width between two of the stored ones is a mixture of them.
struct GlintWidth {
    uint width;   // 0 … 3
    float share;  // of the next one
};

// Of a kernel with the variance `kernel` (of 1, all of it). What is left for lobes of width 1/16
// is 1 - kernel; the mixture has the same variance.
IN_LOOPS GlintWidth glint_width(float kernel) {
    // By the bits, in whose order positive floats are: 1 to 256, and NaN is 256.
    uint bits = min(max(floatBitsToUint(1.0f + 255.0f * kernel), 0x3f800000u), 0x43800000u);
    GlintWidth w;
    w.width = min(uint(log4_floor(uintBitsToFloat(bits))), 3u);
    // The quotient by that power of 4 is exact.
    w.share = uintBitsToFloat(bits - (w.width << 24u)) * (1.0f / 3.0f) - (1.0f / 3.0f);
    return w;
}

// Between which bins of a copy x >= 0 lies: the number of the lower one, the first being 1, and the
// way from it.
struct GlintPlace {
    uint bin;
    float t;
};

IN_LOOPS GlintPlace glint_place(float x) {
    float p = x * GLINT_BINS_PER_UNIT + 0.5f;
    // Integers for limits: of floats compilers make more than one instruction, for NaN's sake.
    int bin = min(int(p), int(GLINT_BINS));
    GlintPlace place;
    place.bin = uint(bin);
    place.t = p - float(bin);
    return place;
}

// The densities of a stored bin, in units of GLINT_ROOT^2: of the narrower and of the wider copy.
IN_LOOPS float glint_narrow(uint word) {
    float root = float(int(word & 65535u));
    return root * root;
}

IN_LOOPS float glint_wide(uint word) {
    float root = float(int(word >> 16u));
    return root * root;
}

// Where the words of both bins of a read begin.
IN_LOOPS uint glint_at(uint row, uint width, uint bin) {
    return row + width * GLINT_COPY + bin;
}

// The density between two bins, out of their words; in units of GLINT_ROOT^2.
IN_LOOPS float glint_read(uint low, uint high, float t, float share) {
    float a = glint_narrow(low);
    float b = glint_wide(low);
    a += t * (glint_narrow(high) - a);
    b += t * (glint_wide(high) - b);
    return a + share * (b - a);
}

// The density of one entry at x >= 0; 0 beyond 4.
float glint_marginal(uvec2 table, uint row, IN(GlintWidth) w, float x) {
    GlintPlace p = glint_place(x);
    uvec2 words = table_uint2(table, glint_at(row, w.width, p.bin));
    float density = GLINT_ROOT * GLINT_ROOT * glint_read(words.x, words.y, p.t, w.share);
    return x < GLINT_REACH ? density : 0.0f;
}

// A number of density glint_marginal(…, |x|): side, width and bin by their shares, then the tent
// between centres that linear reading spreads a bin's mass over.
float glint_marginal_sample(uvec2 table, uint row, IN(GlintWidth) w, float u) {
    float side = u < 0.5f ? -1.0f : 1.0f;
    u = u < 0.5f ? 2.0f * u : 2.0f * u - 1.0f;
    bool wider = u < w.share;
    u = wider ? u / w.share : (u - w.share) / (1.0f - w.share);
    // Averages times the step sum to 1/2.
    float left = u * (0.5f * GLINT_BINS_PER_UNIT / (GLINT_ROOT * GLINT_ROOT));
    uint k = 0u;
    uint first = glint_at(row, w.width, 1u);
    uvec2 words = table_uint2(table, first);
    float mass = wider ? glint_wide(words.x) : glint_narrow(words.x);
    while (k + 1u < GLINT_BINS && left >= mass) {
        left -= mass;
        ++k;
        words = table_uint2(table, first + k);
        mass = wider ? glint_wide(words.x) : glint_narrow(words.x);
    }
    float v = clamp(left / max(mass, 1.0e-30f), 0.0f, 1.0f);
    float tent = v < 0.5f ? sqrt(2.0f * v) - 1.0f : 1.0f - sqrt(2.0f - 2.0f * v);
    float x = abs((float(int(k)) + 0.5f + tent) * (1.0f / GLINT_BINS_PER_UNIT));
    return side * min(x, 2.0f * GLINT_REACH - x);
}

#endif
