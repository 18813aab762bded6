#include "brdf/studio.h"

#include <algorithm>
#include <cmath>

namespace gp::tool {
namespace {

constexpr unsigned kWidth = 512, kHeight = 256;

// A lamp's soft box: degrees; azimuth 0 is where the camera stands, positive is to its right.
struct SoftBox {
    float azimuth, elevation, halfWidth, halfHeight, radiance;
};

constexpr SoftBox kBoxes[] = {{-42, 42, 24, 20, 3.6f}, {128, 18, 9, 38, 4.5f}, {68, -2, 16, 26, 0.7f}};
constexpr float kEdge = 3;  // degrees over which a box fades

float smoothStep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

float boxAt(const SoftBox& box, float azimuth, float elevation) {
    const float across = std::abs(std::remainder(azimuth - box.azimuth, 360.0f));
    const float along = std::abs(elevation - box.elevation);
    return box.radiance * smoothStep(box.halfWidth + kEdge, box.halfWidth, across) *
           smoothStep(box.halfHeight + kEdge, box.halfHeight, along);
}

float radianceAt(float azimuth, float elevation) {
    float radiance = 0.10f + 0.22f * smoothStep(-50, 80, elevation);
    for (const SoftBox& box : kBoxes) {
        radiance += boxAt(box, azimuth, elevation);
    }
    return radiance;
}

}  // namespace

Surroundings makeStudio() {
    Surroundings room;
    room.width = kWidth;
    room.height = kHeight;
    for (unsigned y = 0; y < kHeight; ++y) {
        const float elevation = 90.0f - 180.0f * (static_cast<float>(y) + 0.5f) / kHeight;
        for (unsigned x = 0; x < kWidth; ++x) {
            // The image's centre lies behind the sphere, +X to its right.
            const float behind = 360.0f * (static_cast<float>(x) + 0.5f) / kWidth - 180.0f;
            const float radiance = radianceAt(180.0f - behind, elevation);
            room.rgba.insert(room.rgba.end(), {radiance, radiance, radiance, 1.0f});
        }
    }
    return room;
}

}  // namespace gp::tool
