// PNG, JPEG, Radiance HDR and OpenEXR, in and out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/file_error.h"
#include "scene/image.h"

namespace gp::io {

// The most pixels that a file may ask for, checked in its header before anything is allocated.
constexpr uint64_t defaultMaxPixels = uint64_t(1) << 28;

// By content, not by name. 8-bit files give rgba8 as stored; 16-bit PNG, HDR and EXR give rgba32f
// (16-bit PNG scaled to 0..1, still in the file's encoding). Throws FileError.
Image loadImage(const std::string& path, uint64_t maxPixels = defaultMaxPixels);
// The same from memory; `label` stands for the path in messages.
Image decodeImage(std::span<const std::byte> file, const std::string& label,
                  uint64_t maxPixels = defaultMaxPixels);

// One layer of an image file: `channels` floats a pixel, top row first.
struct ImageLayer {
    std::string name;      // EXR: prefix of the channel names ("" for the main picture: R G B A)
    std::string channels;  // their letters, in order: "RGBA", "RGB", "XYZ", "Z"
    const float* pixels = nullptr;
};

enum class ExrPixel : uint8_t { half, float32 };

// Written to a temporary name beside `path`, then renamed. Throws FileError.
void saveExr(const std::string& path, uint32_t width, uint32_t height,
             std::span<const ImageLayer> layers, ExrPixel pixel);
void saveHdr(const std::string& path, uint32_t width, uint32_t height, const float* rgba);
// Four bytes a pixel are given in any case; straight colours where alpha is kept.
enum class PngPixel : uint8_t { rgb, rgba };
void savePng(const std::string& path, uint32_t width, uint32_t height, const uint8_t* rgba,
             PngPixel pixel);

}  // namespace gp::io
