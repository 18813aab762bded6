#include "scene/mipmap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace gp {

namespace {

// Below this many texels a task costs more than it saves.
constexpr size_t texelsPerTask = 1 << 15;

// Bytes to 16-bit light and back. 16 bits are enough: the darkest sRGB step is 20 of 65,535.
struct Tables {
    std::array<uint16_t, 256> light[2];     // [linear, sRGB]
    std::array<uint8_t, 65536> byte[2];
    Tables() {
        for (size_t i = 0; i < 256; ++i) {
            const float v = float(i) / 255.0f;
            light[0][i] = static_cast<uint16_t>(i * 257);
            light[1][i] = static_cast<uint16_t>(std::lround(linearFromSrgb(v) * 65535.0f));
        }
        for (size_t i = 0; i < 65536; ++i) {
            const float v = float(i) / 65535.0f;
            byte[0][i] = static_cast<uint8_t>((i + 128) / 257);
            byte[1][i] = static_cast<uint8_t>(std::lround(srgbFromLinear(v) * 255.0f));
        }
    }
};
const Tables& tables() {
    static const Tables instance;
    return instance;
}

struct Step {
    const std::byte* from;
    std::byte* to;
    MipLevel source, target;
    uint32_t begin, end;  // columns of the target
};

// The texels of `to` along one axis that those of `from` in [begin, begin + count) go into: of an
// odd size a texel goes into the one before its half, too.
void halve(uint32_t& begin, uint32_t& count, uint32_t from, uint32_t to) {
    const uint32_t end = begin + count;
    const uint32_t first = from % 2 == 0 ? begin / 2 : (std::max(begin, 1u) - 1) / 2;
    begin = std::min(first, to - 1);
    count = std::min((end + 1) / 2, to) - begin;
}

// Both sizes even, bytes: the common case, in integers.
void halveRow8(const Step& s, uint32_t y, bool srgb) {
    const Tables& t = tables();
    const uint8_t* a =
        reinterpret_cast<const uint8_t*>(s.from) + (size_t(y) * s.source.width + s.begin) * 8;
    const uint8_t* b = a + size_t(s.source.width) * 4;
    uint8_t* out = reinterpret_cast<uint8_t*>(s.to) + (size_t(y) * s.target.width + s.begin) * 4;
    const auto& light = t.light[srgb];
    const auto& byte = t.byte[srgb];
    for (uint32_t x = s.begin; x < s.end; ++x, a += 8, b += 8, out += 4) {
        for (int c = 0; c < 3; ++c) {
            const unsigned sum = unsigned(light[a[c]]) + light[a[c + 4]] + light[b[c]] +
                                 light[b[c + 4]];
            out[c] = byte[(sum + 2) >> 2];
        }
        out[3] = static_cast<uint8_t>((unsigned(a[3]) + a[7] + b[3] + b[7] + 2) >> 2);
    }
}

glm::vec4 fetch8(const uint8_t* p, bool srgb) {
    const auto& light = tables().light[srgb];
    return {light[p[0]], light[p[1]], light[p[2]], p[3]};
}

void store8(uint8_t* p, glm::vec4 v, bool srgb) {
    const auto& byte = tables().byte[srgb];
    for (int c = 0; c < 3; ++c) p[c] = byte[static_cast<uint16_t>(v[c] + 0.5f)];
    p[3] = static_cast<uint8_t>(v.w + 0.5f);
}

// Any sizes, any format.
void filterRow(const Step& s, uint32_t y, PixelFormat format, bool srgb) {
    const BoxTaps ty = boxTaps(y, s.source.height, s.target.height);
    const size_t texel = bytesPerPixel(format);
    for (uint32_t x = s.begin; x < s.end; ++x) {
        const BoxTaps tx = boxTaps(x, s.source.width, s.target.width);
        glm::vec4 sum(0);
        for (uint32_t j = 0; j < ty.count; ++j)
            for (uint32_t i = 0; i < tx.count; ++i) {
                const std::byte* p =
                    s.from + (size_t(ty.first + j) * s.source.width + tx.first + i) * texel;
                const glm::vec4 v = format == PixelFormat::rgba8
                                        ? fetch8(reinterpret_cast<const uint8_t*>(p), srgb)
                                        : *reinterpret_cast<const glm::vec4*>(p);
                sum += v * (ty.weight[j] * tx.weight[i]);
            }
        std::byte* out = s.to + (size_t(y) * s.target.width + x) * texel;
        if (format == PixelFormat::rgba8) store8(reinterpret_cast<uint8_t*>(out), sum, srgb);
        else *reinterpret_cast<glm::vec4*>(out) = sum;
    }
}

}  // namespace

// [IEC 61966-2-1:1999, 5.2]
float linearFromSrgb(float v) {
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

// [IEC 61966-2-1:1999, 5.2]
float srgbFromLinear(float v) {
    return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}

BoxTaps boxTaps(uint32_t i, uint32_t from, uint32_t to) {
    BoxTaps t;
    if (from == 1) return t;
    t.first = i * 2;
    if (from % 2 == 0) {
        t.count = 2;
        t.weight[0] = t.weight[1] = 0.5f;
        return t;
    }
    // [Guthe, Heckbert 2005, "Non-Power-of-Two Mipmapping", polyphase box filter]
    t.count = 3;
    const float unit = 1.0f / float(from);
    t.weight[0] = float(to - i) * unit;
    t.weight[1] = float(to) * unit;
    t.weight[2] = float(i + 1) * unit;
    return t;
}

std::vector<MipLevel> mipLayout(uint32_t width, uint32_t height, PixelFormat format,
                                bool mipmapped, size_t& totalBytes) {
    std::vector<MipLevel> levels;
    totalBytes = 0;
    for (;;) {
        levels.push_back({width, height, totalBytes});
        totalBytes += size_t(width) * height * bytesPerPixel(format);
        if (!mipmapped || (width == 1 && height == 1)) return levels;
        width = std::max(width / 2, 1u);
        height = std::max(height / 2, 1u);
    }
}

void fillMipLevels(Texture& texture, TexelRect changed) {
    // 32-bit float images hold linear light already.
    const bool bytes = texture.format == PixelFormat::rgba8;
    const bool srgb = bytes && texture.colorSpace == ColorSpace::srgb;
    for (size_t level = 1; level < texture.levels.size(); ++level) {
        const MipLevel& source = texture.levels[level - 1];
        const MipLevel& target = texture.levels[level];
        halve(changed.x, changed.width, source.width, target.width);
        halve(changed.y, changed.height, source.height, target.height);
        const Step step{texture.pixels.data() + source.offset,
                        texture.pixels.data() + target.offset, source, target, changed.x,
                        changed.x + changed.width};
        const bool fast = bytes && source.width % 2 == 0 && source.height % 2 == 0;
        const size_t grain = std::max<size_t>(1, texelsPerTask / changed.width);
        const uint32_t lastRow = changed.y + changed.height;
        tbb::parallel_for(tbb::blocked_range<uint32_t>(changed.y, lastRow, grain),
                          [&](const tbb::blocked_range<uint32_t>& rows) {
                              for (uint32_t y = rows.begin(); y != rows.end(); ++y) {
                                  if (fast) halveRow8(step, y, srgb);
                                  else filterRow(step, y, texture.format, srgb);
                              }
                          });
    }
}

}  // namespace gp
