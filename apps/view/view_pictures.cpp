// ViewFrames: from frames to pictures.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "beside.h"
#include "metrics/color.h"
#include "view/image_view.h"
#include "view/view_frames.h"

namespace gp::tool::view {
namespace {

// sRGB of the line between the live picture and the reference.
constexpr std::array<std::uint8_t, 4> kDividerColor = {255, 255, 255, 255};

std::size_t pixelCount(RenderSize size) {
    return static_cast<std::size_t>(size.width) * size.height;
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

// The image as it is to be seen; the display where the mode has none of this name.
struct SeenImage {
    std::vector<std::uint8_t> rgba;
    std::optional<HeatScale> heat;
    bool isIt = true;  // the image that was asked for
};

SeenImage readImage(GpDevice device, GpFrame frame, GpFrameMode mode, std::size_t count,
                    const std::string& name, float ev) {
    SeenImage seen;
    const ImageName* image = imageNamed(name);
    if (image == nullptr || !hasImage(mode, *image)) {
        seen.isIt = false;
        image = imageNamed("display");
    }
    std::vector<std::byte> bytes(count * image->info.bytesPerPixel);
    const auto* floats = reinterpret_cast<const float*>(bytes.data());
    if (image->kind) {
        check(device, gpReadFrameImage(frame, *image->kind, bytes.data(), bytes.size()));
    } else {
        const GpError error =
            gpReadFrameLayer(frame, image->info.name, reinterpret_cast<float*>(bytes.data()),
                             bytes.size());
        if (error == GP_ERROR_INVALID_OPERATION) {  // not with this denoiser: a layer of its own
            gpGetError(device, nullptr);
            seen = readImage(device, frame, mode, count, "display", ev);
            seen.isIt = false;
            return seen;
        }
        check(device, error);
    }
    seen.rgba = visiblePixels(image->info, bytes.data(), count, ev);
    if (scaleOf(image->info) == ImageScale::heat) {
        seen.heat = heatScaleOf(image->info.name, floats, count);
    }
    return seen;
}

// Of sRGB values from 0 to 1.
double rmseOf(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = (static_cast<double>(a[i]) - static_cast<double>(b[i])) / 255.0;
        sum += difference * difference;  // alpha is 255 in both
    }
    return a.empty() ? 0.0 : std::sqrt(sum / (0.75 * static_cast<double>(a.size())));
}

}  // namespace

std::vector<float> ViewFrames::colorOf(const SizedFrame& frame) const {
    std::vector<float> rgba(4 * pixelCount(frame.size));
    check(m_device, gpReadFrameImage(frame.frame.get(), GP_IMAGE_COLOR, rgba.data(),
                                     rgba.size() * sizeof(float)));
    return rgba;
}

std::vector<float> ViewFrames::readColor() const {
    return colorOf(shownFrame());
}

void ViewFrames::saveBeside(const std::string& path, float divider) const {
    const RenderSize size = m_live.size;
    const auto both = [&](const auto& left, const auto& right, const auto& line) {
        return besideEachOther(left, right, size.width, size.height,
                               static_cast<double>(divider), line);
    };
    std::vector<float> rgba;
    if (path.ends_with(".png")) {
        const std::size_t count = pixelCount(size);
        const std::vector<std::uint8_t> display =
            both(readImage(m_device, m_live.frame.get(), m_live.mode, count, "display", 0).rgba,
                 readImage(m_device, m_beside.frame.get(), m_beside.mode, count, "display", 0).rgba,
                 kDividerColor);
        for (const std::uint8_t value : display) {
            rgba.push_back(metrics::linearFromSrgb(static_cast<float>(value) / 255.0f));
        }
    } else {
        rgba = both(colorOf(m_live), colorOf(m_beside), std::array<float, 4>{1, 1, 1, 1});
    }
    GpImage image{};
    image.width = size.width;
    image.height = size.height;
    image.pixels = rgba.data();
    check(m_device, gpSaveImage(m_device, path.c_str(), &image));
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

void ViewFrames::putBeside(ShownPicture& picture, const std::string& name, float ev,
                           float divider) const {
    const std::size_t count = pixelCount(m_beside.size);
    const SeenImage reference =
        readImage(m_device, m_beside.frame.get(), m_beside.mode, count, name, ev);
    picture.samplesBeside = m_samplesBeside;
    if (reference.isIt) {
        picture.rmseBeside = rmseOf(picture.rgba, reference.rgba);
    } else if (picture.note.empty()) {
        picture.note = fmt::format("{}: not of the reference; right is its display", name);
    }
    picture.rgba = besideEachOther(picture.rgba, reference.rgba, m_beside.size.width,
                                   m_beside.size.height, static_cast<double>(divider),
                                   kDividerColor);
}

ShownPicture ViewFrames::read(const std::string& name, float ev,
                              std::optional<float> divider) const {
    ShownPicture picture;
    picture.size = shownSize();
    const std::size_t count = pixelCount(picture.size);
    SeenImage seen = readImage(m_device, shown(), shownFrame().mode, count, name, ev);
    if (!seen.isIt) {
        picture.note = fmt::format("{}: not in this mode; this is the display", name);
    }
    picture.rgba = std::move(seen.rgba);
    picture.heat = std::move(seen.heat);
    picture.ids.resize(count);
    check(m_device, gpReadFrameImage(shown(), GP_IMAGE_INSTANCE, picture.ids.data(),
                                     count * sizeof(std::uint32_t)));
    if (divider && !m_showsRest && samplesBeside() > 0) {
        putBeside(picture, name, ev, *divider);
    }
    readPasses(m_device, shown(), picture);
    picture.liveFrames = m_liveFrames;
    picture.atRest = m_showsRest;
    picture.scale = m_showsRest ? 1.0 : m_controller.sizeScale();
    picture.renderScale = m_showsRest ? 1.0 : m_controller.renderScale();
    picture.secondsFrame = m_secondsFrame;
    check(m_device, gpGetFrameStatistics(shown(), &picture.statistics));
    return picture;
}

}  // namespace gp::tool::view
