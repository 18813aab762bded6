// load_name, load_previous_name and store_name of every image of shared/realtime_images.def: part
// of the hot code, compiled for each instruction set. Included inside an unnamed namespace.

// Halves by F16C where it is there, else by bits, with the same result: rounded to even, what is
// larger than a half can be becomes the largest, NaN becomes 0, so that it never spreads.
inline uint16_t halfFromFloat(float v) {
    const float clamped = v == v ? std::min(std::max(v, -65504.0f), 65504.0f) : 0.0f;
#if defined(__F16C__)
    return uint16_t(_cvtss_sh(clamped, _MM_FROUND_TO_NEAREST_INT));
#else
    const uint32_t bits = std::bit_cast<uint32_t>(clamped);
    const uint32_t sign = bits >> 16 & 0x8000u, magnitude = bits & 0x7FFFFFFFu;
    if (magnitude < 0x38800000u) {  // below the smallest normal half: a multiple of 2^-24
        const float scaled = std::bit_cast<float>(magnitude) * 16777216.0f;
        return uint16_t(sign | uint32_t(std::nearbyint(scaled)));
    }
    const uint32_t odd = magnitude >> 13 & 1u;
    return uint16_t(sign | ((magnitude - 0x38000000u + 0xFFFu + odd) >> 13));
#endif
}

inline float floatFromHalf(uint16_t h) {
#if defined(__F16C__)
    return _cvtsh_ss(h);
#else
    const uint32_t sign = uint32_t(h & 0x8000u) << 16, magnitude = h & 0x7FFFu;
    if (magnitude < 0x400u)
        return std::bit_cast<float>(sign |
                                    std::bit_cast<uint32_t>(float(magnitude) * 5.9604645e-8f));
    return std::bit_cast<float>(sign | ((magnitude << 13) + 0x38000000u));
#endif
}

// One struct for each format of the table: its type in the kernels, and how it lies in memory.
struct FormatFLOAT1 {
    using Value = float;
    static float read(const std::byte* p) { return *reinterpret_cast<const float*>(p); }
    static void write(std::byte* p, float v) { *reinterpret_cast<float*>(p) = v; }
    static constexpr size_t bytes = 4;
};

struct FormatUINT1 {
    using Value = uint;
    static uint read(const std::byte* p) { return *reinterpret_cast<const uint*>(p); }
    static void write(std::byte* p, uint v) { *reinterpret_cast<uint*>(p) = v; }
    static constexpr size_t bytes = 4;
};

struct FormatUINT2 {
    using Value = uvec2;
    static uvec2 read(const std::byte* p) {
        const uint* u = reinterpret_cast<const uint*>(p);
        return uvec2(u[0], u[1]);
    }
    static void write(std::byte* p, uvec2 v) {
        uint* u = reinterpret_cast<uint*>(p);
        u[0] = v.x, u[1] = v.y;
    }
    static constexpr size_t bytes = 8;
};

struct FormatHALF2 {
    using Value = vec2;
    static vec2 read(const std::byte* p) {
        const uint16_t* h = reinterpret_cast<const uint16_t*>(p);
        return vec2(floatFromHalf(h[0]), floatFromHalf(h[1]));
    }
    static void write(std::byte* p, vec2 v) {
        uint16_t* h = reinterpret_cast<uint16_t*>(p);
        h[0] = halfFromFloat(v.x), h[1] = halfFromFloat(v.y);
    }
    static constexpr size_t bytes = 4;
};

struct FormatHALF4 {
    using Value = vec4;
    static vec4 read(const std::byte* p) {
#if defined(__F16C__)
        const __m128 v = _mm_cvtph_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)));
        vec4 r;
        _mm_storeu_ps(&r.x, v);
        return r;
#else
        const uint16_t* h = reinterpret_cast<const uint16_t*>(p);
        return vec4(floatFromHalf(h[0]), floatFromHalf(h[1]), floatFromHalf(h[2]),
                    floatFromHalf(h[3]));
#endif
    }
    static void write(std::byte* p, vec4 v) {
#if defined(__F16C__)
        __m128 x = _mm_loadu_ps(&v.x);
        x = _mm_and_ps(x, _mm_cmpord_ps(x, x));
        x = _mm_min_ps(_mm_max_ps(x, _mm_set1_ps(-65504.0f)), _mm_set1_ps(65504.0f));
        _mm_storel_epi64(reinterpret_cast<__m128i*>(p),
                         _mm_cvtps_ph(x, _MM_FROUND_TO_NEAREST_INT));
#else
        uint16_t* h = reinterpret_cast<uint16_t*>(p);
        for (int i = 0; i < 4; ++i) h[i] = halfFromFloat(v[i]);
#endif
    }
    static constexpr size_t bytes = 8;
};

