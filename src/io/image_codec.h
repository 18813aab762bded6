// The readers and writers of each image format, and what they share. Inside of io/ only;
// everyone else uses image_file.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/file_error.h"
#include "scene/image.h"

namespace gp::io {

// One image file in memory, and how much it may ask for.
struct ImageSource {
    std::span<const std::byte> bytes;
    const std::string& label;
    uint64_t maxPixels;

    const uint8_t* data() const { return reinterpret_cast<const uint8_t*>(bytes.data()); }
    [[noreturn]] void fail(const std::string& what) const {
        throw FileError(FileError::Kind::invalid, label, what);
    }
    [[noreturn]] void unsupported(const std::string& what) const {
        throw FileError(FileError::Kind::unsupported, label, what);
    }
};

// Called with the size in the header before anything is allocated for it. `pixelsPerByte` is the
// most that the format's compression can make of one byte: a header that claims more lies.
void checkImageSize(const ImageSource& source, uint64_t width, uint64_t height,
                    uint64_t pixelsPerByte);
// An image with its pixels allocated, all zero.
Image allocateImage(uint32_t width, uint32_t height, PixelFormat format);

bool isPng(std::span<const std::byte> bytes);
bool isJpeg(std::span<const std::byte> bytes);
bool isHdr(std::span<const std::byte> bytes);
bool isExr(std::span<const std::byte> bytes);

Image decodePng(const ImageSource& source);
Image decodeJpeg(const ImageSource& source);
Image decodeHdr(const ImageSource& source);
Image decodeExr(const ImageSource& source);

// OpenEXR believes the sizes in a file's header and allocates for them; this walks the header
// first and throws FileError where a size cannot be true.
void checkExrHeader(const ImageSource& source);

}  // namespace gp::io
