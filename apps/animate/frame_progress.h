// One bar for all frames of a moving picture, and rendering a frame under it.
#pragma once

#include <chrono>
#include <cstdint>

#include "library.h"
#include "progress_bar.h"

namespace gp::tool {

class FrameProgress {
public:
    FrameProgress(bool quiet, std::uint32_t first, std::uint32_t frames)
        : m_bar(stderrIsTerminal() && !quiet), m_first(first), m_frames(frames) {}

    // What renders next is this frame's share `from` .. `to` of 0..1.
    void begin(std::uint32_t frame, double from, double to);
    void show(double part);  // 0..1 of that

private:
    ProgressBar m_bar;
    std::uint32_t m_first, m_frames, m_frame = 0;
    double m_from = 0, m_to = 1;
    std::chrono::steady_clock::time_point m_begun = std::chrono::steady_clock::now();
};

// gpRender, showing how far it is. Returns false when it was interrupted; throws RunError.
bool renderWith(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
                GpRenderOptions options, FrameProgress& progress);

}  // namespace gp::tool
