// What the calls on frames share.
#pragma once

#include "api/objects.h"

namespace gp::api {

void checkRendered(const FrameObject& frame);  // else GP_ERROR_INVALID_OPERATION

// Finite, and within what 2^ev can carry without leaving the range of floats.
float checkExposure(float ev);

}  // namespace gp::api
