// What the calls on frames share.
#pragma once

#include "api/objects.h"

namespace gp::api {

void checkRendered(const FrameObject& frame);  // else GP_ERROR_INVALID_OPERATION

// An image of a frame of any mode; throws ApiError for one that its mode has not.
void readImage(const FrameObject& frame, FrameImage which, void* pixels);

// Finite, and within what 2^ev can carry without leaving the range of floats.
float checkExposure(float ev);

}  // namespace gp::api
