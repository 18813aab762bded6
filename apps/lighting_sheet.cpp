#include "lighting_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exposure.h"
#include "gnuplot.h"
#include "picture_grid.h"
#include "render_frame.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

GridPicture pictureOf(GpDevice device, GpFrame frame, const RenderSettings& settings) {
    GridPicture picture;
    picture.width = settings.size.width;
    picture.height = settings.size.height;
    std::vector<unsigned char> rgba(std::size_t{4} * picture.width * picture.height);
    check(device, gpReadFrameImage(frame, GP_IMAGE_DISPLAY, rgba.data(), rgba.size()));
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        picture.pixels.push_back({rgba[i], rgba[i + 1], rgba[i + 2]});
    }
    return picture;
}

// About as wide as high, counted in pictures of 16:9.
unsigned columnsFor(std::size_t pictures) {
    return static_cast<unsigned>(std::ceil(std::sqrt(static_cast<double>(pictures))));
}

}  // namespace

bool isSheet(const LocalSettings& s) {
    return s.models.words.size() > 1 || s.frequencyWords.size() > 1 ||
           std::find(s.models.words.begin(), s.models.words.end(), "all") != s.models.words.end();
}

void checkSheet(const RenderSettings& settings) {
    checkDrawable(settings.outputPath);
    if (!settings.jsonPath.empty()) {
        throw UsageError("--json: only for a single picture");
    }
    if (settings.save.alpha != 0) {
        throw UsageError("--alpha: only for a single picture");
    }
}

int renderSheet(GpDevice device, GpScene scene, const GpCameraDesc& camera,
                const RenderSettings& settings, const std::vector<Lighting>& lightings) {
    std::vector<Frame> frames;
    std::vector<float> colors;
    for (const Lighting& lighting : lightings) {
        frames.push_back(newFrameFor(device, settings));
        if (!trace(device, frames.back().get(), scene, camera, settings, lighting.local)) {
            say(settings, "interrupted: nothing saved");
            return kExitInterrupted;
        }
        appendColor(device, frames.back().get(), settings, colors);
    }
    const double ev = settings.exposureEv ? *settings.exposureEv
                                          : automaticExposureEv(colors.data(), colors.size() / 4);
    const std::size_t frequencies = std::max<std::size_t>(settings.local.frequencyWords.size(), 1);
    PictureGrid grid;
    grid.columns = static_cast<unsigned>(frequencies > 1 ? frequencies
                                                         : columnsFor(lightings.size()));
    for (std::size_t i = 0; i < lightings.size(); ++i) {
        check(device, gpTonemapFrame(frames[i].get(), static_cast<float>(ev),
                                     settings.options.tonemap));
        GridPicture picture = pictureOf(device, frames[i].get(), settings);
        const std::string model = lightings[i].model.empty() ? "own materials"
                                                             : lightings[i].model;
        picture.title = frequencies > 1 ? fmt::format("{}, {}", model, lightings[i].frequency)
                                        : model;
        grid.pictures.push_back(std::move(picture));
    }
    drawPictureGrid(grid, settings.outputPath);
    say(settings, fmt::format("saved {}: {} pictures of {}x{}, exposure {:+.2f} EV{}",
                              settings.outputPath, lightings.size(), settings.size.width,
                              settings.size.height, ev,
                              settings.exposureEv ? "" : " (automatic)"));
    return kExitSuccess;
}

}  // namespace gp::tool
