// Files that stand in the place of textures by name: gpSetTextureOverrides.
#pragma once

#include "api/objects.h"

namespace gp::api {

// Makes the object's texture, or what stands in the folder for its name, and the maps that stand
// beside it. Throws io::FileError for a file that cannot be read.
void makeWithOverrides(TextureObject& object, TextureDesc&& desc);

}  // namespace gp::api
