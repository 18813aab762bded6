// Frames: making them, and reading what they hold. Rendering is in render.cpp.
#include <unistd.h>

#include "api/check.h"
#include "api/frames.h"
#include "frame/compose.h"

namespace gp::api {

namespace {

constexpr uint32_t sideLimit = 16384;

static_assert(GP_MODE_REALTIME == int(FrameMode::realtime) &&
              GP_MODE_LOCAL == int(FrameMode::local));
static_assert(GP_IMAGE_COUNT == int(FrameImage::count));
#define X(id, NAME, format, channels, meaning) \
    static_assert(GP_IMAGE_##NAME == int(FrameImage::id));
#include "shared/frame_images.def"
#undef X
static_assert(GP_IMAGE_RGBA8 == int(FrameImageFormat::rgba8) &&
              GP_IMAGE_R32F == int(FrameImageFormat::r32f) &&
              GP_IMAGE_R32UI == int(FrameImageFormat::r32ui));

// Linux promises more memory than there is and ends the process when it is used. A frame that
// cannot fit into the machine's memory is refused while it is still only a number.
void checkFits(uint64_t bytes) {
    const long pages = sysconf(_SC_PHYS_PAGES), pageBytes = sysconf(_SC_PAGESIZE);
    if (pages > 0 && pageBytes > 0 && bytes > uint64_t(pages) * uint64_t(pageBytes))
        fail(GP_ERROR_OUT_OF_MEMORY, "the frame needs {} bytes, more than this machine's memory",
             bytes);
}

// At least; images of blocks are rounded up.
size_t bytesPerPixelOf(FrameMode mode) {
    return sizeof(glm::u8vec4) +
           (mode == FrameMode::realtime ? RealtimeImages::bytesPerPixel() : sizeof(PixelSums));
}

GpFrame newFrame(DeviceObject& device, const GpFrameDesc& desc) {
    checkImageSize(desc.width, desc.height, sideLimit, uint64_t(sideLimit) * sideLimit);
    const auto mode = FrameMode(checkEnum(desc.mode, 3, "mode"));
    auto object = std::make_shared<FrameObject>(device);
    object->mode = mode;
    FrameImages& images = object->images;
    images.width = desc.width;
    images.height = desc.height;
    const uint64_t bytes = images.pixelCount() * bytesPerPixelOf(mode);
    checkFits(bytes);
    if (mode == FrameMode::realtime) {
        object->realtime = std::make_unique<RealtimeFrame>();
        const glm::ivec2 size(int(desc.width), int(desc.height));
        object->realtime->resize(size, size, {});
    } else {
        images.sums.resize(images.pixelCount());
    }
    images.display.resize(images.pixelCount());
    object->statistics.noise = -1;
    object->statistics.frameBytes = bytes;
    return publish<GpFrame>(object);
}

}  // namespace

void checkRendered(const FrameObject& frame) {
    if (!frame.rendered)
        fail(GP_ERROR_INVALID_OPERATION, "nothing was rendered into the frame yet");
}

}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpFrame gpNewFrame(GpDevice device, const GpFrameDesc* desc) {
    return enter("gpNewFrame", "device", device, [&](DeviceObject& d) {
        checkPointer(desc, "desc");
        return newFrame(d, *desc);
    });
}

GpError gpReleaseFrame(GpFrame frame) {
    return enter("gpReleaseFrame", "frame", frame,
                 [&](FrameObject&) { handles().remove(bitsOf(frame)); });
}

GpError gpGetImageInfo(GpFrameImage image, GpImageInfo* info) {
    auto body = [&](Object*) {
        checkPointer(info, "info");
        const auto which = gp::FrameImage(checkEnum(image, GP_IMAGE_COUNT, "image"));
        const gp::FrameImageInfo& known = gp::frameImageInfo(which);
        info->name = known.name;
        info->format = GpImageFormat(known.format);
        info->bytesPerPixel = known.bytesPerPixel;
    };
    return enterFree("gpGetImageInfo", BodyRef(body));
}

GpError gpTonemapFrame(GpFrame frame, float exposureEv, GpTonemap tonemap) {
    return enter("gpTonemapFrame", "frame", frame, [&](FrameObject& f) {
        const float ev = checkExposure(exposureEv);
        const auto curve = gp::Tonemap(checkEnum(tonemap, 4, "tonemap"));
        checkRendered(f);
        gp::Backend& backend = *f.device->backend;
        if (f.realtime && f.images.drawn.empty())
            backend.tonemapRealtime(f.realtime->images().views(), ev, curve, f.images.display);
        else
            backend.tonemap(ev, curve, f.images);
        gp::drawOverlay(backend, f.overlay, f.camera, f.images);
        f.shownEv = ev;
        f.shownTonemap = curve;
    });
}

GpError gpReadFrameImage(GpFrame frame, GpFrameImage image, void* pixels, size_t size) {
    return enter("gpReadFrameImage", "frame", frame, [&](FrameObject& f) {
        const auto which = gp::FrameImage(checkEnum(image, GP_IMAGE_COUNT, "image"));
        checkPointer(pixels, "pixels");
        checkRendered(f);
        const size_t needed = f.images.pixelCount() * gp::frameImageInfo(which).bytesPerPixel;
        if (size < needed)
            fail(GP_ERROR_INVALID_OPERATION, "size is {}, but the image has {} bytes", size,
                 needed);
        readImage(f, which, pixels);
    });
}

GpError gpGetFrameStatistics(GpFrame frame, GpFrameStatistics* statistics) {
    return enter("gpGetFrameStatistics", "frame", frame, [&](FrameObject& f) {
        checkPointer(statistics, "statistics");
        *statistics = f.statistics;
    });
}

}  // extern "C"
