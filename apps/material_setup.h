// --material: the materials of a scene replaced by models, presets and measured files.
#pragma once

#include <string>
#include <vector>

#include "library.h"

namespace gp::tool {

// Each word is [NAME=]MODEL[:PARAMETERS]; without NAME all materials are meant. In their order.
// Maps of the file stay where the model has a use for them and the word says nothing else; the
// lines that come back tell. Throws UsageError where a word, a model or a parameter is wrong or the
// scene has no such NAME.
std::vector<std::string> replaceMaterials(GpDevice device, GpScene scene,
                                          const std::vector<std::string>& words);

}  // namespace gp::tool
