// gpSaveFrame: the images of a frame into a file.
#include <algorithm>
#include <deque>
#include <string_view>

#include "api/check.h"
#include "api/endings.h"
#include "api/frames.h"
#include "frame/straight_picture.h"
#include "io/image_file.h"

namespace gp::api {

FileEnding endingOf(const char* path) {
    const std::string_view whole = path;
    const size_t dot = whole.rfind('.');
    std::string ending(dot == std::string_view::npos ? std::string_view{} : whole.substr(dot));
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    if (ending == ".png") return FileEnding::png;
    if (ending == ".exr") return FileEnding::exr;
    if (ending == ".hdr") return FileEnding::hdr;
    fail(GP_ERROR_INVALID_ARGUMENT, "path \"{}\" ends in none of .png, .exr, .hdr", path);
}

namespace {

// The whole of an image as floats, without the channels that its layer does not name.
std::vector<float> layerPixels(const FrameObject& frame, FrameImage which, size_t channels) {
    const FrameImageInfo& info = frameImageInfo(which);
    const size_t count = frame.images.pixelCount();
    std::vector<std::byte> raw(count * info.bytesPerPixel);
    readImage(frame, which, raw.data());
    const size_t stride = info.format == FrameImageFormat::rgba32f ||
                          info.format == FrameImageFormat::rgba8 ? 4 : 1;
    std::vector<float> pixels(count * channels);
    for (size_t i = 0; i < count; ++i)
        for (size_t c = 0; c < channels; ++c) {
            const size_t from = i * stride + c;
            float& to = pixels[i * channels + c];
            if (info.format == FrameImageFormat::rgba8)
                to = float(std::to_integer<uint8_t>(raw[from])) / 255;
            else if (info.format == FrameImageFormat::r32ui) {
                uint32_t id;
                std::memcpy(&id, raw.data() + from * sizeof id, sizeof id);
                to = float(id);
            } else
                std::memcpy(&to, raw.data() + from * sizeof to, sizeof to);
        }
    return pixels;
}

std::string channelsOf(FrameImage which) {
    const FrameImageInfo& info = frameImageInfo(which);
    const bool single =
        info.format == FrameImageFormat::r32f || info.format == FrameImageFormat::r32ui;
    return std::string(info.channels).substr(0, single ? 1 : 4);
}

// Half floats end at 65,504 and count exactly only to 2,048: too few for distances and numbers.
bool needsFullFloat(uint32_t layers) {
    return (layers & ((1u << GP_IMAGE_DEPTH) | (1u << GP_IMAGE_INSTANCE))) != 0;
}

void saveLayers(const FrameObject& frame, const char* path, const GpSaveOptions& options) {
    std::deque<std::vector<float>> pixels;  // stays where it is while layers point into it
    std::vector<io::ImageLayer> layers;
    const auto add = [&](FrameImage which, const char* name) {
        const std::string channels = channelsOf(which);
        pixels.push_back(layerPixels(frame, which, channels.size()));
        layers.push_back({name, channels, pixels.back().data()});
    };
    add(FrameImage::color, "");
    for (uint32_t i = 1; i < GP_IMAGE_COUNT; ++i)
        if (options.layers & (1u << i)) add(FrameImage(i), frameImageInfo(FrameImage(i)).name);
    const bool full = options.fullFloat || needsFullFloat(options.layers);
    io::saveExr(path, frame.images.width, frame.images.height, layers,
                full ? io::ExrPixel::float32 : io::ExrPixel::half);
}

// What is shown, over nothing: as PNG wants it.
void savePngWithAlpha(const FrameObject& frame, const char* path) {
    std::vector<glm::vec4> color(frame.images.pixelCount());
    readImage(frame, FrameImage::color, color.data());
    const ShownPicture shown = {frame.shownEv, frame.shownTonemap, &frame.overlay, &frame.camera};
    const std::vector<glm::u8vec4> straight =
        straightPicture(*frame.device->backend, std::move(color), frame.images.width,
                        frame.images.height, shown);
    io::savePng(path, frame.images.width, frame.images.height, &straight[0].x,
                io::PngPixel::rgba);
}

void save(const FrameObject& frame, const char* path, const GpSaveOptions& options) {
    checkPath(path);
    const FileEnding ending = endingOf(path);
    if (options.layers >> GP_IMAGE_COUNT)
        fail(GP_ERROR_INVALID_ARGUMENT, "options.layers has unknown bits: {:#x}", options.layers);
    if (options.layers != 0 && ending != FileEnding::exr)
        fail(GP_ERROR_INVALID_ARGUMENT, "options.layers: only .exr files have layers");
    if (options.alpha != 0 && ending == FileEnding::hdr)
        fail(GP_ERROR_INVALID_ARGUMENT, "options.alpha: .hdr files have none");
    checkRendered(frame);
    const FrameImages& images = frame.images;
    if (ending == FileEnding::exr) return saveLayers(frame, path, options);
    if (ending == FileEnding::png && options.alpha != 0) return savePngWithAlpha(frame, path);
    if (ending == FileEnding::png)
        return io::savePng(path, images.width, images.height, &images.display[0].x,
                           io::PngPixel::rgb);
    const std::vector<float> color = layerPixels(frame, FrameImage::color, 4);
    io::saveHdr(path, images.width, images.height, color.data());
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" GpError gpSaveFrame(GpFrame frame, const char* path, const GpSaveOptions* options) {
    return enter("gpSaveFrame", "frame", frame, [&](FrameObject& f) {
        save(f, path, options ? *options : GpSaveOptions{});
    });
}
