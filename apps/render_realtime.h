// `glitterpath render --mode realtime`: the picture that an application would show after so many
// frames of standing still.
#pragma once

#include "render_report.h"

namespace gp::tool {

// --frames and what else belongs to real time. The settings must outlive the parsing.
void addRealtimeRenderOptions(CLI::App& app, RenderSettings& settings);

// Whether options of other modes were given, and what the library wants to know; throws UsageError.
void finishRealtimeRender(const CLI::App& app, RenderSettings& settings);

// Renders the frames; counts and times of the report are sums over them. After Ctrl-C the frame
// that runs is the last one, and `report.interrupted` is set. Throws RunError.
void renderRealtime(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
                    const RenderSettings& settings, RenderReport& report);

}  // namespace gp::tool
