// What the passes of the denoisers share: how much of a neighbour's light may be used, and how
// light is accumulated over frames.
#ifndef GP_KERNELS_REALTIME_EDGE_STOP_GLSL
#define GP_KERNELS_REALTIME_EDGE_STOP_GLSL
#include "kernels/realtime/gbuffer.glsl"
#include "shading/colour.glsl"
#include "shading/frame.glsl"

// What temporal_filter and indirect_temporal do with the last frame.
#define TEMPORAL_NONE 0      // nothing: every frame is the first
#define TEMPORAL_FIXED 1     // SVGF: the same share of every frame
#define TEMPORAL_ADAPTIVE 2  // A-SVGF: less of it where the gradients say that light has changed

// The weight of a neighbour whose differences (of depth, normal, luminance, each over what is
// allowed) sum up to x: e^-x where it counts, 0 from 4 on, so that very different pixels have no
// share at all. Edge-stopping functions are exponentials by tradition only
// [Dammertz et al. 2010, "Edge-Avoiding A-Trous Wavelet Transform", section 3.1]; a polynomial
// costs two multiplications.
float edge_weight(float x) {
    float y = x < 4.0f ? 1.0f - 0.25f * x : 0.0f;  // 0 for NaN too
    float y2 = y * y;
    return y2 * y2;
}

// NaN and what is beyond a half become 0: one bad ray must not last for a whole history.
float finite_or_zero(float v) {
    return abs(v) <= 65504.0f ? v : 0.0f;
}

vec4 finite_or_zero_4(vec4 v) {
    return vec4(finite_or_zero(v.x), finite_or_zero(v.y), finite_or_zero(v.z),
                finite_or_zero(v.w));
}

bool pixel_is_lit(uint material, float depth) {
    return depth < DEPTH_NONE && ((material >> 16u) & (REALTIME_SKY | REALTIME_UNLIT)) == 0u;
}

bool pixel_is_inside(ivec2 at, ivec2 size) {
    return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
}

// What surfaces of neighbours are compared with. `slope`: of depth, metres a pixel.
struct EdgeTest {
    vec3 normal;
    uint normal_code;  // as it is stored
    float depth;
    float slope;
    uint material;
};

EdgeTest edge_test(uint material, float depth, float slope, uint normal) {
    EdgeTest s;
    s.material = material;
    s.depth = depth;
    s.slope = slope;
    s.normal_code = normal;
    s.normal = octahedral_decode(normal);
    return s;
}

// Of the angle to another stored normal. Most neighbours lie on one plane.
float normal_cosine(IN(EdgeTest) s, uint other) {
    return other == s.normal_code ? 1.0f : dot(octahedral_decode(other), s.normal);
}

// Depth per pixel of distance that a plane may have, and what rounding and curvature add.
float depth_allowance(float depth, float slope, float distance, float tolerance) {
    return slope * distance * tolerance + 0.002f * depth;
}

// What is kept of light that is many times brighter than all its neighbours and its past: one
// path's luck. Where all is black and there is no past, sparse light is all that can be seen.
float firefly_part(float luma, float brightest, float frames) {
    LET_REF(RealtimeConstants) c = load_realtime();
    float most = brightest * c.firefly_limit;
    return luma > most && (brightest > 0.0f || frames > 0.0f) ? most / luma : 1.0f;
}

// Light of one frame, to be added to a history.
struct NewLight {
    vec3 light;
    float luma;
    float variance;   // of the luminance of the pixels around
    float change;     // how much of the light is known to be new: 0..1
    bool is_repeated; // it repeats the last frame's draws
};

// Light that was accumulated: w is the variance of one frame's luminance.
struct Accumulated {
    vec4 light;
    float frames;
};

// The share of the new frame in the mean of `frames`. Where light has changed much, the history is
// of another light and goes at once.
float new_share(float frames, float change) {
    return mix(1.0f / frames, 1.0f, change);
}

// The frames of a history that are left if `change` of its light is new.
float frames_kept(float frames, float change) {
    float kept = 1.0f - change;
    float kept2 = kept * kept;
    float kept4 = kept2 * kept2;
    return frames * kept4 * kept4 * kept2;
}

// The mean over `frames` frames and one more, over `limit` at most.
// Mean and variance as they come in. [West 1979, "Updating Mean and Variance Estimates"]
// A first frame has no variance of its own; the one of its neighbours stands in, which leaves the
// estimate without bias, as the expectation of later terms is the variance itself.
// What repeats the last frame's draws says nothing new, unless light has changed; and of a block
// the brightest is chosen for it, so that it would brighten the mean. It counts as far as light has
// changed: fully from a fiftieth on, as pixels that lag behind their neighbours make a pattern.
Accumulated accumulate(IN(NewLight) now, vec4 history, float history_luma, float frames,
                       float limit) {
    float before = frames_kept(frames, now.change);
    float counts = now.is_repeated && before >= 1.0f ? min(50.0f * now.change, 1.0f) : 1.0f;
    Accumulated a;
    a.frames = min(before + counts, limit);
    float share = counts * new_share(a.frames, now.change);
    float difference = now.luma - history_luma;
    float variance = (1.0f - share) * (history.w + share * difference * difference);
    float share2 = share * share;
    a.light = vec4(mix(vec3(history), now.light, share),
                   mix(variance, now.variance, share2 * share2));
    return a;
}

// The pixel of a block (0..8) that repeats the last frame's draws; -1: none.
int repeated_cell(ivec2 block) {
    LET_REF(RealtimeConstants) c = load_realtime();
    if (c.repeats_draws == 0u || c.has_previous == 0u) { return -1; }
    return int(load_gradient_sample(block) & 15u) - 1;
}

// One over the difference of luminance that is noise, in iteration `i` of the filter: each halves
// the noise about [Dammertz et al. 2010, section 3.2]. The mean of n frames has an nth of the
// variance; a single frame knows nothing, and all that it sees may be noise. Few frames are no bell
// curve either, but sparks far from the mean: until there are many, the stop is wider.
float luminance_stop(float luma, float variance, float frames, int iteration, float deviations) {
    float share = 1.0f / max(frames, 1.0f);
    float noise = sqrt(max(variance, 0.0f) * share) / float(1 << iteration);
    float trust = clamp((frames - 1.0f) * (1.0f / 3.0f), 0.0f, 1.0f);
    return trust / (deviations * (1.0f + 3.0f * share) * noise + 1.0e-3f * abs(luma) + 1.0e-7f);
}

#endif
