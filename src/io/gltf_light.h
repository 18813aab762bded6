// Lights and cameras of a glTF file.
#pragma once

#include <memory>

#include "io/gltf_nodes.h"
#include "scene/camera.h"
#include "scene/light.h"

namespace gp::io {

// The light at this node (KHR_lights_punctual).
std::shared_ptr<Light> readLight(Document& document, const Node& node);
Camera readCamera(Document& document, const Node& node);

// Puts them where the node is now.
void placeLight(const Node& node, Light& light);
void placeCamera(const Node& node, Camera& camera);

}  // namespace gp::io
