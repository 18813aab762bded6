// Textures under rasterised geometry: part of the hot code, included inside an unnamed namespace by
// isa/raster.inc only. texture_sampling.h is the plain way; what is fast here is held to it by
// tests/render/raster_texture_test.cpp.

// How the coordinates change to the next pixel, [OpenGL 2.1 specification, section 3.8.8]: for u w
// and v w over 1 / w by the rule for quotients.
inline float levelOfDetail(const RasterTriangle& t, const TextureView& texture, float u, float v,
                           float w) {
    const auto slope = [&](double change, double inverseChange, float value) {
        return (float(change) - value * float(inverseChange)) * w;
    };
    const vec2 dx(slope(t.u.dx, t.inverseW.dx, u), slope(t.v.dx, t.inverseW.dx, v));
    const vec2 dy(slope(t.u.dy, t.inverseW.dy, u), slope(t.v.dy, t.inverseW.dy, v));
    return texture_level_of_detail(dx, dy, vec2(float(texture.width), float(texture.height)));
}

// The two levels that are mixed, and how much of the second. Magnified, or without smaller copies,
// it is the image itself.
struct Levels {
    int first, second;
    float share;
};
inline Levels levelsOf(const TextureView& t, float lod) {
    const int last = int(t.levelCount) - 1;
    if (!(lod > 0.0f)) return {0, 0, 0.0f};
    if (lod >= float(last)) return {last, last, 0.0f};
    const int level = int(lod);
    const float share = lod - float(level);
    if (t.minNearest) return {level + (share >= 0.5f), level + (share >= 0.5f), 0.0f};
    return {level, level + 1, share};
}

inline vec4 sampleLevels(const TextureView& t, const Levels& levels, bool magnified, vec2 uv) {
    const bool nearest = magnified ? t.magNearest : t.minNearest;
    const vec4 first = sampleLevel(t, levels.first, nearest, uv);
    if (levels.share == 0.0f) return first;
    return mix(first, sampleLevel(t, levels.second, nearest, uv), levels.share);
}

// ------------------------------------------------------------------- eight bits, bilinear, a run

// wrapTexel for indices within one size of the image, without branches and remainders.
inline int wrapNear(int i, int n, uint8_t wrap) {
    if (wrap == 1) return std::min(std::max(i, 0), n - 1);
    if (wrap == 2) {
        i = i < 0 ? -1 - i : i;
        i = i >= 2 * n ? i - 2 * n : i;
        return i >= n ? 2 * n - 1 - i : i;
    }
    i = i < 0 ? i + n : i;
    i = i >= n ? i - n : i;
    return i >= n ? i - n : i;
}

// Along one side: the texels on both sides of each coordinate, and the share of the second.
struct TexelPairs {
    alignas(64) int first[runLength], second[runLength];
    alignas(64) float share[runLength];
};
template <uint8_t wrap>
inline void texelPairs(TexelPairs& out, const float* coordinates, int size) {
    for (uint32_t i = 0; i < runLength; ++i) {
        float u = coordinates[i];
        if (wrap != 1) u -= 2.0f * std::floor(0.5f * u);
        u = u > -1.0f ? u : -1.0f;  // NaN becomes a number too
        u = u < 2.0f ? u : 2.0f;
        const float at = u * float(size) - 0.5f;
        const float below = std::floor(at);
        const int texel = int(below);
        out.share[i] = at - below;
        out.first[i] = wrapNear(texel, size, wrap);
        out.second[i] = wrapNear(texel + 1, size, wrap);
    }
}
inline void texelPairs(TexelPairs& out, const float* coordinates, int size, uint8_t wrap) {
    if (wrap == 1) return texelPairs<1>(out, coordinates, size);
    if (wrap == 2) return texelPairs<2>(out, coordinates, size);
    texelPairs<0>(out, coordinates, size);
}

