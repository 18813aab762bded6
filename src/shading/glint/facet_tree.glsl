// The slopes of a number of facets: a binary tree that splits their number between halves of the
// plane of slopes, level by level, down to cells as large as a facet's own slopes. What a cell has
// is found by one way down, and a facet is drawn by the same way, half by half, each chosen by its
// count: counted and drawn is one density, exactly, and no facet is counted twice or lost.
//
// Slopes are whitened, so that all surfaces are the standard normal distribution, turned by an
// angle of the tree's own, and mirrored into a quadrant: a tree is symmetric about its mean.
// Halves are split along x and y by turns; within a cell the density is the normal one.
// Based on: Kneiphof and Klein 2025, "Real-Time Image-Based Lighting of Glints", EGSR (numbers of
// facets split by a normal number with two gates, for none and all of them); the tree over slopes,
// gates with soft edges and drawing by it are ours.
#ifndef GP_SHADING_GLINT_FACET_TREE_GLSL
#define GP_SHADING_GLINT_FACET_TREE_GLSL
#include "shading/microfacet/beckmann.glsl"
#include "shading/sampling/hash.glsl"
#include "shading/trigonometry.glsl"

// Cells along an axis, 0.2 deviations wide, the last one without an end: as wide as a facet's own
// slopes (COUNTING_LOBE).
#define FACET_TREE_CELLS 16
#define FACET_TREE_CELL 0.2f
#define FACET_TREE_DEPTH 8

// As many trees as a footprint asks for; unused ones have the weight 0.
#define FACET_TREES 16

struct FacetTrees {
    uint keys[FACET_TREES];      // their random numbers
    float counts[FACET_TREES];   // facets that one would expect in it, of one quadrant; above 0
    float weights[FACET_TREES];  // share of the footprint
    float coarser;               // cells are 2^coarser times as large, 0 … 4
    int used;
};

FacetTrees facet_trees_none(float coarser) {
    FacetTrees trees;
    for (int i = 0; i < FACET_TREES; ++i) {
        trees.keys[i] = 0u;
        trees.counts[i] = 1.0f;
        trees.weights[i] = 0.0f;
    }
    trees.coarser = coarser;
    trees.used = 0;
    return trees;
}

// Of the facets of all slopes those in the quadrant that a tree is mirrored into; never 0.
float facet_trees_quadrant(float facets) {
    return max(0.25f * facets, 1.0e-30f);
}

// Of the half-normal distribution within a node what lies in its lower half, and logarithms to base
// 2 of that and of the rest. Node 2^l - 1 + i: cells from i 2^(4-l) on. What a node has is
// erf(b / sqrt 2) - erf(a / sqrt 2) of its ends.
IN_LOOPS float facet_share(int node) {
    CONST_TABLE float shares[15] = {
        0.8904014f, 0.6472240f, 0.8504080f, 0.5393880f, 0.6162494f, 0.6877243f, 0.6883051f,
        0.5099654f, 0.5298646f, 0.5496693f, 0.5693180f, 0.5887509f, 0.6079111f, 0.6267447f,
        0.4716911f};
    return shares[node];
}

IN_LOOPS float facet_share_log2(int node) {
    CONST_TABLE float logarithms[15] = {
        -0.1674722f, -0.6276629f, -0.2337729f, -0.8906047f, -0.6984138f, -0.5400978f, -0.5388799f,
        -0.9715287f, -0.9163044f, -0.8633642f, -0.8126934f, -0.7642707f, -0.7180678f, -0.6740502f,
        -1.0840856f};
    return logarithms[node];
}

IN_LOOPS float facet_rest_log2(int node) {
    CONST_TABLE float logarithms[15] = {
        -3.1896989f, -1.5031758f, -2.7408950f, -1.1183761f, -1.3817590f, -1.6791078f, -1.6817934f,
        -1.0290445f, -1.0888517f, -1.1509433f, -1.2153050f, -1.2819157f, -1.3507472f, -1.4217654f,
        -0.9205464f};
    return logarithms[node];
}

// 2^x for x <= 0 to 2e-6, without a call.
IN_LOOPS float facet_exp2(float x) {
    float y = max(x, -120.0f);
    int whole = int(y) - 1;
    float f = y - float(whole);  // 0 … 1
    float p = 1.0f + f * (0.69314718f + f * (0.24022651f + f * (0.05550411f + f * (0.00961813f
              + f * (0.00133336f + f * 0.00015469f)))));
    return p * uintBitsToFloat(uint(whole + 127) << 23u);
}