// Halves without sign and the lowest bits; so cut, they never become more than they were.
struct FormatPOSITIVE3 {
    using Value = vec4;
    // `bits`: an exponent of 5 bits and a mantissa of 18, without sign. By arithmetic of integers
    // and without a branch, which compilers turn into vectors.
    static float number(uint bits) {
        const float normal = std::bit_cast<float>(bits + (112u << 23));
        const float small = float(bits) * 0x1p-37f;  // below the smallest normal half
        return bits >= 1u << 23 ? normal : small;
    }
    static vec4 read(const std::byte* p) {
        const uint u = *reinterpret_cast<const uint*>(p);
        return vec4(number((u & 0x7FFu) << 17), number((u >> 11 & 0x7FFu) << 17),
                    number(u >> 22 << 18), 0.0f);
    }
    static void write(std::byte* p, vec4 v) {
        const uint x = halfFromFloat(std::max(0.0f, v.x)), y = halfFromFloat(std::max(0.0f, v.y)),
                   z = halfFromFloat(std::max(0.0f, v.z));
        *reinterpret_cast<uint*>(p) = x >> 4 | y >> 4 << 11 | z >> 5 << 22;
    }
    static constexpr size_t bytes = 4;
};

struct FormatRGB9E5 {
    using Value = vec3;
    static vec3 read(const std::byte* p) {
        return rgb9e5_decode(*reinterpret_cast<const uint*>(p));
    }
    static void write(std::byte* p, vec3 v) { *reinterpret_cast<uint*>(p) = rgb9e5_encode(v); }
    static constexpr size_t bytes = 4;
};

struct FormatUNORM2 {
    using Value = vec2;
    static vec2 read(const std::byte* p) {
        const uint8_t* u = reinterpret_cast<const uint8_t*>(p);
        return vec2(float(u[0]), float(u[1])) * (1.0f / 255.0f);
    }
    static void write(std::byte* p, vec2 v) {
        uint8_t* u = reinterpret_cast<uint8_t*>(p);
        for (int i = 0; i < 2; ++i)
            u[i] = uint8_t(std::min(std::max(v[i], 0.0f), 1.0f) * 255.0f + 0.5f);
    }
    static constexpr size_t bytes = 2;
};

struct FormatUNORM4 {
    using Value = vec4;
    static vec4 read(const std::byte* p) {
        const uint8_t* u = reinterpret_cast<const uint8_t*>(p);
        return vec4(float(u[0]), float(u[1]), float(u[2]), float(u[3])) * (1.0f / 255.0f);
    }
    static void write(std::byte* p, vec4 v) {
        uint8_t* u = reinterpret_cast<uint8_t*>(p);
        for (int i = 0; i < 4; ++i)
            u[i] = uint8_t(std::min(std::max(v[i], 0.0f), 1.0f) * 255.0f + 0.5f);
    }
    static constexpr size_t bytes = 4;
};

template <class Format, RealtimeSize Size>
inline size_t imageOffset(const RealtimeViews& views, ivec2 p) {
    const size_t width = size_t(views.size[size_t(Size)].x);
    return (size_t(p.y) * width + size_t(p.x)) * Format::bytes;
}

// The functions, as members of whatever struct derives from it. Pixels outside are the kernels'
// fault.
struct ImageAccess {
    const RealtimeViews& images;

    explicit ImageAccess(const RealtimeViews& views) : images(views) {}

#define X(name, format, size, copies, memory, meaning)                                           \
    Format##format::Value load_##name(ivec2 p) const {                                           \
        return Format##format::read(images.current[size_t(RealtimeImage::name)] +                \
                                    imageOffset<Format##format, RealtimeSize::size>(images, p)); \
    }                                                                                            \
    Format##format::Value load_previous_##name(ivec2 p) const {                                  \
        return Format##format::read(images.previous[size_t(RealtimeImage::name)] +               \
                                    imageOffset<Format##format, RealtimeSize::size>(images, p)); \
    }                                                                                            \
    void store_##name(ivec2 p, Format##format::Value v) const {                                  \
        Format##format::write(images.current[size_t(RealtimeImage::name)] +                      \
                                  imageOffset<Format##format, RealtimeSize::size>(images, p),    \
                              v);                                                                \
    }
#include "shared/realtime_images.def"
#undef X
};
