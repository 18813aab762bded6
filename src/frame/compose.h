// The last passes of a picture: rasterised geometry into the radiance, the tone map, and rasterised
// geometry over it.
#pragma once

#include <functional>

#include "backend/backend.h"
#include "frame/draw.h"

namespace gp {

// Whether a depth image is needed.
bool usesDepth(const std::vector<PlacedDraw>& draws);

// Sky and scene draws of `draws` into `color`, linear radiance whose alpha is the share of a pixel
// that camera rays met something in. `depth`: metres along the view of what they met, or infinite.
// Both have width * height pixels, top row first.
void composeDraws(Backend& backend, const DrawList& draws, const Camera& camera, uint32_t width,
                  uint32_t height, glm::vec4* color, const float* depth);

// The overlay draws of `draws` into images.display.
void drawOverlay(Backend& backend, const DrawList& draws, const Camera& camera,
                 FrameImages& images);

// Where the traced picture comes from, for each mode.
struct TracedPicture {
    std::function<void(FrameImage, void*)> read;  // color and depth
    std::function<void(float exposureEv)> tonemap;  // into images.display
};
TracedPicture tracedPicture(Backend& backend, const FramePlan& plan, FrameImages& images);

// All of it by the plan: images.drawn, where something is drawn into it, and images.display.
void finishPicture(Backend& backend, const FramePlan& plan, float exposureEv,
                   const TracedPicture& traced, FrameImages& images);

}  // namespace gp
