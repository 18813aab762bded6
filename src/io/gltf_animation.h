// Animations of a glTF file at one moment.
#pragma once

#include "io/gltf_nodes.h"

namespace gp::io {

// The names of all animations; marks the nodes that any of them moves or morphs.
std::vector<std::string> listAnimations(Document& document, std::vector<Node>& nodes);

// Puts the nodes where animation `index` has them at `time` seconds; before its first and after
// its last key an animation holds still.
void applyAnimation(Document& document, Accessors& accessors, uint32_t index, double time,
                    std::vector<Node>& nodes);

}  // namespace gp::io
