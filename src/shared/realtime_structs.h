// The C++ side of realtime_structs.glsl.
#pragma once

#include <cstddef>

#include "shading/lang.h"

namespace gp::shared {
using namespace glm;
#include "shared/realtime_structs.glsl"

static_assert(offsetof(RealtimeConstants, frame_index) == 24);
static_assert(sizeof(SeaMotion) == 40 && offsetof(RealtimeConstants, sea) == 72);
static_assert(offsetof(RealtimeConstants, direct_history_frames) == 112);
}  // namespace gp::shared
