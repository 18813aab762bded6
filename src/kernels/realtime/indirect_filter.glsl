// The a-trous filter of indirect light (see atrous.glsl), over blocks with gaps of 1, 2, 4: up to
// 21 pixels away. Unmapped normals tell surfaces apart: light has its directions with it, for any
// normal near by. The first iteration also cuts blocks that are much brighter than those around.
#ifndef GP_KERNELS_REALTIME_INDIRECT_FILTER_GLSL
#define GP_KERNELS_REALTIME_INDIRECT_FILTER_GLSL
#include "kernels/realtime/indirect_temporal.glsl"

// Iterations pass their results on: low, history, other, low.
#define INDIRECT_ITERATIONS 3

BlockLight indirect_source(ivec2 at, int iteration) {
    BlockLight b;
    if (iteration == 0) {
        b.light = load_indirect_low(at);
        b.chroma = load_indirect_low_chroma(at);
    } else if (iteration == 1) {
        b.light = load_indirect_history(at);
        b.chroma = load_indirect_history_chroma(at);
    } else {
        b.light = load_indirect_other(at);
        b.chroma = load_indirect_other_chroma(at);
    }
    return b;
}

void indirect_store(ivec2 block, int iteration, IN(BlockLight) b) {
    if (iteration == 0) {
        store_indirect_history(block, b.light);
        store_indirect_history_chroma(block, b.chroma);
    } else if (iteration == 1) {
        store_indirect_other(block, b.light);
        store_indirect_other_chroma(block, b.chroma);
    } else {
        store_indirect_low(block, b.light);
        store_indirect_low_chroma(block, b.chroma);
    }
}

// How much the surface of block `at` is the surface `s`: e^-x of their differences.
float indirect_apart(ivec2 at, IN(EdgeTest) s, float distance) {
    LET_REF(RealtimeConstants) c = load_realtime();
    uvec2 guide = load_indirect_guide(at);
    float allowed = depth_allowance(s.depth, s.slope, 3.0f * distance, c.filter_depth);
    float bend = 1.0f - normal_cosine(s, guide.y);
    return abs(uintBitsToFloat(guide.x) - s.depth) / allowed + bend * c.indirect_filter_normal;
}

// The surface of a block. Without light: its depth is DEPTH_NONE.
EdgeTest indirect_surface(ivec2 block) {
    uvec2 guide = load_indirect_guide(block);
    EdgeTest s = edge_test(0u, uintBitsToFloat(guide.x), 0.0f, guide.y);
    if (s.depth < DEPTH_NONE) { s.slope = finite_or_zero(load_motion(block_pixel(block)).w); }
    return s;
}

void indirect_filter(ivec2 block, int iteration) {
    LET_REF(RealtimeConstants) c = load_realtime();
    ivec2 size = (c.size + 2) / 3;
    BlockLight own = indirect_source(block, iteration);
    EdgeTest s = indirect_surface(block);
    if (!(s.depth < DEPTH_NONE)) {
        indirect_store(block, iteration, own);
        return;
    }
    float stop = luminance_stop(own.light.x, own.chroma.w, own.chroma.z, iteration,
                                c.filter_luminance);
    BlockLight sum = no_block_light();
    float weights = 0.0f;
    float around = 0.0f;
    float around_weights = 0.0f;
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3 - 1, i / 3 - 1);
        ivec2 at = block + offset * (1 << iteration);
        if (i == 4 || !pixel_is_inside(at, size)) { continue; }
        BlockLight b = indirect_source(at, iteration);
        float distance = float((abs(offset.x) + abs(offset.y)) * (1 << iteration));
        float kernel = (offset.x == 0 ? 1.0f : 0.5f) * (offset.y == 0 ? 1.0f : 0.5f);
        float apart = indirect_apart(at, s, distance);
        float like = kernel * edge_weight(apart);
        float weight = kernel * edge_weight(apart + abs(b.light.x - own.light.x) * stop);
        around += b.light.x * like;
        around_weights += like;
        sum.light += b.light * weight;
        sum.chroma += b.chroma * weight;
        weights += weight;
    }
    // Anti-firefly: the middle counts as much as its neighbours allow.
    float most = c.indirect_firefly_limit * around;
    float part = iteration == 0 && around_weights > 0.5f && own.light.x * around_weights > most
                     ? most / (own.light.x * around_weights)
                     : 1.0f;
    float scale = 1.0f / (weights + 1.0f);
    float frames = own.chroma.z;
    sum.light = (sum.light + own.light * part) * scale;
    sum.chroma = (sum.chroma + vec4(own.chroma.x * part, own.chroma.y * part, 0.0f,
                                    own.chroma.w * part * part)) * scale;
    sum.chroma.z = frames;
    indirect_store(block, iteration, sum);
}

#endif
