// Colour: luminance, the sRGB transfer function, and tone maps. Linear values have the primaries of
// Rec. 709; a tone map takes scene light with 1 as a white surface's and gives display light in
// [0, 1], still linear: srgb_encode comes after it.
#ifndef GP_SHADING_COLOUR_GLSL
#define GP_SHADING_COLOUR_GLSL
#include "shading/powers.glsl"

// [ITU-R BT.709-6, item 3.2]
IN_LOOPS float luminance(vec3 c) {
    return dot(c, vec3(0.2126f, 0.7152f, 0.0722f));
}

// [IEC 61966-2-1]
IN_LOOPS float srgb_encode_1(float v) {
    float curve = 1.055f * pow_above_0(v, 1.0f / 2.4f) - 0.055f;
    return v <= 0.0031308f ? 12.92f * v : curve;
}

float srgb_decode_1(float v) {
    return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f);
}

IN_LOOPS vec3 srgb_encode(vec3 c) {
    return vec3(srgb_encode_1(c.x), srgb_encode_1(c.y), srgb_encode_1(c.z));
}

vec3 srgb_decode(vec3 c) {
    return vec3(srgb_decode_1(c.x), srgb_decode_1(c.y), srgb_decode_1(c.z));
}

// The luminance that becomes white.
#define REINHARD_WHITE 4.0f

// [Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", equation 4], on
// luminance, so that hue and saturation stay until a channel reaches 1.
IN_LOOPS vec3 tonemap_reinhard(vec3 c) {
    float l = luminance(c);
    float scale = (1.0f + l / (REINHARD_WHITE * REINHARD_WHITE)) / (1.0f + l);
    return clamp(c * scale, vec3(0.0f), vec3(1.0f));
}

// The ACES reference rendering and sRGB output transforms in one curve between two matrices.
// [Stephen Hill's fit, 2017: github.com/TheRealMJP/BakingLab, ACES.hlsl]
IN_LOOPS vec3 tonemap_aces(vec3 c) {
    vec3 v = vec3(dot(vec3(0.59719f, 0.35458f, 0.04823f), c),
                  dot(vec3(0.07600f, 0.90834f, 0.01566f), c),
                  dot(vec3(0.02840f, 0.13383f, 0.83777f), c));
    v = max(v, vec3(0.0f));
    // The quotient tends to 1 / 0.98; large values are cut before their square overflows.
    v = min(v, vec3(1.0e6f));
    vec3 a = v * (v + vec3(0.0245786f)) - vec3(0.000090537f);
    vec3 b = v * (0.983729f * v + vec3(0.4329510f)) + vec3(0.238081f);
    v = a / b;
    vec3 display = vec3(dot(vec3(1.60475f, -0.53108f, -0.07367f), v),
                        dot(vec3(-0.10208f, 1.10813f, -0.00605f), v),
                        dot(vec3(-0.00327f, -0.07276f, 1.07602f), v));
    return clamp(display, vec3(0.0f), vec3(1.0f));
}

// The default contrast of AgX over [0, 1], whose ends are min_ev and max_ev below.
// [Wrensch 2023, "Minimal AgX Implementation", 6th-order fit]
IN_LOOPS float agx_contrast(float x) {
    float x2 = x * x;
    float x4 = x2 * x2;
    return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 +
           0.1191f * x - 0.00232f;
}

// AgX (Troy Sobotka) without a look. The curve gives values for a display of gamma 2.2, which are
// made linear at the end, as all tone maps here are.
// [Wrensch 2023, "Minimal AgX Implementation", iolite-engine.com/blog_posts]
IN_LOOPS vec3 tonemap_agx(vec3 c) {
    float min_ev = -12.47393f;
    float max_ev = 4.026069f;
    vec3 v = vec3(dot(vec3(0.842479062253094f, 0.0784335999999992f, 0.0792237451477643f), c),
                  dot(vec3(0.0423282422610123f, 0.878468636469772f, 0.0791661274605434f), c),
                  dot(vec3(0.0423756549057051f, 0.0784336f, 0.879142973793104f), c));
    v = clamp(vec3(log2_above_0(max(v.x, 1.0e-10f)), log2_above_0(max(v.y, 1.0e-10f)),
                   log2_above_0(max(v.z, 1.0e-10f))), vec3(min_ev), vec3(max_ev));
    v = (v - vec3(min_ev)) / (max_ev - min_ev);
    v = vec3(agx_contrast(v.x), agx_contrast(v.y), agx_contrast(v.z));
    vec3 d = vec3(dot(vec3(1.19687900512017f, -0.0980208811401368f, -0.0990297440797205f), v),
                  dot(vec3(-0.0528968517574562f, 1.15190312990417f, -0.0989611768448433f), v),
                  dot(vec3(-0.0529716355144438f, -0.0980434501171241f, 1.15107367264116f), v));
    d = clamp(d, vec3(0.0f), vec3(1.0f));
    return vec3(pow_above_0(d.x, 2.2f), pow_above_0(d.y, 2.2f), pow_above_0(d.z, 2.2f));
}

#endif
