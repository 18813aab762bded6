// The viewer's frames: small ones while the view changes, one of full size at rest.
#pragma once

#include <cstdint>
#include <vector>

#include "library.h"
#include "view/shown_picture.h"
#include "view/view_choices.h"

namespace gp::tool::view {

class ViewFrames {
public:
    explicit ViewFrames(GpDevice device) : m_device(device) {}

    // One frame of the live mode, as large as the time allows.
    void renderLive(GpScene scene, const ViewChoices& choices);
    // More samples of the picture at rest. `progress` may end it. `anew`: the frame held another
    // view. Returns whether at least one sample a pixel is there.
    bool renderAtRest(GpScene scene, const ViewChoices& choices, GpProgressCallback progress,
                      void* user, bool anew);
    std::uint32_t samplesAtRest() const { return m_samplesAtRest; }

    // The frame to be shown: the last one of the above that held a whole sample.
    // GP_IMAGE_ bits of the layers that it can be saved with.
    std::uint32_t layersOfShown() const;
    GpFrame shown() const { return shownFrame().frame.get(); }
    RenderSize shownSize() const { return shownFrame().size; }
    // Reads it and fills in everything but serial and exposure. ev: for images that need one.
    // Where the frame has no such image it is the display, with a note.
    ShownPicture read(const std::string& image, float ev) const;
    std::vector<float> readColor() const;
    // The frame that renderLive began is ready to be seen: returns the seconds since then, which
    // decide about the size of the next one.
    double noteLiveTime();

private:
    struct SizedFrame {
        Frame frame;
        RenderSize size;
        GpFrameMode mode = GP_MODE_REFERENCE;
    };
    void prepare(SizedFrame& frame, RenderSize size, GpFrameMode mode);
    const SizedFrame& shownFrame() const { return m_showsRest ? m_rest : m_live; }

    GpDevice m_device;
    ResolutionController m_controller;
    SizedFrame m_live, m_rest;
    bool m_showsRest = false;
    std::uint32_t m_samplesAtRest = 0;
    std::uint64_t m_liveFrames = 0, m_cuts = 0;
    double m_liveStart = 0, m_secondsBuild = 0, m_secondsFrame = 0;
};

}  // namespace gp::tool::view
