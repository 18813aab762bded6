// Reading textures on the CPU: part of the hot code, compiled for each instruction set.
// Included inside an unnamed namespace by isa/kernels.h and isa/raster.inc only.

// 8-bit sRGB to linear, and 8-bit to 0..1, as tables: decoding by formula costs more than the
// texture.
struct DecodeTables {
    float srgb[256];
    float linear[256];
    DecodeTables() {
        for (int i = 0; i < 256; ++i) {
            linear[i] = float(i) / 255.0f;
            srgb[i] = shading::srgb_decode(glm::vec3(linear[i])).x;
        }
    }
};
const DecodeTables decodeTables;

inline int wrapTexel(int i, int n, uint8_t wrap) {
    return unsigned(i) < unsigned(n) ? i : wrapped_texel(i, n, wrap);
}

inline glm::vec4 readTexel(const TextureView& t, const uint8_t* level, int width, int x, int y) {
    const size_t i = size_t(y) * size_t(width) + size_t(x);
    if (t.isFloat) {
        const float* p = reinterpret_cast<const float*>(level) + 4 * i;
        return {p[0], p[1], p[2], p[3]};
    }
    const uint8_t* p = level + 4 * i;
    const float* rgb = t.isSrgb ? decodeTables.srgb : decodeTables.linear;
    return {rgb[p[0]], rgb[p[1]], rgb[p[2]], decodeTables.linear[p[3]]};
}

inline int floorToInt(float x) {
    const int i = int(x);
    return float(i) > x ? i - 1 : i;
}

// A point of one level; `uv` repeats as the texture says.
inline glm::vec4 sampleLevel(const TextureView& t, int level, bool nearest, glm::vec2 uv) {
    const int w = std::max(1, int(t.width >> level)), h = std::max(1, int(t.height >> level));
    const uint8_t* pixels = t.levels[level];
    // Far outside, float coordinates lose the texel; whole repeats change nothing.
    if (t.wrapU != 1) uv.x -= 2.0f * std::floor(0.5f * uv.x);
    if (t.wrapV != 1) uv.y -= 2.0f * std::floor(0.5f * uv.y);
    uv = glm::clamp(uv, glm::vec2(-1), glm::vec2(2));  // NaN becomes a number too
    if (nearest) {
        const int x = wrapTexel(floorToInt(uv.x * float(w)), w, t.wrapU);
        const int y = wrapTexel(floorToInt(uv.y * float(h)), h, t.wrapV);
        return readTexel(t, pixels, w, x, y);
    }
    const float fx = uv.x * float(w) - 0.5f, fy = uv.y * float(h) - 0.5f;
    const int ix = floorToInt(fx), iy = floorToInt(fy);
    const float ax = fx - float(ix), ay = fy - float(iy);
    const int x0 = wrapTexel(ix, w, t.wrapU), x1 = wrapTexel(ix + 1, w, t.wrapU);
    const int y0 = wrapTexel(iy, h, t.wrapV), y1 = wrapTexel(iy + 1, h, t.wrapV);
    const glm::vec4 top =
        glm::mix(readTexel(t, pixels, w, x0, y0), readTexel(t, pixels, w, x1, y0), ax);
    const glm::vec4 low =
        glm::mix(readTexel(t, pixels, w, x0, y1), readTexel(t, pixels, w, x1, y1), ax);
    return glm::mix(top, low, ay);
}

// lod: log2 of the footprint before the texture's own size is added; u_lod in [0, 1) chooses
// between the two nearest levels.
inline glm::vec4 sampleTexture(const TextureView& t, glm::vec2 uv, float lod, float uLod) {
    const float exact = lod + t.halfLog2Texels + (t.minNearest ? 0.5f : uLod);
    const int level = exact > 0 ? std::min(int(exact), int(t.levelCount) - 1) : 0;
    return sampleLevel(t, level, level == 0 ? t.magNearest : t.minNearest, uv);
}

// Three mantissas of 9 bits, an exponent of 5. [EXT_texture_shared_exponent, section 3.8.1]
inline glm::vec3 unpackRadiance(uint32_t v) {
    const float scale = std::bit_cast<float>(((v >> 27) + (127 - 15 - 9)) << 23);
    return scale *
           glm::vec3(float(int(v & 511)), float(int((v >> 9) & 511)), float(int((v >> 18) & 511)));
}
