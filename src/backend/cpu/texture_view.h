#pragma once

#include "backend/cpu/scene_view.h"
#include "scene/texture.h"

namespace gp::cpu {

// Points into the texture, which must live as long as the view.
TextureView textureView(const Texture& texture);

}  // namespace gp::cpu
