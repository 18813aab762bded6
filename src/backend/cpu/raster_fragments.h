// What happens to the pixels of a run: part of the hot code, included inside an unnamed namespace
// by isa/raster.inc only. Every step is a loop of fixed length without branches between pixels, so
// that the compiler makes vectors of it; lanes past `count` hold anything.

constexpr uint32_t runLength = 16;

struct Run {
    uint32_t count;
    alignas(64) float w[runLength];  // the homogeneous coordinate
    alignas(64) float u[runLength], v[runLength];
    alignas(64) float depth[runLength];
    alignas(64) float r[runLength], g[runLength], b[runLength], a[runLength];
    alignas(64) uint32_t pass[runLength];
};

// The start of each run is computed in double, so that errors do not add up along a row.
inline void interpolateLinear(float* out, const RasterPlane& p, double x, double y) {
    const float at = float(p.at + p.dx * x + p.dy * y), step = float(p.dx);
    for (uint32_t i = 0; i < runLength; ++i) out[i] = at + step * float(i);
}

// [OpenGL 2.1 specification, section 3.5.1]: attributes over w, times w.
inline void interpolate(float* out, const RasterPlane& p, const RasterTriangle& t, const Run& run,
                        double x, double y) {
    interpolateLinear(out, p, x, y);
    if (t.parallel) return;
    for (uint32_t i = 0; i < runLength; ++i) out[i] *= run.w[i];
}

inline void interpolateW(Run& run, const RasterTriangle& t, double x, double y) {
    interpolateLinear(run.w, t.inverseW, x, y);
    for (uint32_t i = 0; i < runLength; ++i) run.w[i] = 1.0f / run.w[i];
}

// Depth into run.depth, and whether it passes into run.pass; true if some pixel does.
inline bool testDepth(Run& run, const RasterTriangle& t, const RasterDraw& draw, const float* held,
                      double x, double y) {
    interpolate(run.depth, t.depth, t, run, x, y);
    alignas(64) float there[runLength];
    std::memcpy(there, held, run.count * sizeof(float));
    uint32_t any = 0;
    for (uint32_t i = 0; i < run.count; ++i) {
        run.pass[i] = depth_test_passes(draw.depthTest, run.depth[i], there[i]) ? 1u : 0u;
        any |= run.pass[i];
    }
    return any != 0;
}

// Interpolated colour, which rounding may have put outside of what vertices have, times the texels
// that are in the run, if there are any.
inline void colorRun(Run& run, const RasterTriangle& t, const RasterDraw& draw, bool texels,
                     double x, double y) {
    float* channels[4] = {run.r, run.g, run.b, run.a};
    for (int c = 0; c < 4; ++c) {
        float* out = channels[c];
        if (t.oneColor) {
            const float one = float(t.color[c].at) * draw.color[c];
            for (uint32_t i = 0; i < runLength; ++i) out[i] = texels ? out[i] * one : one;
            continue;
        }
        alignas(64) float vertex[runLength];
        interpolate(vertex, t.color[c], t, run, x, y);
        const float most = c == 3 ? 1.0f : FLOAT_MAX;
        for (uint32_t i = 0; i < runLength; ++i)
            vertex[i] = blend_limited(vertex[i], most) * draw.color[c];
        if (texels)
            for (uint32_t i = 0; i < runLength; ++i) out[i] *= vertex[i];
        else
            std::copy_n(vertex, runLength, out);
    }
}

inline bool testAlpha(Run& run, float threshold) {
    uint32_t any = 0;
    for (uint32_t i = 0; i < run.count; ++i) {
        run.pass[i] &= run.a[i] >= threshold ? 1u : 0u;
        any |= run.pass[i];
    }
    return any != 0;
}

// The two kinds of image.
struct RadianceImage {
    using Pixel = vec4;
    static constexpr float most = BLEND_RADIANCE_MAX;
    static vec4 load(const Pixel& p) { return p; }
    static Pixel store(const vec4& c) { return c; }
};
struct DisplayImage {
    using Pixel = uint32_t;  // a u8vec4, red lowest
    static constexpr float most = 1.0f;
    static vec4 load(const Pixel& p) {
        return vec4(float(int(p & 255u)), float(int((p >> 8) & 255u)),
                    float(int((p >> 16) & 255u)), float(int(p >> 24))) * (1.0f / 255.0f);
    }
    static Pixel store(const vec4& c) {
        const vec4 s = c * 255.0f + 0.5f;
        return uint32_t(int(s.x)) | (uint32_t(int(s.y)) << 8) | (uint32_t(int(s.z)) << 16) |
               (uint32_t(int(s.w)) << 24);
    }
};

// Blend states that are worth code of their own, and any other.
template <uint32_t source, uint32_t destination, uint32_t sourceAlpha, uint32_t destinationAlpha>
struct FixedBlend {
    BlendState state() const {
        return {source, destination, sourceAlpha, destinationAlpha};
    }
    static bool is(const RasterDraw& d) {
        return d.blendSource == source && d.blendDestination == destination &&
               d.blendSourceAlpha == sourceAlpha && d.blendDestinationAlpha == destinationAlpha;
    }
};
using BlendReplace = FixedBlend<BLEND_ONE, BLEND_ZERO, BLEND_ONE, BLEND_ZERO>;
using BlendOver = FixedBlend<BLEND_SRC_ALPHA, BLEND_ONE_MINUS_SRC_ALPHA, BLEND_ONE,
                             BLEND_ONE_MINUS_SRC_ALPHA>;
using BlendAdd = FixedBlend<BLEND_SRC_ALPHA, BLEND_ONE, BLEND_ONE, BLEND_ONE>;
struct AnyBlend {
    BlendState s;
    BlendState state() const { return s; }
};

// Most runs are whole: a copy of known size is a few instructions.
template <class T>
inline void copyPixels(T* to, const T* from, uint32_t count) {
    if (count == runLength)
        std::memcpy(to, from, runLength * sizeof(T));
    else
        std::memcpy(to, from, count * sizeof(T));
}

template <class Image, class Blend>
inline void blendRun(const Blend& blend, const Run& run, typename Image::Pixel* pixels) {
    alignas(64) typename Image::Pixel held[runLength];
    copyPixels(held, pixels, run.count);
    const BlendState state = blend.state();
    for (uint32_t i = 0; i < runLength; ++i) {
        const vec4 there = Image::load(held[i]);
        const vec4 c = blend_pixel(state, vec4(run.r[i], run.g[i], run.b[i], run.a[i]), there,
                                   Image::most);
        const auto stored = Image::store(c);
        held[i] = run.pass[i] != 0 ? stored : held[i];
    }
    copyPixels(pixels, held, run.count);
}

template <class Image>
inline void mergeRun(const RasterDraw& d, const Run& run, typename Image::Pixel* pixels) {
    if (!d.blend) return blendRun<Image>(BlendReplace{}, run, pixels);
    if (BlendOver::is(d)) return blendRun<Image>(BlendOver{}, run, pixels);
    if (BlendAdd::is(d)) return blendRun<Image>(BlendAdd{}, run, pixels);
    const BlendState state = {d.blendSource, d.blendDestination, d.blendSourceAlpha,
                              d.blendDestinationAlpha};
    blendRun<Image>(AnyBlend{state}, run, pixels);
}
