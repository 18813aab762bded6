// The picture from this frame's samples and the last picture: anti-aliasing over time, and
// upscaling where there are fewer rays than pixels.
// Based on: Karis 2014, "High-Quality Temporal Supersampling"; Salvi 2016, "An Excursion in
// Temporal Supersampling" (variance clipping).
// Resources: load_color, load_depth, load_previous_depth, load_motion, load_previous_output,
// store_output, load_realtime.
#ifndef GP_KERNELS_REALTIME_RESOLVE_GLSL
#define GP_KERNELS_REALTIME_RESOLVE_GLSL
#include "shading/colour.glsl"
#include "shading/ycocg.glsl"
#include "shared/realtime_structs.glsl"

// Bright values are brought near, so that one of them among eight dark ones does not flicker.
// [Karis 2014, slide "Tone mapping"]: c / (1 + luminance), and its inverse.
vec3 resolve_compressed(vec3 c) {
    return c / (1.0f + luminance(c));
}

vec3 resolve_expanded(vec3 c) {
    return c / max(1.0f - luminance(c), 1.0e-4f);
}

// Compressed YCoCg and coverage.
vec4 resolve_encoded(vec4 color) {
    return vec4(ycocg_from_rgb(resolve_compressed(vec3(color))), color.w);
}

vec4 resolve_decoded(vec4 c) {
    vec3 rgb = max(rgb_from_ycocg(vec3(c)), vec3(0.0f));
    return vec4(resolve_expanded(rgb), clamp(c.w, 0.0f, 1.0f));
}

// What the samples around a point of the picture say.
struct Neighbourhood {
    vec4 mean;       // of the nine
    vec4 deviation;
    vec4 here;       // weighted by how near they are
    float nearness;  // of the nearest: 1 where it lies on the point
};

// How much each of three samples along an axis counts, the middle one in pixel `centre`, at a
// distance of d pixels of the picture: Blackman-Harris' window in a Gaussian's shape.
// [Karis 2014, slide "Filtering"]
vec3 resolve_weights(float at, int centre, float jitter, float rays_to_output, int size) {
    vec3 d = vec3(float(clamp(centre - 1, 0, size - 1)), float(centre),
                  float(clamp(centre + 1, 0, size - 1)));
    d = (d + (0.5f + jitter - at)) * rays_to_output;
    d = d * d * -2.29f;
    return vec3(exp(d.x), exp(d.y), exp(d.z));
}

// `sum`, `squares`: of nine; `here`: weighted by the products of wx and wy.
Neighbourhood resolve_neighbourhood(vec4 sum, vec4 squares, vec4 here, vec3 wx, vec3 wy) {
    Neighbourhood n;
    n.mean = sum * (1.0f / 9.0f);
    n.deviation = sqrt(max(squares * (1.0f / 9.0f) - n.mean * n.mean, vec4(0.0f)));
    float weights = (wx.x + wx.y + wx.z) * (wy.x + wy.y + wy.z);
    n.here = weights > 1.0e-8f ? here / weights : n.mean;
    n.nearness = max(wx.x, max(wx.y, wx.z)) * max(wy.x, max(wy.y, wy.z));
    return n;
}

// Weights of four neighbours of a point at the fraction f behind the second.
// [Catmull and Rom 1974, "A Class of Local Interpolating Splines"]
vec4 catmull_rom_weights(float f) {
    return vec4(f * (-0.5f + f * (1.0f - 0.5f * f)), 1.0f + f * f * (-2.5f + 1.5f * f),
                f * (0.5f + f * (2.0f - 1.5f * f)), f * f * (-0.5f + 0.5f * f));
}

