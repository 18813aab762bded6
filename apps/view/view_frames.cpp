#include "view/view_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "view/image_view.h"

namespace gp::tool::view {
namespace {

// Between two pictures at rest: short enough to see it clear up, long enough to cost nothing.
constexpr double kSecondsAtRest = 0.25;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

GpFrameMode frameModeOf(LiveMode mode) {
    switch (mode) {
        case LiveMode::realtime: return GP_MODE_REALTIME;
        case LiveMode::local: return GP_MODE_LOCAL;
        case LiveMode::traced: break;
    }
    return GP_MODE_REFERENCE;
}

// In ours 0 is none; in the library's it is the default.
std::int32_t libraryCount(std::int32_t count) {
    return count == 0 ? GP_NO_BOUNCES : count;
}

void addRealtimeOptions(const RealtimeChoices& choices, bool isCut, GpRenderOptions& options) {
    options.maxBounces = libraryCount(choices.bounces);
    options.realtime.resetHistory = isCut ? 1 : 0;
    options.realtime.antiAliasing = choices.antiAliasing;
    options.realtime.renderScale = choices.renderScale;
    options.realtime.mirrorLimit = libraryCount(choices.mirrors);
}

void readPasses(GpDevice device, GpFrame frame, ShownPicture& picture) {
    std::uint32_t count = 0;
    check(device, gpGetPassTimes(frame, nullptr, 0, &count));
    std::vector<GpPassTime> times(count);
    check(device, gpGetPassTimes(frame, times.data(), count, &count));
    for (const GpPassTime& time : times) {
        picture.passes.emplace_back(time.name, time.milliseconds);
    }
}

std::size_t pixelCount(RenderSize size) {
    return static_cast<std::size_t>(size.width) * size.height;
}

}  // namespace

void ViewFrames::prepare(SizedFrame& frame, RenderSize size, GpFrameMode mode) {
    if (frame.frame && frame.size == size && frame.mode == mode) {
        return;
    }
    GpFrameDesc desc{};
    desc.width = size.width;
    desc.height = size.height;
    desc.mode = mode;
    frame.frame.reset();  // the old one's memory first
    frame.frame = newFrame(m_device, desc);
    frame.size = size;
    frame.mode = mode;
}

void ViewFrames::renderLive(GpScene scene, const ViewChoices& choices) {
    m_liveStart = now();
    m_controller.setTarget(choices.liveSeconds);
    m_showsRest = false;
    m_samplesAtRest = 0;
    prepare(m_live, m_controller.sizeFor(choices.size), frameModeOf(choices.live));
    GpRenderOptions options{};
    options.samplesPerPixel = 1;
    options.seed = ++m_liveFrames;  // the same noise in every frame would look like dirt
    options.exposureEv = choices.exposureEv;
    options.tonemap = choices.tonemap;
    if (choices.live == LiveMode::realtime) {
        addRealtimeOptions(choices.realtime, choices.realtime.cuts != m_cuts, options);
    }
    m_cuts = choices.realtime.cuts;
    check(m_device, gpRender(m_live.frame.get(), scene, &choices.camera, &options));
    GpFrameStatistics statistics{};
    check(m_device, gpGetFrameStatistics(m_live.frame.get(), &statistics));
    m_secondsBuild = statistics.secondsBuild;
}

double ViewFrames::noteLiveTime() {
    m_secondsFrame = now() - m_liveStart;
    // Structures are built once; smaller pictures would not make that quicker.
    m_controller.record(std::max(m_secondsFrame - m_secondsBuild, 1.0e-6));
    return m_secondsFrame;
}

bool ViewFrames::renderAtRest(GpScene scene, const ViewChoices& choices,
                              GpProgressCallback progress, void* user, bool anew) {
    prepare(m_rest, choices.size, GP_MODE_REFERENCE);
    GpRenderOptions options{};
    options.accumulate = anew ? 0 : 1;
    options.exposureEv = choices.exposureEv;
    options.tonemap = choices.tonemap;
    options.progress = progress;
    options.progressUser = user;
    // The first sample as soon as it is there.
    const bool first = m_samplesAtRest == 0;
    options.samplesPerPixel = first ? 1 : choices.mostSamples - m_samplesAtRest;
    options.timeLimit = first ? 0.0 : kSecondsAtRest;
    const GpError error = gpRender(m_rest.frame.get(), scene, &choices.camera, &options);
    if (error == GP_ERROR_CANCELLED) {
        gpGetError(m_device, nullptr);  // it is no failure, so nobody shall find it later
    } else {
        check(m_device, error);
    }
    GpFrameStatistics statistics{};
    check(m_device, gpGetFrameStatistics(m_rest.frame.get(), &statistics));
    m_samplesAtRest = statistics.samplesPerPixel;
    m_showsRest = m_samplesAtRest > 0;
    return m_showsRest;
}

std::vector<float> ViewFrames::readColor() const {
    std::vector<float> rgba(4 * pixelCount(shownSize()));
    check(m_device, gpReadFrameImage(shown(), GP_IMAGE_COLOR, rgba.data(),
                                     rgba.size() * sizeof(float)));
    return rgba;
}

std::uint32_t ViewFrames::layersOfShown() const {
    std::uint32_t layers = 0;
    for (const ImageName& image : allImages()) {
        const bool isLayer = image.kind && image.kind != GP_IMAGE_COLOR &&
                             image.kind != GP_IMAGE_DISPLAY;
        if (isLayer && hasImage(shownFrame().mode, image)) {
            layers |= 1u << *image.kind;
        }
    }
    return layers;
}

ShownPicture ViewFrames::read(const std::string& name, float ev) const {
    ShownPicture picture;
    picture.size = shownSize();
    const std::size_t count = pixelCount(picture.size);
    const ImageName* image = imageNamed(name);
    if (image == nullptr || !hasImage(shownFrame().mode, *image)) {
        picture.note = fmt::format("{}: not in this mode; this is the display", name);
        image = imageNamed("display");
    }
    std::vector<std::byte> bytes(count * image->info.bytesPerPixel);
    check(m_device, image->kind
                        ? gpReadFrameImage(shown(), *image->kind, bytes.data(), bytes.size())
                        : gpReadFrameLayer(shown(), image->info.name,
                                           reinterpret_cast<float*>(bytes.data()), bytes.size()));
    picture.rgba = visiblePixels(image->info, bytes.data(), count, ev);
    picture.ids.resize(count);
    check(m_device, gpReadFrameImage(shown(), GP_IMAGE_INSTANCE, picture.ids.data(),
                                     count * sizeof(std::uint32_t)));
    readPasses(m_device, shown(), picture);
    picture.liveFrames = m_liveFrames;
    picture.atRest = m_showsRest;
    picture.scale = m_showsRest ? 1.0 : m_controller.scale();
    picture.secondsFrame = m_secondsFrame;
    check(m_device, gpGetFrameStatistics(shown(), &picture.statistics));
    return picture;
}

}  // namespace gp::tool::view
