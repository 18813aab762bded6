// Triangles against the planes that limit what can be drawn.
#pragma once

#include <array>
#include <cstddef>

#include <glm/glm.hpp>

namespace gp::cpu {

// A vertex on its way to the pixels, in double: matrices and positions may hold any finite float.
struct RasterVertex {
    double x, y, w;        // the pixel is (x / w, y / w)
    double depth;
    double near, far;      // negative: cut off
    double u, v;
    glm::dvec4 color;
};

// Each plane may add one corner to the three.
constexpr size_t clipPlanes = 7, mostCorners = 3 + clipPlanes;
struct ClippedPolygon {
    std::array<RasterVertex, mostCorners> corners;
    size_t count = 0;      // 0: nothing is left
};

// Pixels stay within this of the frame's corner: then edge functions fit into 64 bits.
constexpr double guardBand = 131072;
// Metres: nearer than this to the plane of the eye nothing is drawn.
constexpr double leastW = 1e-6;

ClippedPolygon clipTriangle(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c);

}  // namespace gp::cpu