// 0 below the edge and 1 above it, with a slope of this half width in place of the step.
IN_LOOPS float facet_gate(float u, float edge, float half_width) {
    float x = 0.5f + (u - edge) * (0.5f / max(half_width, 1.0e-7f));
    return clamp(x, 0.0f, 1.0f);
}

// How many of n facets are in the lower half of a node: none, all, or a normal number between that
// has the mean and variance which the binomial has there. The mean is exact for any n, whole or
// not; below one facet that one is on one side as a whole.
// [Kneiphof and Klein 2025, dual-gated Gaussian]
IN_LOOPS float facet_split(float n, int node, uint bits) {
    float share = facet_share(node);
    float whole = max(n, 1.0f);
    float all = facet_exp2(whole * facet_share_log2(node));
    float none = facet_exp2(whole * facet_rest_log2(node));
    float between = max(1.0f - all - none, 0.0f);
    float inv = 1.0f / max(between, 1.0e-6f);
    float mean = clamp((share - all) * inv, 0.0f, 1.0f);
    float square = (share * (1.0f - share) / whole + share * share - all) * inv;
    float deviation = sqrt(max(square - mean * mean, 0.0f));
    // Two bytes' sum, up to 2.4 deviations; cut on both sides alike, which keeps the mean.
    float normal = (float(int((bits & 255u) + ((bits >> 8u) & 255u))) - 255.0f) * (1.0f / 104.51f);
    float reach = min(mean, 1.0f - mean);
    float middle = mean + clamp(deviation * normal, -reach, reach);
    // Soft edges: facets fade over where counts change with the footprint.
    float u = (float(int(bits >> 16u)) + 0.5f) * (1.0f / 65536.0f);
    float some = facet_gate(u, none, 0.25f * min(none, between));
    float every = facet_gate(u, 1.0f - all, 0.25f * min(all, between));
    return n * (some * middle + every * (1.0f - middle));
}

// Facets in the whole tree: all that are expected, or one with the probability that it is there.
IN_LOOPS float facet_root(float expected, uint key) {
    float some = min(expected, 1.0f);
    float u = (float(int((key * 0x9E3779B9u) >> 16u)) + 0.5f) * (1.0f / 65536.0f);
    float one = facet_gate(1.0f - u, 1.0f - some, 0.25f * min(some, 1.0f - some));
    return expected < 1.0f ? one : expected;
}

// Steps down to the tree's own cells; each tree goes over to larger ones at a point of its own.
IN_LOOPS int facet_depth(float coarser, uint key) {
    int levels = int(coarser + float(int(key & 0xFFFFu)) * (1.0f / 65536.0f));
    return FACET_TREE_DEPTH - 2 * min(levels, 4);
}

IN_LOOPS SinCos facet_turn(uint key) {
    // A quarter turn would do no more than exchange the axes.
    return sincos_eighth(0.25f * float(int((key >> 16u) & 0xFFFFu)) * (1.0f / 65536.0f) - 0.125f);
}

IN_LOOPS int facet_cell_along(float x) {
    return int(min(abs(x) * (1.0f / FACET_TREE_CELL), float(FACET_TREE_CELLS - 1)));
}

// Over the smooth surface: what a footprint's facets reflect at a slope, and in all.
struct FacetShare {
    float at;     // 1 on average
    float whole;  // of the facets that are there over those that one would expect
};

// z: the whitened slope, finite. Loops that compilers turn into vectors.
OUT_OF_LINE FacetShare facet_trees_at(IN(FacetTrees) trees, vec2 z) {
    int cells[2 * FACET_TREES];
    int depth[FACET_TREES];
    uint bits[FACET_TREES];
    float counts[FACET_TREES];
    float expected[FACET_TREES];
    FacetShare share;
    share.whole = 0.0f;
    for (int i = 0; i < FACET_TREES; ++i) {
        SinCos turn = facet_turn(trees.keys[i]);
        cells[i] = facet_cell_along(turn.c * z.x + turn.s * z.y);
        cells[i + FACET_TREES] = facet_cell_along(turn.c * z.y - turn.s * z.x);
        depth[i] = facet_depth(trees.coarser, trees.keys[i]);
        bits[i] = hash_u32(trees.keys[i]);
        counts[i] = facet_root(trees.counts[i], trees.keys[i]);
        expected[i] = trees.counts[i];
        share.whole += trees.weights[i] * counts[i] / trees.counts[i];
    }
    for (int step = 0; step < FACET_TREE_DEPTH; ++step) {
        int level = step >> 1;
        int axis = (step & 1) * FACET_TREES;
        for (int i = 0; i < FACET_TREES; ++i) {
            int cell = cells[i + axis];
            int node = (1 << level) - 1 + (cell >> (4 - level));
            int upper = (cell >> (3 - level)) & 1;
            float low = facet_split(counts[i], node, bits[i]);
            float p = facet_share(node);
            float goes_on = float(step < depth[i]);
            float in_upper = float(upper);
            float child = low + in_upper * (counts[i] - 2.0f * low);
            counts[i] += goes_on * (child - counts[i]);
            expected[i] *= 1.0f + goes_on * (p + in_upper * (1.0f - 2.0f * p) - 1.0f);
            bits[i] = hash_u32(bits[i] + uint(upper) + 1u);
        }
    }
    share.at = 0.0f;
    for (int i = 0; i < FACET_TREES; ++i) {
        share.at += trees.weights[i] * counts[i] / expected[i];
    }
    return share;
}

