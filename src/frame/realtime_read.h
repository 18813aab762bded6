// The images of a real-time frame, read back as floats.
#pragma once

#include "frame/frame_images.h"
#include "frame/realtime_images.h"

namespace gp {

// What a layer shows, RGBA for each pixel of the picture.
void readRealtimeLayer(const RealtimeImages& images, RealtimeImage which, glm::vec4* pixels);

// The images that every mode has, a value for each pixel of the picture. Not `display`, nor
// `variance`.
void readRealtimeImage(const RealtimeImages& images, FrameImage which, void* pixels);

}  // namespace gp
