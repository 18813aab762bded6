// Indirect light is smooth, and one path a pixel sees it badly: from here on it lives in blocks of
// 3 x 3 pixels. A block has the surface of one of its pixels (`indirect_guide`), the light of those
// that are like it, and, as the other channels, a mean over frames (see temporal.glsl).
#ifndef GP_KERNELS_REALTIME_INDIRECT_TEMPORAL_GLSL
#define GP_KERNELS_REALTIME_INDIRECT_TEMPORAL_GLSL
#include "kernels/realtime/edge_stop.glsl"
#include "shading/ycocg.glsl"

// Luma, and luma times direction; Co and Cg. z of `chroma` is the frames it is made of, w the
// variance of one frame's luma.
struct BlockLight {
    vec4 light;
    vec4 chroma;
};

// The pixel whose surface a block has: the middle if it is lit, else the first that is; x < 0:
// none.
ivec2 block_pixel(ivec2 block) {
    LET_REF(RealtimeConstants) c = load_realtime();
    for (int i = 0; i < 9; ++i) {
        int cell = i == 0 ? 4 : (i <= 4 ? i - 1 : i);
        ivec2 at = ivec2(3 * block.x + cell % 3, 3 * block.y + cell / 3);
        if (pixel_is_inside(at, c.size) && pixel_is_lit(load_material(at), load_depth(at))) {
            return at;
        }
    }
    return ivec2(-1);
}

// The pixels of a block that show its surface: sums, and the brightest of them apart.
struct BlockSum {
    BlockLight all;      // w of chroma: of the squares of luma
    BlockLight brightest;
    float second;        // the luma after the brightest
    float count;
};

BlockLight no_block_light() {
    BlockLight b;
    b.light = vec4(0.0f);
    b.chroma = vec4(0.0f);
    return b;
}

// `without`: a pixel of the block that is left out.
BlockSum block_sum(ivec2 block, IN(EdgeTest) s, int without) {
    LET_REF(RealtimeConstants) c = load_realtime();
    float allowance = c.history_depth * s.depth + 2.0f * s.slope;
    BlockSum sum;
    sum.all = no_block_light();
    sum.brightest = no_block_light();
    sum.second = 0.0f;
    sum.count = 0.0f;
    for (int i = 0; i < 9; ++i) {
        ivec2 at = ivec2(3 * block.x + i % 3, 3 * block.y + i / 3);
        if (i == without || !pixel_is_inside(at, c.size)) { continue; }
        if (((load_material(at) ^ s.material) & MATERIAL_SURFACE_BITS) != 0u) { continue; }
        if (!(abs(load_depth(at) - s.depth) <= allowance)) { continue; }
        if (normal_cosine(s, load_unmapped_normal(at)) < c.history_normal) { continue; }
        vec3 raw = ycocg_from_rgb(load_indirect_raw(at));
        BlockLight b;
        b.light = vec4(raw.x, octahedral_decode(load_indirect_from(at)) * raw.x);
        b.chroma = vec4(raw.y, raw.z, 0.0f, raw.x * raw.x);
        if (b.light.x > sum.brightest.light.x) {
            sum.second = sum.brightest.light.x;
            sum.brightest = b;
        } else {
            sum.second = max(sum.second, b.light.x);
        }
        sum.all.light += b.light;
        sum.all.chroma += b.chroma;
        sum.count += 1.0f;
    }
    return sum;
}

// The mean of the block's pixels, without what a firefly among them has too much, and the variance
// of that mean. `before`: the luma of its history.
BlockLight block_light(ivec2 block, IN(EdgeTest) s, float before, float frames) {
    // What repeats the last frame's draws was chosen for its brightness, see accumulate.
    BlockSum sum = block_sum(block, s, repeated_cell(block));
    if (sum.count == 0.0f) { sum = block_sum(block, s, -1); }
    float most = sum.brightest.light.x;
    float part = sum.count > 2.0f ? firefly_part(most, max(sum.second, before), frames) : 1.0f;
    float scale = 1.0f / max(sum.count, 1.0f);
    BlockLight b;
    b.light = (sum.all.light - sum.brightest.light * (1.0f - part)) * scale;
    b.chroma = (sum.all.chroma - sum.brightest.chroma * (1.0f - part)) * scale;
    float squares = sum.all.chroma.w - most * most * (1.0f - part * part);
    b.chroma.w = max(squares * scale - b.light.x * b.light.x, 0.0f) * scale;
    return b;
}

