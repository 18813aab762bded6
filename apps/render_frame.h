// Rendering a frame as `glitterpath render` does: with a bar of progress, and an end by Ctrl-C.
#pragma once

#include <string>
#include <vector>

#include "render_settings.h"

namespace gp::tool {

// Messages for people go to stderr, so that stdout is free for --json -.
void say(const RenderSettings& settings, const std::string& text);

// A frame of the settings' size and mode.
Frame newFrameFor(GpDevice device, const RenderSettings& settings);

// Returns false when it was cancelled.
bool trace(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
           const RenderSettings& settings, const GpLocalLighting& local);

// Adds the radiance and coverage of the frame's pixels, RGBA.
void appendColor(GpDevice device, GpFrame frame, const RenderSettings& settings,
                 std::vector<float>& pixels);

// Shows the frame with the exposure of automaticExposureEv; returns it.
double exposeAutomatically(GpDevice device, GpFrame frame, const RenderSettings& settings);

}  // namespace gp::tool
