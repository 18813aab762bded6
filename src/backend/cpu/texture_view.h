#pragma once

#include "backend/cpu/scene_view.h"
#include "scene/slope_map.h"
#include "scene/texture.h"

namespace gp::cpu {

// Points into the texture, which must live as long as the view.
TextureView textureView(const Texture& texture);

// The same of an image of slopes.
SlopeMapView slopeMapView(const SlopeMap& map);

}  // namespace gp::cpu
