#include "shading/shading.h"

#include "api/pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/file.h"
#include "io/image_file.h"

namespace gp::api {

namespace {

uint8_t byteFrom(float v) { return uint8_t(std::lround(v * 255)); }
float clip(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }  // NaN becomes 0

// PNG and JPEG by their first bytes, as io decides it: names may lie.
bool startsLikePngOrJpeg(const std::vector<std::byte>& bytes) {
    const auto is = [&](size_t i, int value) {
        return bytes.size() > i && bytes[i] == std::byte(value);
    };
    return (is(0, 0x89) && is(1, 'P') && is(2, 'N') && is(3, 'G')) || (is(0, 0xff) && is(1, 0xd8));
}

}  // namespace

ImageFile readImageFile(const std::string& path) {
    const std::vector<std::byte> bytes = io::readFile(path);
    ImageFile file;
    file.image = io::decodeImage(bytes, path);
    file.displayReferred = startsLikePngOrJpeg(bytes);
    return file;
}

std::vector<float> linearPixels(const ImageFile& file) {
    const Image& image = file.image;
    std::vector<float> linear(size_t(image.width) * image.height * 4);
    const bool bytes = image.format == PixelFormat::rgba8;
    std::array<float, 256> decoded{};
    for (size_t i = 0; i < decoded.size(); ++i) decoded[i] = shading::srgb_decode_1(float(i) / 255);
    for (size_t i = 0; i < linear.size(); ++i) {
        const bool alpha = i % 4 == 3;
        if (bytes)
            linear[i] = alpha ? float(image.bytes()[i]) / 255 : decoded[image.bytes()[i]];
        else if (file.displayReferred && !alpha)
            linear[i] = shading::srgb_decode_1(image.floats()[i]);
        else
            linear[i] = image.floats()[i];
    }
    return linear;
}

std::vector<uint8_t> displayPixels(const float* rgba, size_t pixelCount) {
    std::vector<uint8_t> bytes(pixelCount * 4);
    for (size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = byteFrom(i % 4 == 3 ? clip(rgba[i]) : shading::srgb_encode_1(clip(rgba[i])));
    return bytes;
}

}  // namespace gp::api
