// The viewer's frames: small ones while the view changes, one of full size at rest.
#pragma once

#include <cstdint>
#include <optional>
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
    // More samples of the reference that is seen beside the last live frame, and has its size;
    // `anew`: the frame held another view.
    void renderBeside(GpScene scene, const ViewChoices& choices, GpProgressCallback progress,
                      void* user, bool anew);
    // Of the reference that belongs to the last live frame; 0: there is none.
    std::uint32_t samplesBeside() const {
        return m_beside.size == m_live.size ? m_samplesBeside : 0;
    }
    void forgetBeside() { m_samplesBeside = 0; }

    // The frame to be shown: the last live one or that at rest, if it holds a whole sample.
    // GP_IMAGE_ bits of the layers that it can be saved with.
    std::uint32_t layersOfShown() const;
    GpFrame shown() const { return shownFrame().frame.get(); }
    RenderSize shownSize() const { return shownFrame().size; }
    // Reads it and fills in everything but serial and exposure. ev: for images that need one.
    // Where the frame has no such image it is the display, with a note. With a divider the right of
    // it is the reference beside, where that has samples.
    ShownPicture read(const std::string& image, float ev, std::optional<float> divider) const;
    // All of what is shown anew with this exposure.
    void tonemap(float ev, GpTonemap curve) const;
    // Of the live frame: its own, with eye adaptation.
    float exposureOfLive() const;
    std::vector<float> readColor() const;
    // The live picture and the reference in one file, .png or .exr; both are there.
    void saveBeside(const std::string& path, float divider) const;
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
    std::uint32_t addSamples(const SizedFrame& frame, GpScene scene, const ViewChoices& choices,
                             std::uint32_t samples, bool anew, double seconds,
                             GpProgressCallback progress, void* user);
    std::vector<float> colorOf(const SizedFrame& frame) const;
    void putBeside(ShownPicture& picture, const std::string& image, float ev, float divider) const;
    const SizedFrame& shownFrame() const { return m_showsRest ? m_rest : m_live; }

    GpDevice m_device;
    ResolutionController m_controller;
    SizedFrame m_live, m_rest, m_beside;
    bool m_showsRest = false;
    std::uint32_t m_samplesAtRest = 0, m_samplesBeside = 0;
    std::uint64_t m_liveFrames = 0, m_cuts = 0;
    double m_liveStart = 0, m_lastLiveStart = 0, m_secondsBuild = 0, m_secondsFrame = 0;
};

}  // namespace gp::tool::view
