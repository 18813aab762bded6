// Pixels in memory, top row first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gp {

enum class PixelFormat : uint8_t {
    rgba8,    // four unsigned bytes; sRGB or linear is the texture's business
    rgba32f,  // four floats, linear Rec. 709
};

constexpr size_t bytesPerPixel(PixelFormat f) { return f == PixelFormat::rgba8 ? 4 : 16; }

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    PixelFormat format = PixelFormat::rgba8;
    std::vector<std::byte> pixels;  // width * height * bytesPerPixel(format)

    uint8_t* bytes() { return reinterpret_cast<uint8_t*>(pixels.data()); }
    const uint8_t* bytes() const { return reinterpret_cast<const uint8_t*>(pixels.data()); }
    float* floats() { return reinterpret_cast<float*>(pixels.data()); }
    const float* floats() const { return reinterpret_cast<const float*>(pixels.data()); }
};

}  // namespace gp
