// glTF 2.0 into a scene.
#pragma once

#include <cstdint>
#include <string>

#include "io/file_error.h"
#include "scene/scene.h"

namespace gp::io {

struct GltfOptions {
    double time = 0;           // seconds: where animations, morphs and skins stand
    int animation = -1;        // which animation plays at `time`; -1: the first, if there is one
    int scene = -1;            // -1: the file's default
    uint64_t maxImagePixels = uint64_t(1) << 28;  // of each image; more is an error
};

// Appends the file's content to `scene`. Throws FileError; the scene is then unchanged.
void loadGltf(const std::string& path, const GltfOptions& options, Scene& scene);

}  // namespace gp::io
