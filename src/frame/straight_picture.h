// A picture as image files with alpha want it: colours as if each pixel were covered whole.
#pragma once

#include <vector>

#include "backend/backend.h"
#include "frame/draw.h"

namespace gp {

// How a frame's picture is shown.
struct ShownPicture {
    float exposureEv = 0;
    Tonemap tonemap = Tonemap::agx;
    const DrawList* overlay = nullptr;  // drawn over it, seen by
    const Camera* camera = nullptr;
};

// `color` is radiance times coverage, and coverage; what comes out is encoded for a display. Where
// nothing is covered all is zero, so light that was added without covering anything is lost.
std::vector<glm::u8vec4> straightPicture(Backend& backend, std::vector<glm::vec4> color,
                                         uint32_t width, uint32_t height,
                                         const ShownPicture& shown);

}  // namespace gp
