// glTF 2.0 into a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "io/file_error.h"
#include "scene/scene.h"

namespace gp::io {

class GltfPlayer;  // io/gltf_player.h

constexpr int allAnimations = -2;  // at once; of two that move the same the later one wins

struct GltfOptions {
    double time = 0;           // seconds: where animations, morphs and skins stand
    int animation = -1;        // which animation plays at `time`; -1: the first, if there is one
    int scene = -1;            // -1: the file's default
    bool playable = false;     // keep what it takes to show other moments
    uint64_t maxImagePixels = uint64_t(1) << 28;  // of each image; more is an error
};

// Appends the file's content to `scene`. Throws FileError; the scene is then unchanged. Returns
// null unless options.playable.
std::shared_ptr<GltfPlayer> loadGltf(const std::string& path, const GltfOptions& options,
                                     Scene& scene);

}  // namespace gp::io
