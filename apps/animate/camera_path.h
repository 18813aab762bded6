// Cameras that move: by keys of a file, around the scene, or as the scene's own.
#pragma once

#include <glitterpath/glitterpath.h>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <functional>
#include <string>
#include <vector>

namespace gp::tool {

// Where the camera is, `seconds` after the first frame.
using CameraPath = std::function<GpCameraDesc(double seconds)>;

struct CameraKey {
    double time = 0;               // seconds
    glm::dvec3 position{0.0};      // metres
    glm::dvec3 target{0.0, 0.0, -1.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // of a camera that looks along -Z, with +Y up
    double fovDeg = 45;            // vertical
};

// At least one key; times increase. Before the first key and after the last one it holds still.
struct CameraKeys {
    bool turns = false;    // `rotation` says where it looks, else `target`
    bool straight = false; // from key to key along lines, else along a smooth curve
    std::vector<CameraKey> keys;
};

// Reads such keys from JSON (docs/manual.md has the format). fovDeg: where the file gives none.
// Throws RunError with one line that names the file and the place.
CameraKeys readCameraKeys(const std::string& path, double fovDeg);

GpCameraDesc cameraAt(const CameraKeys& keys, double seconds);

// `start`, carried around the vertical line through `centre`: counter-clockwise seen from above
// where periodSeconds > 0, else clockwise. It keeps looking at the centre.
GpCameraDesc orbitAt(const GpCameraDesc& start, const glm::dvec3& centre, double periodSeconds,
                     double seconds);

}  // namespace gp::tool
