// All frames of something that moves, rendered and written.
#pragma once

#include <functional>
#include <optional>

#include "animate/animate_settings.h"
#include "animate/frame_writer.h"

namespace gp::tool {

// What moves: its scene, and a call that puts everything where it is in a frame and returns the
// camera.
struct FrameSource {
    GpScene scene = nullptr;
    std::function<GpCameraDesc(std::uint32_t)> goTo;
    double secondsLoad = 0;
};

// Frames settings.start .. settings.frames - 1, until Ctrl-C comes; `exposureEv` as exposureOf
// gives it: none was interrupted. Says what was saved and writes --json. Returns the exit code;
// throws RunError.
int animateFrames(GpDevice device, GpFrame frame, const FrameSource& source,
                  std::optional<double> exposureEv, FrameWriter& writer,
                  const AnimateSettings& settings);

}  // namespace gp::tool
