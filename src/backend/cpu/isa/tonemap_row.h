// From radiance to what a display shows, many pixels at once: part of the hot code, included inside
// an unnamed namespace. Colours lie apart so that the compiler makes vectors of the loop.

#include "kernels/tonemap.glsl"

constexpr size_t tonemapBlock = 64;

struct TonemapBlock {
    float r[tonemapBlock], g[tonemapBlock], b[tonemapBlock], a[tonemapBlock];
};

// A copy of the loop for each curve: a choice inside would be one for each pixel.
template <uint32_t curve>
void tonemapBlockBy(TonemapBlock& t, float scale) {
    for (size_t i = 0; i < tonemapBlock; ++i) {
        const vec4 c = tonemap_pixel(vec4(t.r[i], t.g[i], t.b[i], t.a[i]), scale, curve);
        t.r[i] = c.x, t.g[i] = c.y, t.b[i] = c.z, t.a[i] = c.w;
    }
}

// colorOf(i): linear colour of pixel i of `count`, with alpha.
template <class ColorOf>
void tonemapRow(const ColorOf& colorOf, u8vec4* display, size_t count, float exposureEv,
                uint32_t tonemap) {
    const float scale = std::exp2(exposureEv);
    TonemapBlock t{};
    for (size_t first = 0; first < count; first += tonemapBlock) {
        const size_t n = std::min(count - first, tonemapBlock);
        for (size_t i = 0; i < n; ++i) {
            const vec4 c = colorOf(first + i);
            t.r[i] = c.x, t.g[i] = c.y, t.b[i] = c.z, t.a[i] = c.w;
        }
        switch (tonemap) {
            case TONEMAP_AGX: tonemapBlockBy<TONEMAP_AGX>(t, scale); break;
            case TONEMAP_ACES: tonemapBlockBy<TONEMAP_ACES>(t, scale); break;
            case TONEMAP_REINHARD: tonemapBlockBy<TONEMAP_REINHARD>(t, scale); break;
            default: tonemapBlockBy<~0u>(t, scale);
        }
        for (size_t i = 0; i < n; ++i) {
            display[first + i] =
                u8vec4(vec4(t.r[i], t.g[i], t.b[i], t.a[i]) * 255.0f + 0.5f);
        }
    }
}