// The last picture at a point in its pixels.
vec4 resolve_history(vec2 at) {
    LET_REF(RealtimeConstants) r = load_realtime();
    vec2 corner = vec2(floor(at.x - 0.5f), floor(at.y - 0.5f));
    vec4 wx = catmull_rom_weights(at.x - 0.5f - corner.x);
    vec4 wy = catmull_rom_weights(at.y - 0.5f - corner.y);
    ivec2 first = ivec2(int(corner.x) - 1, int(corner.y) - 1);
    vec4 sum = vec4(0.0f);
    for (int j = 0; j < 4; ++j) {
        if (wy[j] == 0.0f) { continue; }
        for (int i = 0; i < 4; ++i) {
            if (wx[i] == 0.0f) { continue; }
            ivec2 p = clamp(first + ivec2(i, j), ivec2(0), r.output_size - 1);
            sum += resolve_encoded(load_previous_output(p)) * (wx[i] * wy[j]);
        }
    }
    return sum;
}

// The picture where the samples around are `n` and it was `history`, if it was seen.
vec4 resolve_mixed(IN(Neighbourhood) n, vec4 history, bool was_seen) {
    LET_REF(RealtimeConstants) r = load_realtime();
    vec4 widest = n.deviation * r.resolve_clip;
    vec4 past = clamp(history, n.mean - widest, n.mean + widest);
    // A sample far from the point says little about it.
    float share = was_seen ? max(r.resolve_share * n.nearness, 0.02f) : 1.0f;
    return resolve_decoded(mix(past, n.here, share));
}

// How much nearer than it should be whatever covered a point in the last frame is, relatively.
#define RESOLVE_COVERED 0.1f

// Whether the last frame saw what has come from `at`, counted in rays, and was `depth` away then.
// Clipping to the neighbourhood alone leaves ghosts of what moved before a bright or noisy surface.
bool resolve_was_open(vec2 at, float depth) {
    LET_REF(RealtimeConstants) r = load_realtime();
    ivec2 corner = ivec2(int(floor(at.x - 0.5f)), int(floor(at.y - 0.5f)));
    float least = depth * (1.0f - RESOLVE_COVERED);
    for (int i = 0; i < 4; ++i) {
        ivec2 p = clamp(corner + ivec2(i & 1, i >> 1), ivec2(0), r.size - 1);
        if (load_previous_depth(p) >= least) { return true; }
    }
    return false;
}

bool resolve_is_inside(vec2 at, vec2 size) {
    return at.x > 0.0f && at.y > 0.0f && at.x < size.x && at.y < size.y;
}

void realtime_resolve(ivec2 pixel, int) {
    LET_REF(RealtimeConstants) r = load_realtime();
    if (r.resolves == 0u) {
        store_output(pixel, load_color(pixel));
        return;
    }
    vec2 scale = vec2(r.output_size) / vec2(r.size);
    vec2 point = vec2(pixel) + 0.5f;
    vec2 at = point / scale;  // in pixels of rays
    ivec2 centre = ivec2(int(floor(at.x)), int(floor(at.y)));
    vec3 wx = resolve_weights(at.x, centre.x, r.jitter.x, scale.x, r.size.x);
    vec3 wy = resolve_weights(at.y, centre.y, r.jitter.y, scale.y, r.size.y);
    vec4 sum = vec4(0.0f);
    vec4 squares = vec4(0.0f);
    vec4 here = vec4(0.0f);
    float nearest = FLOAT_MAX;
    ivec2 nearest_at = centre;
    for (int i = 0; i < 9; ++i) {
        ivec2 p = clamp(centre + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), r.size - 1);
        vec4 c = resolve_encoded(load_color(p));
        sum += c;
        squares += c * c;
        here += c * (wx[i % 3] * wy[i / 3]);
        float depth = load_depth(p);
        if (depth < nearest) {
            nearest = depth;
            nearest_at = p;
        }
    }
    // Edges move with what is nearest to the viewer.
    vec4 motion = load_motion(nearest_at);
    vec2 before = point + vec2(motion.x, motion.y) * scale;
    bool was_seen = r.has_previous != 0u && resolve_is_inside(before, vec2(r.output_size)) &&
                    resolve_was_open(before / scale, nearest + motion.z);
    vec4 history = was_seen ? resolve_history(before) : vec4(0.0f);
    Neighbourhood n = resolve_neighbourhood(sum, squares, here, wx, wy);
    store_output(pixel, resolve_mixed(n, history, was_seen));
}

#endif
