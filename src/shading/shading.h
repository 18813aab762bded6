// The shading functions for C++: everything in src/shading as gp::shading::name, with internal
// linkage. It stands at the top of a translation unit, outside of every namespace.
#pragma once

#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/shading.glsl"
GP_SHADING_END
