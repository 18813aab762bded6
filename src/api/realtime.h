// Frames of GP_MODE_REALTIME.
#pragma once

#include "api/frames.h"
#include "frame/realtime_plan.h"

namespace gp::api {

bool isDefault(const GpRealtimeOptions& options);
// The options that this mode has; throws ApiError for those that it has not.
RealtimePlan realtimePlanFrom(const GpRenderOptions& options);
// The size of rays from that of the picture, into plan.frame.
void setSizes(RealtimePlan& plan, const GpRenderOptions& options, glm::uvec2 output);
RealtimeResult renderRealtime(FrameObject& frame, SceneObject& scene, const RealtimePlan& plan);

}  // namespace gp::api
