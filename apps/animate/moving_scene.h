// A scene whose file plays, and the camera that moves through it.
#pragma once

#include <string>
#include <vector>

#include "animate/animate_settings.h"
#include "animate/camera_path.h"
#include "scene_setup.h"

namespace gp::tool {

class MovingScene {
public:
    // Loads the file and everything else that the settings name; those must outlive it.
    MovingScene(GpDevice device, const AnimateSettings& settings);

    // Everything where it is in this frame; returns the camera.
    GpCameraDesc goTo(std::uint32_t frame);

    GpScene scene() const { return m_setup.scene.get(); }
    double secondsLoad() const { return m_setup.secondsLoad; }
    const std::vector<std::string>& notes() const { return m_setup.notes; }

private:
    double secondsOf(std::uint32_t frame) const { return frame / m_settings.framesPerSecond; }
    void play(std::uint32_t frame);
    CameraPath pathOf();
    CameraPath orbit();

    GpDevice m_device;
    const AnimateSettings& m_settings;
    SceneSetup m_setup;
    CameraPath m_path;
};

// The exposure for all frames, in stops: the one that was asked for, or by `render`'s rule from a
// small reference picture of frame 0, so that it depends on neither the mode nor where a run
// begins. Returns none when it was interrupted.
std::optional<double> exposureOf(GpDevice device, MovingScene& moving,
                                 const AnimateSettings& settings);
// The rule alone, for what the camera sees of a scene as it is.
std::optional<double> exposureOf(GpDevice device, GpScene scene, const GpCameraDesc& camera,
                                 const RenderSettings& settings);

}  // namespace gp::tool
