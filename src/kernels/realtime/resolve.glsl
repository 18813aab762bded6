// The picture from this frame's samples and the last picture: anti-aliasing over time, and
// upscaling where there are fewer rays than pixels.
// Based on: Karis 2014, "High-Quality Temporal Supersampling"; Salvi 2016, "An Excursion in
// Temporal Supersampling" (variance clipping).
// Resources: load_color, load_depth, load_motion, load_previous_output, store_output,
// load_realtime.
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
    vec2 motion;     // in pixels of rays, of what is nearest to the viewer: edges move with it
};

// How much a sample at a distance of `d` pixels of the picture counts: Blackman-Harris' window in a
// Gaussian's shape. [Karis 2014, slide "Filtering"]
float resolve_weight(vec2 d) {
    return exp(-2.29f * dot(d, d));
}

// `at`: in pixels of rays.
Neighbourhood resolve_neighbourhood(vec2 at, vec2 rays_to_output) {
    LET_REF(RealtimeConstants) r = load_realtime();
    Neighbourhood n;
    n.mean = vec4(0.0f);
    n.here = vec4(0.0f);
    n.nearness = 0.0f;
    n.motion = vec2(0.0f);
    vec4 squares = vec4(0.0f);
    float weights = 0.0f;
    float nearest = FLOAT_MAX;
    ivec2 centre = ivec2(int(floor(at.x)), int(floor(at.y)));
    for (int i = 0; i < 9; ++i) {
        ivec2 p = clamp(centre + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), r.size - 1);
        vec4 c = resolve_encoded(load_color(p));
        n.mean += c;
        squares += c * c;
        vec2 sample_at = vec2(float(p.x) + 0.5f, float(p.y) + 0.5f) + r.jitter;
        float w = resolve_weight((sample_at - at) * rays_to_output);
        n.here += c * w;
        weights += w;
        n.nearness = max(n.nearness, w);
        float depth = load_depth(p);
        if (depth < nearest) {
            nearest = depth;
            vec4 motion = load_motion(p);
            n.motion = vec2(motion.x, motion.y);
        }
    }
    n.mean *= 1.0f / 9.0f;
    n.deviation = sqrt(max(squares * (1.0f / 9.0f) - n.mean * n.mean, vec4(0.0f)));
    n.here = weights > 1.0e-8f ? n.here / weights : n.mean;
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

void realtime_resolve(ivec2 pixel) {
    LET_REF(RealtimeConstants) r = load_realtime();
    if (r.resolves == 0u) {
        store_output(pixel, load_color(pixel));
        return;
    }
    vec2 scale = vec2(float(r.output_size.x) / float(r.size.x),
                      float(r.output_size.y) / float(r.size.y));
    vec2 at = vec2(float(pixel.x) + 0.5f, float(pixel.y) + 0.5f);
    Neighbourhood n = resolve_neighbourhood(at / scale, scale);
    vec2 before = at + n.motion * scale;
    bool inside = before.x > 0.0f && before.y > 0.0f && before.x < float(r.output_size.x) &&
                  before.y < float(r.output_size.y);
    vec4 result = n.here;
    if (r.has_previous != 0u && inside) {
        vec4 history = resolve_history(before);
        vec4 widest = n.deviation * r.resolve_clip;
        history = clamp(history, n.mean - widest, n.mean + widest);
        // A sample far from the point says little about it.
        result = mix(history, n.here, max(r.resolve_share * n.nearness, 0.02f));
    }
    store_output(pixel, resolve_decoded(result));
}

#endif