// One of two, of these weights, and the number again, uniform within it.
struct FacetChoice {
    bool second;
    float u;
};

FacetChoice facet_choose(float u, float first, float second) {
    FacetChoice c;
    float edge = first / max(first + second, 1.0e-30f);
    c.second = u >= edge;
    c.u = c.second ? (u - edge) / max(1.0f - edge, 1.0e-30f) : u / max(edge, 1.0e-30f);
    c.u = clamp(c.u, 0.0f, 0.9999999f);
    return c;
}

// A facet of one tree; u within its cell and side, u_way down to it.
vec2 facet_tree_sample(IN(FacetTrees) trees, int tree, vec2 u, float u_way) {
    uint key = trees.keys[tree];
    uint bits = hash_u32(key);
    float count = facet_root(trees.counts[tree], key);
    int depth = facet_depth(trees.coarser, key);
    // The cell: its number on its level, and its part of the half-normal distribution.
    ivec2 cell = ivec2(0);
    vec2 low = vec2(0.0f);
    vec2 size = vec2(1.0f);
    for (int step = 0; step < depth; ++step) {
        bool along_x = (step & 1) == 0;
        int at = along_x ? cell.x : cell.y;
        int node = (1 << (step >> 1)) - 1 + at;
        float below = facet_split(count, node, bits);
        FacetChoice c = facet_choose(u_way, below, count - below);
        u_way = c.u;
        float p = facet_share(node);
        float part = along_x ? size.x : size.y;
        float start = (along_x ? low.x : low.y) + (c.second ? part * p : 0.0f);
        part *= c.second ? 1.0f - p : p;
        at = 2 * at + (c.second ? 1 : 0);
        cell = along_x ? ivec2(at, cell.y) : ivec2(cell.x, at);
        low = along_x ? vec2(start, low.y) : vec2(low.x, start);
        size = along_x ? vec2(part, size.y) : vec2(size.x, part);
        count = c.second ? count - below : below;
        bits = hash_u32(bits + (c.second ? 1u : 0u) + 1u);
    }
    vec2 side = vec2(u.x < 0.5f ? -1.4142136f : 1.4142136f, u.y < 0.5f ? -1.4142136f : 1.4142136f);
    vec2 inside = vec2(u.x < 0.5f ? 2.0f * u.x : 2.0f * u.x - 1.0f,
                       u.y < 0.5f ? 2.0f * u.y : 2.0f * u.y - 1.0f);
    vec2 z = vec2(side.x * erf_inverse(min(low.x + size.x * inside.x, 0.9999999f)),
                  side.y * erf_inverse(min(low.y + size.y * inside.y, 0.9999999f)));
    SinCos turn = facet_turn(key);
    return vec2(turn.c * z.x - turn.s * z.y, turn.s * z.x + turn.c * z.y);
}

// As FacetShare::whole.
float facet_trees_whole(IN(FacetTrees) trees) {
    float whole = 0.0f;
    for (int i = 0; i < trees.used; ++i) {
        whole += trees.weights[i] * facet_root(trees.counts[i], trees.keys[i]) / trees.counts[i];
    }
    return whole;
}

// A whitened slope with the density of FacetShare::at times the normal one, over `whole`, which
// must not be 0; u_way also chooses the tree.
vec2 facet_trees_sample(IN(FacetTrees) trees, vec2 u, float u_way) {
    float left = u_way * facet_trees_whole(trees);
    int chosen = -1;
    float part = 1.0f;
    for (int i = 0; i < trees.used; ++i) {
        float next =
            trees.weights[i] * facet_root(trees.counts[i], trees.keys[i]) / trees.counts[i];
        // The last one that has facets also takes what rounding leaves.
        if (next > 0.0f && (chosen < 0 || left >= part)) {
            left -= chosen < 0 ? 0.0f : part;
            chosen = i;
            part = next;
        }
    }
    return facet_tree_sample(trees, max(chosen, 0), u, clamp(left / part, 0.0f, 0.9999999f));
}

#endif