// One channel of a packed texel as it is decoded.
template <int channel, bool srgb>
inline float channelOf(uint32_t texel) {
    const int byte = int((texel >> (8 * channel)) & 255u);
    if constexpr (srgb && channel < 3) return decodeTables.srgb[byte];
    return float(byte) * (1.0f / 255.0f);
}

struct TexelCorners {
    alignas(64) uint32_t c00[runLength], c10[runLength], c01[runLength], c11[runLength];
};

template <int channel, bool srgb>
inline void mixCorners(float* out, const TexelCorners& t, const TexelPairs& x,
                       const TexelPairs& y) {
    for (uint32_t i = 0; i < runLength; ++i) {
        const float top = mix(channelOf<channel, srgb>(t.c00[i]), channelOf<channel, srgb>(t.c10[i]),
                              x.share[i]);
        const float low = mix(channelOf<channel, srgb>(t.c01[i]), channelOf<channel, srgb>(t.c11[i]),
                              x.share[i]);
        out[i] = mix(top, low, y.share[i]);
    }
}

// sampleLevel for a run of coordinates.
inline void sampleBytes(const TextureView& t, int level, Run& run) {
    const int w = std::max(1, int(t.width >> level)), h = std::max(1, int(t.height >> level));
    TexelPairs x, y;
    texelPairs(x, run.u, w, t.wrapU);
    texelPairs(y, run.v, h, t.wrapV);
    const auto* texels = reinterpret_cast<const uint32_t*>(t.levels[level]);
    TexelCorners c;
    for (uint32_t i = 0; i < runLength; ++i) {
        // Offsets fit: an image has at most 2^28 texels.
        const int top = y.first[i] * w, low = y.second[i] * w;
        c.c00[i] = texels[top + x.first[i]], c.c10[i] = texels[top + x.second[i]];
        c.c01[i] = texels[low + x.first[i]], c.c11[i] = texels[low + x.second[i]];
    }
    if (t.isSrgb) {
        mixCorners<0, true>(run.r, c, x, y), mixCorners<1, true>(run.g, c, x, y);
        mixCorners<2, true>(run.b, c, x, y);
    } else {
        mixCorners<0, false>(run.r, c, x, y), mixCorners<1, false>(run.g, c, x, y);
        mixCorners<2, false>(run.b, c, x, y);
    }
    mixCorners<3, false>(run.a, c, x, y);
}

// ----------------------------------------------------------------------------------- any texture

inline void putTexel(Run& run, uint32_t i, const vec4& c) {
    run.r[i] = c.x, run.g[i] = c.y, run.b[i] = c.z, run.a[i] = c.w;
}

// The texels of a run at its u and v into its colour.
inline void textureRun(Run& run, const RasterTriangle& t, const RasterDraw& draw) {
    const TextureView& texture = draw.texture;
    const bool detailed = texture.levelCount > 1 || texture.magNearest != texture.minNearest;
    const bool oneLevel = t.parallel || !detailed;
    const float lod =
        oneLevel && detailed ? levelOfDetail(t, texture, run.u[0], run.v[0], 1.0f) : 0.0f;
    const Levels levels = levelsOf(texture, lod);
    const bool nearest = lod > 0.0f ? texture.minNearest : texture.magNearest;
    if (oneLevel && !nearest && !texture.isFloat && levels.share == 0.0f) {
        sampleBytes(texture, levels.first, run);
    } else {
        for (uint32_t i = 0; i < run.count; ++i) {
            const float own =
                oneLevel ? lod : levelOfDetail(t, texture, run.u[i], run.v[i], run.w[i]);
            putTexel(run, i, sampleLevels(texture, levelsOf(texture, own), !(own > 0.0f),
                                          vec2(run.u[i], run.v[i])));
        }
    }
    if (!draw.encodeTexels) return;
    for (uint32_t i = 0; i < run.count; ++i) {
        const vec3 c = clamp(vec3(run.r[i], run.g[i], run.b[i]), vec3(0.0f), vec3(1.0f));
        putTexel(run, i, vec4(srgb_encode(c), run.a[i]));
    }
}
