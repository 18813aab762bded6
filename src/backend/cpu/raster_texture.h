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

// Along one side: the texels on both sides of each coordinate, and the share of the second.
struct TexelPairs {
    alignas(64) int first[runLength], second[runLength];
    alignas(64) float share[runLength];
};

// wrapTexel without branches and remainders, for coordinates that were brought close before.
template <uint8_t wrap>
inline void texelPairs(TexelPairs& out, const float* coordinates, int size) {
    const int last = size - 1;
    for (uint32_t i = 0; i < runLength; ++i) {
        float u = coordinates[i];
        if (wrap == 0) u -= std::floor(u);
        if (wrap == 2) u -= 2.0f * std::floor(0.5f * u);
        u = u > -1.0f ? u : -1.0f;  // NaN becomes a number too
        u = u < 2.0f ? u : 2.0f;
        const float at = u * float(size) - 0.5f;
        const float below = std::floor(at);
        int first = int(below), second = int(below) + 1;
        out.share[i] = at - below;
        if (wrap == 0) {
            first = first < 0 ? last : first;
            second = second > last ? 0 : second;
        } else if (wrap == 2) {
            first = first > last ? 2 * size - 1 - first : first;
            second = second > last ? 2 * size - 1 - second : second;
        }
        out.first[i] = std::min(std::max(first, 0), last);
        out.second[i] = std::min(std::max(second, 0), last);
    }
}
inline void texelPairs(TexelPairs& out, const float* coordinates, int size, uint8_t wrap) {
    if (wrap == 1) return texelPairs<1>(out, coordinates, size);
    if (wrap == 2) return texelPairs<2>(out, coordinates, size);
    texelPairs<0>(out, coordinates, size);
}

// One channel of a packed texel: decoded, or 0..255.
template <int channel, bool srgb>
inline float channelOf(uint32_t texel) {
    const int byte = int((texel >> (8 * channel)) & 255u);
    return srgb ? decodeTables.srgb[byte] : float(byte);
}

struct TexelCorners {
    alignas(64) uint32_t c00[runLength], c10[runLength], c01[runLength], c11[runLength];
};

template <int channel, bool srgb>
inline void mixCorners(float* out, const TexelCorners& t, const TexelPairs& x,
                       const TexelPairs& y) {
    for (uint32_t i = 0; i < runLength; ++i) {
        const auto across = [&](uint32_t left, uint32_t right) {
            return mix(channelOf<channel, srgb>(left), channelOf<channel, srgb>(right), x.share[i]);
        };
        const float top = across(t.c00[i], t.c10[i]), low = across(t.c01[i], t.c11[i]);
        out[i] = mix(top, low, y.share[i]) * (srgb ? 1.0f : 1.0f / 255.0f);
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

inline void encodeRun(Run& run) {
    for (uint32_t i = 0; i < run.count; ++i) {
        const vec3 c = clamp(vec3(run.r[i], run.g[i], run.b[i]), vec3(0.0f), vec3(1.0f));
        putTexel(run, i, vec4(srgb_encode(c), run.a[i]));
    }
}

// Both levels of 8-bit texels, bilinear; shares as levelsOf tells for each pixel.
inline void sampleByteLevels(const TextureView& t, const Levels& levels, const float* lod,
                             Run& run) {
    sampleBytes(t, levels.first, run);
    if (levels.first == levels.second) return;
    Run second = run;
    sampleBytes(t, levels.second, second);
    for (uint32_t i = 0; i < runLength; ++i) {
        const float share = lod[i] - float(levels.first);
        run.r[i] = mix(run.r[i], second.r[i], share), run.g[i] = mix(run.g[i], second.g[i], share);
        run.b[i] = mix(run.b[i], second.b[i], share), run.a[i] = mix(run.a[i], second.a[i], share);
    }
}

// The texels of a run at its u and v into its colour. The level of detail is computed at the ends
// of the run and is nearly linear between them.
inline void textureRun(Run& run, const RasterTriangle& t, const RasterDraw& draw) {
    const TextureView& texture = draw.texture;
    alignas(64) float lod[runLength] = {};
    const bool detailed = texture.levelCount > 1 || texture.magNearest != texture.minNearest;
    float begin = 0, end = 0;
    if (detailed) {
        const auto detailAt = [&](uint32_t i) {
            const float w = t.parallel ? 1.0f : run.w[i];
            return std::max(levelOfDetail(t, texture, run.u[i], run.v[i], w), -1.0f);
        };
        const uint32_t last = run.count - 1;
        begin = end = detailAt(0);
        if (!t.parallel && last > 0) end = detailAt(last);
        const float step = last > 0 ? (end - begin) / float(last) : 0.0f;
        for (uint32_t i = 0; i < runLength; ++i) lod[i] = begin + step * float(i);
    }
    const Levels first = levelsOf(texture, begin), second = levelsOf(texture, end);
    const bool magnified = !(begin > 0.0f), sameSide = magnified == !(end > 0.0f);
    const bool nearest = magnified ? texture.magNearest : texture.minNearest;
    if (sameSide && first.first == second.first && first.second == second.second && !nearest &&
        !texture.minNearest && !texture.isFloat)
        sampleByteLevels(texture, first, lod, run);
    else
        for (uint32_t i = 0; i < run.count; ++i)
            putTexel(run, i, sampleLevels(texture, levelsOf(texture, lod[i]), !(lod[i] > 0.0f),
                                          vec2(run.u[i], run.v[i])));
    if (draw.encodeTexels) encodeRun(run);
}
