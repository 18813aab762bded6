// What the rendering thread hands to the window's.
#pragma once

#include <glitterpath/glitterpath.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "view/image_view.h"
#include "view/resolution_controller.h"

namespace gp::tool::view {

// A picture, with what there is to say of it.
struct ShownPicture {
    std::uint64_t serial = 0;          // of the choices that it shows
    std::uint64_t liveFrames = 0;      // so far
    RenderSize size;
    std::vector<std::uint8_t> rgba;    // opaque, top row first
    std::vector<std::uint32_t> ids;    // GP_IMAGE_INSTANCE
    bool atRest = false;
    double scale = 1;                  // of each side
    double renderScale = 1;            // rays along each side for a pixel of it
    std::uint32_t samplesBeside = 0;   // of the reference at the right; 0: there is none
    double rmseBeside = 0;             // between the two: of sRGB values, 0..1
    std::optional<HeatScale> heat;     // where a heat map is shown
    float exposureEv = 0;
    std::string note;                  // where what was wished for is not what is shown
    std::vector<std::pair<std::string, double>> passes;  // milliseconds; of real time
    double secondsFrame = 0;           // of the last live frame, from its start to pixels
    GpFrameStatistics statistics{};
};

// What it has to tell beside pictures.
struct ViewNote {
    bool isError = false;
    std::string text;
};

}  // namespace gp::tool::view
