// After BMFR (bmfr_fit.glsl): the mean over frames of what was fitted, in which the borders of the
// blocks, elsewhere in each frame, cannot be seen any more.
// [Koskela et al. 2019, section 3.5]
#ifndef GP_KERNELS_REALTIME_BMFR_ACCUMULATE_GLSL
#define GP_KERNELS_REALTIME_BMFR_ACCUMULATE_GLSL
#include "kernels/realtime/temporal.glsl"

// w of diffuse: frames.
struct FittedLight {
    vec4 diffuse;
    vec4 specular;
};

FittedLight bmfr_history(vec2 position, IN(EdgeTest) s) {
    LET_REF(RealtimeConstants) c = load_realtime();
    FittedLight h;
    h.diffuse = vec4(0.0f);
    h.specular = vec4(0.0f);
    if (!(position.x > -1.0f && position.y > -1.0f && position.x < float(c.size.x) &&
          position.y < float(c.size.y))) {
        return h;
    }
    vec2 corner = floor(position);
    vec2 part = position - corner;
    float allowance = c.history_depth * s.depth + s.slope * 1.5f;
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2(int(corner.x) + (i & 1), int(corner.y) + (i >> 1));
        float weight = ((i & 1) != 0 ? part.x : 1.0f - part.x) *
                       ((i & 2) != 0 ? part.y : 1.0f - part.y);
        if (weight < 1.0e-3f || !pixel_is_inside(at, c.size)) { continue; }
        if (!history_belongs(at, s, allowance)) { continue; }
        h.diffuse += load_previous_fitted_diffuse(at) * weight;
        h.specular += load_previous_fitted_specular(at) * weight;
        sum += weight;
    }
    if (sum > 0.0f) {
        h.diffuse *= 1.0f / sum;
        h.specular *= 1.0f / sum;
    }
    return h;
}

void bmfr_accumulate(ivec2 pixel, int) {
    LET_REF(RealtimeConstants) c = load_realtime();
    FittedLight now;
    now.diffuse = load_direct(pixel);
    now.specular = load_specular(pixel);
    now.diffuse.w = 1.0f;
    uint material = load_material(pixel);
    float depth = load_depth(pixel);
    if (pixel_is_lit(material, depth) && c.has_previous != 0u &&
        ((material >> 16u) & REALTIME_NO_HISTORY) == 0u) {
        vec4 motion = finite_or_zero_4(load_motion(pixel));
        EdgeTest s =
            edge_test(material, depth + motion.z, motion.w, load_unmapped_normal(pixel));
        FittedLight before = bmfr_history(vec2(pixel) + vec2(motion.x, motion.y), s);
        float frames = min(before.diffuse.w + 1.0f, c.bmfr_history_frames);
        now.diffuse = mix(before.diffuse, now.diffuse, 1.0f / frames);
        now.specular = mix(before.specular, now.specular, 1.0f / frames);
        now.diffuse.w = frames;
    }
    store_fitted_diffuse(pixel, now.diffuse);
    store_fitted_specular(pixel, now.specular);
    store_direct(pixel, now.diffuse);
    store_specular(pixel, now.specular);
}

#endif
