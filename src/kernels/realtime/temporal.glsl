// Based on: Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering", HPG, section 4.1, and
// Schied, Peters, Dachsbacher 2018 (see gradient.glsl): direct and specular light are averaged with
// what the last frames saw of the same surface. Variance comes in as light does (see accumulate),
// in place of two moments whose difference halves could not hold; a limit relative to neighbours
// cuts fireflies; reflections have a history at their mirror image.
#ifndef GP_KERNELS_REALTIME_TEMPORAL_GLSL
#define GP_KERNELS_REALTIME_TEMPORAL_GLSL
#include "kernels/realtime/edge_stop.glsl"
#include "kernels/realtime/virtual_motion.glsl"

// What the last frame knows of a surface. frames: 0 where it knows nothing.
struct History {
    vec4 direct;
    vec4 specular;
    float direct_frames;
    float specular_frames;
};

History no_history() {
    History h;
    h.direct = vec4(0.0f);
    h.specular = vec4(0.0f);
    h.direct_frames = 0.0f;
    h.specular_frames = 0.0f;
    return h;
}

// The last frame's pixel shows the surface `s`, as far as one can see.
bool history_belongs(ivec2 at, IN(EdgeTest) s, float allowance) {
    LET_REF(RealtimeConstants) c = load_realtime();
    uint material = load_previous_material(at);
    if (((material ^ s.material) & MATERIAL_SURFACE_BITS) != 0u) { return false; }
    if (!(abs(load_previous_depth(at) - s.depth) <= allowance)) { return false; }
    return normal_cosine(s, load_previous_unmapped_normal(at)) >= c.history_normal;
}

// The mean of the four pixels around `position` that belong to the surface.
History history_at(vec2 position, IN(EdgeTest) s, float moved) {
    LET_REF(RealtimeConstants) c = load_realtime();
    History h = no_history();
    // Also false for motion that is not a number.
    if (!(position.x > -1.0f && position.y > -1.0f && position.x < float(c.size.x) &&
          position.y < float(c.size.y))) {
        return h;
    }
    vec2 corner = floor(position);
    vec2 part = position - corner;
    float allowance = c.history_depth * s.depth + s.slope * (1.5f + moved);
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2(int(corner.x) + (i & 1), int(corner.y) + (i >> 1));
        float weight = ((i & 1) != 0 ? part.x : 1.0f - part.x) *
                       ((i & 2) != 0 ? part.y : 1.0f - part.y);
        if (weight < 1.0e-3f || !pixel_is_inside(at, c.size)) { continue; }
        if (!history_belongs(at, s, allowance)) { continue; }
        vec2 frames = load_previous_history_length(at);
        h.direct += load_direct_history(at) * weight;
        h.specular += load_specular_history(at) * weight;
        h.direct_frames += frames.x * weight;
        h.specular_frames += frames.y * weight;
        sum += weight;
    }
    if (sum > 0.0f) {
        float scale = 1.0f / sum;
        h.direct *= scale;
        h.specular *= scale;
        h.direct_frames *= 255.0f * scale;
        h.specular_frames *= 255.0f * scale;
    }
    return h;
}

// Histories of the surface and, where it reflects, of its mirror image.
History load_history(ivec2 pixel, IN(EdgeTest) s, vec4 motion, float reach) {
    vec2 was = vec2(pixel) + vec2(motion.x, motion.y);
    EdgeTest before = s;
    before.depth = s.depth + motion.z;
    History h = history_at(was, before, 0.0f);
    vec2 offset = virtual_motion(pixel, s.depth, reach, material_roughness(s.material));
    float moved = abs(offset.x) + abs(offset.y);
    if (!(moved > 0.125f)) { return h; }
    History image = history_at(was + offset, before, moved);
    if (image.specular_frames > 0.0f) {
        h.specular = image.specular;
        h.specular_frames = image.specular_frames;
    }
    return h;
}

// Luminance of the pixels around, of the same surface: x direct, y specular.
struct Neighbours {
    vec2 brightest;  // without the pixel itself
    vec2 variance;   // with it
    int count;
};

float neighbour_allowance(float depth, float slope) {
    return load_realtime().history_depth * depth + 2.0f * slope;
}

vec2 neighbour_variance(vec2 sum, vec2 squares, int count) {
    float scale = 1.0f / float(count + 1);
    vec2 mean = sum * scale;
    return max(squares * scale - mean * mean, vec2(0.0f));
}

