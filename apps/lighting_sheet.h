// Several lighting models, or frequencies, of one scene side by side.
#pragma once

#include <vector>

#include "render_settings.h"

namespace gp::tool {

// Whether the settings ask for more than one picture.
bool isSheet(const LocalSettings& settings);

// What a sheet cannot be; throws UsageError.
void checkSheet(const RenderSettings& settings);

// Renders and draws it, all pictures with one exposure; returns the exit code. A model a row where
// there are several frequencies. Interrupted, nothing is drawn.
int renderSheet(GpDevice device, GpScene scene, const GpCameraDesc& camera,
                const RenderSettings& settings, const std::vector<Lighting>& lightings);

}  // namespace gp::tool
