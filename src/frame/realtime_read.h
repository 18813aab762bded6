// The images of a real-time frame, read back as floats.
#pragma once

#include "frame/frame_images.h"
#include "frame/realtime_images.h"

namespace gp {

// What a layer shows, RGBA for each pixel of RealtimeSize::FULL; OUTPUT images for each of theirs.
void readRealtimeLayer(const RealtimeImages& images, RealtimeImage which, glm::vec4* pixels);

// The images that every mode has, for a pixel of FULL. Not `display`, nor `variance`.
void readRealtimeImage(const RealtimeImages& images, FrameImage which, void* pixels);

}  // namespace gp
