// What rasterised geometry does to a pixel: tests of depth and alpha, and blending.
#ifndef GP_SHADING_BLENDING_GLSL
#define GP_SHADING_BLENDING_GLSL

// GpBlendFactor; its default has been replaced by what it stands for.
#define BLEND_ZERO 1u
#define BLEND_ONE 2u
#define BLEND_SRC_COLOR 3u
#define BLEND_ONE_MINUS_SRC_COLOR 4u
#define BLEND_SRC_ALPHA 5u
#define BLEND_ONE_MINUS_SRC_ALPHA 6u
#define BLEND_DST_ALPHA 7u
#define BLEND_ONE_MINUS_DST_ALPHA 8u
#define BLEND_DST_COLOR 9u
#define BLEND_ONE_MINUS_DST_COLOR 10u
#define BLEND_SRC_ALPHA_SATURATE 11u

// GpDepthTest, without its default.
#define DEPTH_NEVER 1u
#define DEPTH_LESS 2u
#define DEPTH_EQUAL 3u
#define DEPTH_LESS_OR_EQUAL 4u
#define DEPTH_GREATER 5u
#define DEPTH_NOT_EQUAL 6u
#define DEPTH_GREATER_OR_EQUAL 7u
#define DEPTH_ALWAYS 8u

// The most that a pixel of radiance holds after blending: sums of such values are still finite.
#define BLEND_RADIANCE_MAX 1.0e30f

struct BlendState {
    uint source;             // factors of colour
    uint destination;
    uint source_alpha;       // factors of alpha
    uint destination_alpha;
};

// [OpenGL 2.1 specification, table 4.2]
vec4 blend_factor(uint factor, vec4 src, vec4 dst) {
    if (factor == BLEND_ONE) { return vec4(1.0f); }
    if (factor == BLEND_SRC_COLOR) { return src; }
    if (factor == BLEND_ONE_MINUS_SRC_COLOR) { return vec4(1.0f) - src; }
    if (factor == BLEND_SRC_ALPHA) { return vec4(src.w); }
    if (factor == BLEND_ONE_MINUS_SRC_ALPHA) { return vec4(1.0f - src.w); }
    if (factor == BLEND_DST_ALPHA) { return vec4(dst.w); }
    if (factor == BLEND_ONE_MINUS_DST_ALPHA) { return vec4(1.0f - dst.w); }
    if (factor == BLEND_DST_COLOR) { return dst; }
    if (factor == BLEND_ONE_MINUS_DST_COLOR) { return vec4(1.0f) - dst; }
    if (factor == BLEND_SRC_ALPHA_SATURATE) {
        return vec4(vec3(min(src.w, 1.0f - dst.w)), 1.0f);
    }
    return vec4(0.0f);
}

// NaN becomes 0: the comparison with it is false.
float blend_limited(float v, float most) {
    return v > 0.0f ? min(v, most) : 0.0f;
}

// Source over destination by the factors, not below 0; colour not above `most`, which is 1 for a
// display and BLEND_RADIANCE_MAX for radiance, and alpha not above 1.
// [OpenGL 2.1 specification, section 4.1.8, FUNC_ADD]
vec4 blend_pixel(IN(BlendState) s, vec4 src, vec4 dst, float most) {
    vec4 colour = src * blend_factor(s.source, src, dst) +
                  dst * blend_factor(s.destination, src, dst);
    float alpha = src.w * blend_factor(s.source_alpha, src, dst).w +
                  dst.w * blend_factor(s.destination_alpha, src, dst).w;
    return vec4(blend_limited(colour.x, most), blend_limited(colour.y, most),
                blend_limited(colour.z, most), blend_limited(alpha, 1.0f));
}

// `test` for what is drawn at `depth` where `held` is there. NaN passes only DEPTH_NOT_EQUAL and
// DEPTH_ALWAYS.
bool depth_test_passes(uint test, float depth, float held) {
    if (test == DEPTH_LESS) { return depth < held; }
    if (test == DEPTH_EQUAL) { return depth == held; }
    if (test == DEPTH_LESS_OR_EQUAL) { return depth <= held; }
    if (test == DEPTH_GREATER) { return depth > held; }
    if (test == DEPTH_NOT_EQUAL) { return depth != held; }
    if (test == DEPTH_GREATER_OR_EQUAL) { return depth >= held; }
    return test == DEPTH_ALWAYS;
}

// The level of detail of a texture of `texels` (width, height) whose coordinates change by `d_dx`
// and `d_dy` from pixel to pixel: log2 of the longer side. -infinity where nothing changes.
// [OpenGL 2.1 specification, section 3.8.8]
float texture_level_of_detail(vec2 d_dx, vec2 d_dy, vec2 texels) {
    vec2 x = d_dx * texels;
    vec2 y = d_dy * texels;
    return 0.5f * log2(max(dot(x, x), dot(y, y)));
}

#endif
