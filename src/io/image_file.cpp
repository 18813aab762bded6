#include "io/image_file.h"

#include "io/file.h"
#include "io/image_codec.h"

namespace gp::io {

void checkImageSize(const ImageSource& source, uint64_t width, uint64_t height,
                    uint64_t pixelsPerByte) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width == 0 || height == 0) source.fail("the image is empty (" + size + ")");
    if (width > source.maxPixels || height > source.maxPixels / width)
        source.fail("the image is too large (" + size + "; the limit is " +
                    std::to_string(source.maxPixels) + " pixels)");
    // Small images are free to be compressed as well as they like.
    constexpr uint64_t harmless = uint64_t(1) << 20;
    if (width * height > harmless && width * height / pixelsPerByte > source.bytes.size())
        source.fail("the header claims " + size + ", but the file has only " +
                    std::to_string(source.bytes.size()) + " bytes (truncated?)");
}

Image allocateImage(uint32_t width, uint32_t height, PixelFormat format) {
    Image image;
    image.width = width;
    image.height = height;
    image.format = format;
    // Room for the smaller levels, so that makeTexture need not move the pixels.
    if (format == PixelFormat::rgba8) image.pixels.reserve(size_t(width) * height * 16 / 3 + 64);
    image.pixels.resize(size_t(width) * height * bytesPerPixel(format));
    return image;
}

Image decodeImage(std::span<const std::byte> file, const std::string& label, uint64_t maxPixels) {
    const ImageSource source{file, label, maxPixels};
    if (file.empty()) source.fail("the image file is empty");
    if (isPng(file)) return decodePng(source);
    if (isJpeg(file)) return decodeJpeg(source);
    if (isHdr(file)) return decodeHdr(source);
    if (isExr(file)) return decodeExr(source);
    source.unsupported("not an image that can be read (PNG, JPEG, Radiance HDR or OpenEXR)");
}

Image loadImage(const std::string& path, uint64_t maxPixels) {
    return decodeImage(readFile(path), path, maxPixels);
}

}  // namespace gp::io