// The mean of the four blocks around a place of the last frame that belong to the surface.
BlockLight block_history(vec2 position, IN(EdgeTest) s) {
    LET_REF(RealtimeConstants) c = load_realtime();
    ivec2 size = (c.size + 2) / 3;
    BlockLight h = no_block_light();
    if (!(position.x > -1.0f && position.y > -1.0f && position.x < float(size.x) &&
          position.y < float(size.y))) {
        return h;
    }
    vec2 corner = floor(position);
    vec2 part = position - corner;
    float allowance = c.history_depth * s.depth + 4.5f * s.slope;
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2(int(corner.x) + (i & 1), int(corner.y) + (i >> 1));
        float weight = ((i & 1) != 0 ? part.x : 1.0f - part.x) *
                       ((i & 2) != 0 ? part.y : 1.0f - part.y);
        if (weight < 1.0e-3f || !pixel_is_inside(at, size)) { continue; }
        uvec2 guide = load_previous_indirect_guide(at);
        if (!(abs(uintBitsToFloat(guide.x) - s.depth) <= allowance)) { continue; }
        if (normal_cosine(s, guide.y) < c.history_normal) { continue; }
        h.light += load_indirect_history(at) * weight;
        h.chroma += load_indirect_history_chroma(at) * weight;
        sum += weight;
    }
    if (sum > 0.0f) {
        h.light *= 1.0f / sum;
        h.chroma *= 1.0f / sum;
    }
    return h;
}

// What accumulate does, for light with directions.
BlockLight accumulate_block(IN(BlockLight) now, IN(BlockLight) history, float limit,
                            float change) {
    NewLight luma;
    luma.light = vec3(now.light.x, 0.0f, 0.0f);
    luma.luma = now.light.x;
    luma.variance = now.chroma.w;
    luma.change = change;
    luma.is_repeated = false;
    vec4 before = vec4(history.light.x, 0.0f, 0.0f, history.chroma.w);
    Accumulated a = accumulate(luma, before, before.x, history.chroma.z, limit);
    float share = new_share(a.frames, change);
    BlockLight sum;
    sum.light = mix(history.light, now.light, share);
    vec4 chroma = mix(history.chroma, now.chroma, share);
    sum.chroma = vec4(chroma.x, chroma.y, a.frames, a.light.w);
    return sum;
}

void indirect_temporal(ivec2 block, int mode) {
    LET_REF(RealtimeConstants) c = load_realtime();
    ivec2 pixel = block_pixel(block);
    if (pixel.x < 0) {
        store_indirect_guide(block, uvec2(floatBitsToUint(DEPTH_NONE), 0u));
        store_indirect_low(block, vec4(0.0f));
        store_indirect_low_chroma(block, vec4(0.0f));
        return;
    }
    uint normal = load_unmapped_normal(pixel);
    vec4 motion = finite_or_zero_4(load_motion(pixel));
    EdgeTest s = edge_test(load_material(pixel), load_depth(pixel), motion.w, normal);
    store_indirect_guide(block, uvec2(floatBitsToUint(s.depth), normal));
    BlockLight history = no_block_light();
    if (mode != TEMPORAL_NONE && c.has_previous != 0u &&
        ((s.material >> 16u) & REALTIME_NO_HISTORY) == 0u) {
        EdgeTest was = s;
        was.depth = s.depth + motion.z;
        // Block b has its middle at pixel 3 b + 1; blocks move as their pixels do.
        history = block_history(vec2(block) + vec2(motion.x, motion.y) * (1.0f / 3.0f), was);
    }
    BlockLight now = block_light(block, s, history.light.x, history.chroma.z);
    float change = 0.0f;
    float limit = c.svgf_history_frames;
    if (mode == TEMPORAL_ADAPTIVE) {
        change = min(load_gradient(block).y * c.indirect_antilag, 1.0f);
        limit = c.indirect_history_frames;
    }
    BlockLight sum = accumulate_block(now, history, limit, change);
    store_indirect_low(block, sum.light);
    store_indirect_low_chroma(block, sum.chroma);
}

#endif
