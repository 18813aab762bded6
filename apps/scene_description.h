// What the library tells about a scene, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "library.h"

namespace gp::tool {

nlohmann::ordered_json describeScene(GpDevice device, GpScene scene);

// Whether nothing lights the scene. Lamps do, an environment does, and so do surfaces that glow,
// with one exception: a texture of glowing spots of radiance up to 1 (the displays on a helmet)
// was painted to be seen, not to see by.
bool isDark(GpDevice device, GpScene scene);

}  // namespace gp::tool
