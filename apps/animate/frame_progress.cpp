#include "animate/frame_progress.h"

#include <fmt/format.h>

#include "interrupt.h"
#include "output.h"

namespace gp::tool {
namespace {

int onProgress(void* user, const GpProgress* progress) {
    static_cast<FrameProgress*>(user)->show(progress->fraction);
    return interrupted() ? 1 : 0;
}

}  // namespace

void FrameProgress::begin(std::uint32_t frame, double from, double to) {
    m_frame = frame;
    m_from = from;
    m_to = to;
    show(0);
}

void FrameProgress::show(double part) {
    const double done = m_frame - m_first + m_from + (m_to - m_from) * part;
    const double all = m_frames - m_first;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_begun;
    std::string facts = fmt::format("frame {} of {}", m_frame + 1, m_frames);
    // The first second says little about the others.
    if (done > 0 && elapsed.count() > 1) {
        const double each = elapsed.count() / done;
        facts += fmt::format("  {:.2f} s each  {} left", each, clockText(each * (all - done)));
    }
    m_bar.show(done / all, facts);
}

bool renderWith(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
                GpRenderOptions options, FrameProgress& progress) {
    options.progress = &onProgress;
    options.progressUser = &progress;
    const GpError error = gpRender(frame, scene, &camera, &options);
    if (error == GP_ERROR_CANCELLED) {
        gpGetError(device, nullptr);  // it is no failure, so nobody shall find it later
        return false;
    }
    check(device, error);
    return true;
}

}  // namespace gp::tool