Neighbours load_neighbours(ivec2 pixel, float depth, float slope) {
    LET_REF(RealtimeConstants) c = load_realtime();
    float allowance = neighbour_allowance(depth, slope);
    vec4 own = load_luma(pixel);
    vec2 sum = vec2(own.x, own.z);
    vec2 squares = sum * sum;
    Neighbours n;
    n.brightest = vec2(0.0f);
    n.count = 0;
    for (int i = 0; i < 9; ++i) {
        ivec2 at = ivec2(pixel.x + i % 3 - 1, pixel.y + i / 3 - 1);
        if (i == 4 || !pixel_is_inside(at, c.size)) { continue; }
        if (!(abs(load_depth(at) - depth) <= allowance)) { continue; }
        vec4 all = load_luma(at);
        vec2 luma = vec2(all.x, all.z);
        n.brightest = max(n.brightest, luma);
        sum += luma;
        squares += luma * luma;
        n.count += 1;
    }
    n.variance = neighbour_variance(sum, squares, n.count);
    return n;
}

// `neighbours`: how many pixels `brightest` is of; of one alone nothing can be said.
Accumulated temporal_channel(IN(NewLight) now, vec4 history, float frames, float limit,
                             float brightest, int neighbours) {
    float before = luminance(vec3(history));
    NewLight calm = now;
    calm.luma = luminance(now.light);
    if (neighbours > 1) {
        float part = firefly_part(calm.luma, max(brightest, before), frames);
        calm.light *= part;
        calm.luma *= part;
    }
    return accumulate(calm, history, before, frames, limit);
}

// How much of the light of a pixel's block has changed, as far as it is to end histories.
vec4 load_change(ivec2 block) {
    LET_REF(RealtimeConstants) c = load_realtime();
    vec4 change = load_gradient(block);
    return vec4(min(change.x * c.direct_antilag, 1.0f), min(change.y * c.indirect_antilag, 1.0f),
                min(change.z * c.specular_antilag, 1.0f), 0.0f);
}

void temporal_pixel(ivec2 pixel, int mode, IN(Neighbours) around) {
    LET_REF(RealtimeConstants) c = load_realtime();
    vec4 direct = finite_or_zero_4(load_direct(pixel));
    vec4 specular = finite_or_zero_4(load_specular(pixel));
    uint material = load_material(pixel);
    float depth = load_depth(pixel);
    if (!pixel_is_lit(material, depth)) {
        store_direct(pixel, direct);
        store_specular(pixel, specular);
        store_history_length(pixel, vec2(0.0f));
        return;
    }
    vec4 motion = finite_or_zero_4(load_motion(pixel));
    EdgeTest s = edge_test(material, depth, motion.w, load_unmapped_normal(pixel));
    History h = no_history();
    if (mode != TEMPORAL_NONE && c.has_previous != 0u &&
        ((s.material >> 16u) & REALTIME_NO_HISTORY) == 0u) {
        h = load_history(pixel, s, motion, specular.w);
    }
    ivec2 block = ivec2(pixel.x / 3, pixel.y / 3);
    vec4 change = vec4(0.0f);
    vec2 limit = vec2(c.svgf_history_frames);
    if (mode == TEMPORAL_ADAPTIVE) {
        change = load_change(block);
        limit = vec2(c.direct_history_frames, c.specular_history_frames);
    }
    NewLight now;
    now.is_repeated = repeated_cell(block) == pixel.x % 3 + 3 * (pixel.y % 3);
    now.light = vec3(direct);
    now.variance = around.variance.x;
    now.change = change.x;
    Accumulated d = temporal_channel(now, h.direct, h.direct_frames, limit.x, around.brightest.x,
                                     around.count);
    now.light = vec3(specular);
    now.variance = around.variance.y;
    now.change = change.z;
    Accumulated r = temporal_channel(now, h.specular, h.specular_frames, limit.y,
                                     around.brightest.y, around.count);
    store_direct(pixel, d.light);
    store_specular(pixel, r.light);
    store_history_length(pixel, vec2(d.frames, r.frames) * (1.0f / 255.0f));
}

void temporal_filter(ivec2 pixel, int mode) {
    float slope = finite_or_zero(load_motion(pixel).w);
    temporal_pixel(pixel, mode, load_neighbours(pixel, load_depth(pixel), slope));
}

#endif
