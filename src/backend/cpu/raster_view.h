// Rasterised geometry as the hot code sees it: plain data, as in scene_view.h.
#pragma once

#include "backend/cpu/scene_view.h"

namespace gp::cpu {

// Pixels are cut into 256 parts on each side: positions on this grid are exact, and so is what
// covers a pixel. [Direct3D 11.3 functional specification, "Coordinate Snapping"]
constexpr int64_t subPixels = 256;

// What is interpolated, over the centres of pixels: at + dx x + dy y. Double: a floor that runs
// under the camera has vertices whose values are 10^4 times those at its other end.
struct RasterPlane {
    double at, dx, dy;
};

// One triangle. A pixel (x, y) is covered where edge + dx x + dy y >= 0 for all three edges.
struct RasterTriangle {
    int64_t edge[3], edgeX[3], edgeY[3];
    RasterPlane inverseW, depth, u, v;  // the others are divided by w, too
    RasterPlane color[4];
    uint32_t y0, y1;                    // rows that it may touch
    uint32_t draw;                      // index into RasterBand::draws
    uint8_t parallel;                   // w is 1 everywhere
    uint8_t oneColor;                   // color[].at alone counts
};

// State of one draw.
struct RasterDraw {
    TextureView texture;
    uint8_t textured;
    uint8_t encodeTexels;        // linear texels into a display: sRGB-encoded first
    uint8_t blend, depthWrite;
    uint32_t blendSource, blendDestination, blendSourceAlpha, blendDestinationAlpha;
    uint32_t depthTest;          // of shading/blending.glsl
    float alphaThreshold;
    float color[4];
    uint32_t x0, x1;             // columns that may be drawn to
};

// One run of whole rows.
struct RasterBand {
    const RasterDraw* draws;
    const RasterTriangle* triangles;
    const uint32_t* indices;     // of the triangles that touch the band, in their order
    size_t count;
    uint32_t y0, y1;             // rows
    uint32_t width;              // of the images
    glm::vec4* color;            // of color and display one is there
    glm::u8vec4* display;
    float* depth;                // or null
};

// Apart from the path tracer, as LocalKernels are.
struct RasterKernels {
    void (*drawBand)(const RasterBand& band);
    void (*tonemapColors)(const glm::vec4* colors, glm::u8vec4* display, size_t count,
                          float exposureEv, uint32_t tonemap);
    // Bilinear, one level: the fast way and the plain one, for the test that compares them.
    void (*sampleRow)(const TextureView& texture, uint32_t level, const float* u, const float* v,
                      size_t count, bool fast, glm::vec4* texels);
};

}  // namespace gp::cpu
