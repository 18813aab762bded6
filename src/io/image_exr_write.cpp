// OpenEXR pictures with any number of layers.
#include <algorithm>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include "io/file.h"
#include "io/image_file.h"

namespace gp::io {

namespace {

// Finite values stay finite in a half.
half toHalf(float v) {
    if (v > 65504.0f && v <= 3.4028235e38f) return half(65504.0f);
    if (v < -65504.0f && v >= -3.4028235e38f) return half(-65504.0f);
    return half(v);
}

void writeLayers(const std::string& target, uint32_t width, uint32_t height,
                 std::span<const ImageLayer> layers, ExrPixel pixel) {
    const Imf::PixelType type = pixel == ExrPixel::half ? Imf::HALF : Imf::FLOAT;
    const size_t pixels = size_t(width) * height;
    const Imath::Box2i window({0, 0}, {int(width) - 1, int(height) - 1});
    Imf::Header header(window, window);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    std::vector<std::vector<half>> halves;
    halves.reserve(layers.size());  // slices point into the inner arrays
    for (const ImageLayer& layer : layers) {
        const size_t channels = layer.channels.size();
        const char* base = reinterpret_cast<const char*>(layer.pixels);
        size_t valueBytes = sizeof(float);
        if (pixel == ExrPixel::half) {
            std::vector<half>& copy = halves.emplace_back(pixels * channels);
            std::transform(layer.pixels, layer.pixels + copy.size(), copy.begin(), toHalf);
            base = reinterpret_cast<const char*>(copy.data());
            valueBytes = sizeof(half);
        }
        for (size_t c = 0; c < channels; ++c) {
            const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
            const std::string name = prefix + layer.channels[c];
            header.channels().insert(name, Imf::Channel(type));
            // OpenEXR's slices are not const, though it only reads from them here.
            frame.insert(name, Imf::Slice(type, const_cast<char*>(base) + c * valueBytes,
                                          channels * valueBytes, width * channels * valueBytes));
        }
    }
    Imf::OutputFile file(target.c_str(), header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(int(height));
}

}  // namespace

void saveExr(const std::string& path, uint32_t width, uint32_t height,
             std::span<const ImageLayer> layers, ExrPixel pixel) {
    AtomicFile file(path);
    try {
        writeLayers(file.temporaryPath(), width, height, layers, pixel);
    } catch (const std::exception& e) {
        throw FileError(FileError::Kind::writeFailed, path,
                        std::string("cannot be written: ") + e.what());
    }
    file.commit();
}

}  // namespace gp::io
