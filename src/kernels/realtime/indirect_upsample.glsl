// Indirect light of pixels from that of blocks: the four blocks around, as far as they have the
// pixel's surface. [Kopf et al. 2007, "Joint Bilateral Upsampling", SIGGRAPH]
#ifndef GP_KERNELS_REALTIME_INDIRECT_UPSAMPLE_GLSL
#define GP_KERNELS_REALTIME_INDIRECT_UPSAMPLE_GLSL
#include "kernels/realtime/indirect_filter.glsl"

// The part of a block's weight that it has whatever its surface: a pixel that is like none of the
// blocks around (a wire, a leaf) takes their mean rather than the noise of its own one path.
#define INDIRECT_ANY_SURFACE 1.0e-4f

void indirect_upsample(ivec2 pixel, int) {
    LET_REF(RealtimeConstants) c = load_realtime();
    ivec2 size = (c.size + 2) / 3;
    uint material = load_material(pixel);
    float depth = load_depth(pixel);
    if (!pixel_is_lit(material, depth)) {
        store_indirect(pixel, vec4(0.0f));
        store_indirect_chroma(pixel, vec2(0.0f));
        return;
    }
    EdgeTest s = edge_test(material, depth, finite_or_zero(load_motion(pixel).w),
                           load_unmapped_normal(pixel));
    vec2 position = (vec2(pixel) - 1.0f) * (1.0f / 3.0f);
    vec2 corner = floor(position);
    vec2 part = position - corner;
    BlockLight sum = no_block_light();
    float weights = 0.0f;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2(int(corner.x) + (i & 1), int(corner.y) + (i >> 1));
        float weight = ((i & 1) != 0 ? part.x : 1.0f - part.x) *
                       ((i & 2) != 0 ? part.y : 1.0f - part.y);
        if (weight < 1.0e-3f || !pixel_is_inside(at, size)) { continue; }
        if (!(uintBitsToFloat(load_indirect_guide(at).x) < DEPTH_NONE)) { continue; }
        weight *= edge_weight(indirect_apart(at, s, 1.0f)) + INDIRECT_ANY_SURFACE;
        sum.light += load_indirect_low(at) * weight;
        sum.chroma += load_indirect_low_chroma(at) * weight;
        weights += weight;
    }
    // Its own block is among the four and has a lit pixel, this one if no other.
    float scale = weights > 0.0f ? 1.0f / weights : 0.0f;
    store_indirect(pixel, sum.light * scale);
    store_indirect_chroma(pixel, vec2(sum.chroma.x, sum.chroma.y) * scale);
}

#endif
