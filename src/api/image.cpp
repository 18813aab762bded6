// Image files by themselves: what tools and tests need.
#include <cstdlib>

#include "api/check.h"
#include "api/endings.h"
#include "api/pixels.h"
#include "io/image_file.h"

namespace gp::api {

namespace {

constexpr uint32_t sideLimit = 32768;
constexpr uint64_t pixelLimit = uint64_t(1) << 28;

GpImage loadImage(const char* path) {
    const ImageFile file = readImageFile(path);
    const std::vector<float> linear = linearPixels(file);
    GpImage image{};
    image.width = file.image.width;
    image.height = file.image.height;
    image.displayReferred = file.displayReferred ? 1 : 0;
    // malloc, because gpFreeImage is called without a device and may be called from C at any time.
    image.pixels = static_cast<float*>(std::malloc(linear.size() * sizeof(float)));
    if (!image.pixels) throw std::bad_alloc();
    std::memcpy(image.pixels, linear.data(), linear.size() * sizeof(float));
    return image;
}

bool isOpaque(const std::vector<uint8_t>& rgba) {
    for (size_t i = 3; i < rgba.size(); i += 4)
        if (rgba[i] != 255) return false;
    return true;
}

void saveImage(const char* path, const GpImage& image) {
    const FileEnding ending = endingOf(path);
    checkImageSize(image.width, image.height, sideLimit, pixelLimit);
    checkPointer(image.pixels, "image.pixels");
    const size_t count = size_t(image.width) * image.height;
    if (ending == FileEnding::hdr)
        return io::saveHdr(path, image.width, image.height, image.pixels);
    if (ending == FileEnding::png) {
        const std::vector<uint8_t> bytes = displayPixels(image.pixels, count);
        return io::savePng(path, image.width, image.height, bytes.data(),
                           isOpaque(bytes) ? io::PngPixel::rgb : io::PngPixel::rgba);
    }
    const io::ImageLayer layer{"", "RGBA", image.pixels};
    io::saveExr(path, image.width, image.height, {&layer, 1}, io::ExrPixel::half);
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpLoadImage(GpDevice device, const char* path, GpImage* image) {
    return enter("gpLoadImage", "device", device, [&](DeviceObject&) {
        checkPath(path);
        checkPointer(image, "image");
        *image = loadImage(path);
    });
}

GpError gpSaveImage(GpDevice device, const char* path, const GpImage* image) {
    return enter("gpSaveImage", "device", device, [&](DeviceObject&) {
        checkPath(path);
        checkPointer(image, "image");
        saveImage(path, *image);
    });
}

void gpFreeImage(GpImage* image) {
    if (!image) return;
    std::free(image->pixels);
    *image = GpImage{};
}

}  // extern "C"
