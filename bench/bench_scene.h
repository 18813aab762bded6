// What the benchmarks render: a scene file with light and camera, by the library's own importer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frame/frame_plan.h"
#include "scene/scene.h"

namespace gp::bench {

struct SceneOptions {
    std::string path;
    std::string environment;          // Radiance HDR or EXR; "": the file's own light, or a sky
    double environmentRotationDeg = 0;
    std::vector<float> sun;           // azimuth, elevation (degrees), W/m^2; empty: none
    std::vector<float> from, lookAt;  // empty: the file's camera, or one that shows everything
    double fovDeg = 0;                // vertical; 0: 45, or the file's camera
    uint32_t width = 640, height = 360;
};

// Throws io::FileError.
Scene loadScene(const SceneOptions& options);

Camera chooseCamera(const Scene& scene, const SceneOptions& options);

}  // namespace gp::bench
