// Based on: Schied, Peters, Dachsbacher 2018, "Gradient Estimation for Real-Time Adaptive Temporal
// Filtering", PACM CGIT 1(2). One pixel of each block of 3 x 3 repeats a pixel of the last frame:
// the same surface, the same random numbers. If its light differs, then light has changed, and
// noise has no part in it. Differences and what they are relative to are spread over neighbours
// separately, so that a dark pixel, whose relative change is large and means little, has no say.
// Otherwise than there: no edge stops (a change of light does not end at an edge), and indirect
// light is spread further, since fewer of its paths meet what has changed.
#ifndef GP_KERNELS_REALTIME_GRADIENT_GLSL
#define GP_KERNELS_REALTIME_GRADIENT_GLSL
#include "kernels/realtime/edge_stop.glsl"

// Iterations of gradient_spread after which direct and specular light are left as they are.
#define GRADIENT_NEAR_ITERATIONS 3
#define GRADIENT_ITERATIONS 4

// For each block: the change of direct, indirect and specular light, and its scale.
void gradient_measure(ivec2 block, int) {
    LET_REF(RealtimeConstants) c = load_realtime();
    vec4 change = vec4(0.0f);
    vec4 scale = vec4(0.0f);
    uint code = load_gradient_sample(block);
    int cell = repeated_cell(block);
    ivec2 here = ivec2(3 * block.x + cell % 3, 3 * block.y + cell / 3);
    ivec2 before = ivec2(int((code >> 4u) & 0x3FFFu), int(code >> 18u));
    if (cell >= 0 && pixel_is_inside(here, c.size) && pixel_is_inside(before, c.size)) {
        vec4 now = load_luma(here);
        vec4 then = load_previous_luma(before);
        change = abs(now - then);
        scale = max(now, then);
    }
    store_gradient(block, change);
    store_gradient_scale(block, scale);
}

vec4 gradient_source(ivec2 at, int iteration) {
    return (iteration & 1) == 0 ? load_gradient(at) : load_gradient_other(at);
}

vec4 gradient_scale_source(ivec2 at, int iteration) {
    return (iteration & 1) == 0 ? load_gradient_scale(at) : load_gradient_scale_other(at);
}

float relative_change(float change, float scale) {
    return scale > 0.0f ? clamp(change / scale, 0.0f, 1.0f) : 0.0f;
}

// A 3 x 3 blur with gaps of 2^iteration. The last one leaves the relative change, 0..1.
void gradient_spread(ivec2 block, int iteration) {
    LET_REF(RealtimeConstants) c = load_realtime();
    ivec2 size = (c.size + 2) / 3;
    vec4 change = vec4(0.0f);
    vec4 scale = vec4(0.0f);
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3 - 1, i / 3 - 1);
        ivec2 at = block + offset * (1 << iteration);
        if (!pixel_is_inside(at, size)) { continue; }
        float weight = (offset.x == 0 ? 1.0f : 0.5f) * (offset.y == 0 ? 1.0f : 0.5f) * 0.25f;
        change += gradient_source(at, iteration) * weight;
        scale += gradient_scale_source(at, iteration) * weight;
    }
    if (iteration >= GRADIENT_NEAR_ITERATIONS) {
        vec4 near_change = gradient_source(block, iteration);
        vec4 near_scale = gradient_scale_source(block, iteration);
        change = vec4(near_change.x, change.y, near_change.z, 0.0f);
        scale = vec4(near_scale.x, scale.y, near_scale.z, 0.0f);
    }
    if (iteration == GRADIENT_ITERATIONS - 1) {
        store_gradient(block, vec4(relative_change(change.x, scale.x),
                                   relative_change(change.y, scale.y),
                                   relative_change(change.z, scale.z), 0.0f));
    } else if ((iteration & 1) == 0) {
        store_gradient_other(block, change);
        store_gradient_scale_other(block, scale);
    } else {
        store_gradient(block, change);
        store_gradient_scale(block, scale);
    }
}

#endif
