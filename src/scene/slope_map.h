// Images of slope moments: what a normal, height or displacement map does to reflections below a
// pixel. Each texel of each level holds the mean slope of its own area and the covariance about it,
// so that any footprint is a combination of few texels (shading/slope/lean.glsl, docs/water.md).
// Slopes are along +u and against v: x and y of a tangent-space normal map whose y points up.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/texture.h"

namespace gp {

// SlopeTexel of shading/slope/lean.glsl.
struct PackedSlopes {
    float meanX, meanY;
    uint32_t deviations;
    float correlation;
};

struct SlopeMap {
    // What a slope of 1 rises by from one edge of the image to the other, along u and v: the slopes
    // of a height map are those of its picture until a surface says how large that is. Zeros: they
    // are slopes of the surface itself, as a normal map's are.
    glm::vec2 rise{0};
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    std::vector<MipLevel> levels;      // offsets in texels; down to 1x1
    LargeVector<PackedSlopes> texels;  // all levels, level 0 first
};

// From a tangent-space normal map (rgb, y up). The slopes are those of its texels: a scale of the
// normals is one of the slopes, and is applied on reading (slopes_scaled).
SlopeMap slopeMapFromNormals(const Texture& normals);

// A surface as offsets of the points of a grid, metres: x along +u, y against v, z the height. It
// is bilinear between the centres of texels, and beyond the edges as `wrapU` and `wrapV` say.
struct DisplacementGrid {
    uint32_t width = 0, height = 0;    // at least 1
    glm::vec2 extent{1};               // of the whole image, metres; above 0
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    std::function<glm::vec3(uint32_t x, uint32_t y)> offset;  // called from several threads
};

// Moments of the slopes of such a surface over its texels: exact without offsets along x and y, by
// 16 points a texel with them. Areas count as on the undisplaced grid, which is what a texture
// coordinate is. Slopes of folded places are cut at SLOPE_LIMIT; what is not finite counts as flat.
// A height map has its heights in z alone. Throws std::invalid_argument for an empty grid, an
// extent that is not above zero, and mirrored wraps (slopes of mirror images change their sign,
// which no reader of a map does).
SlopeMap slopeMapFromDisplacement(const DisplacementGrid& grid);

// From the red channel of an image: heights of any unit, which is that of `rise`. Stored so that no
// slope is above 1, hence none is cut. Throws as slopeMapFromDisplacement does.
SlopeMap slopeMapFromHeights(const Texture& heights);

// From an image whose red, green and blue channels say how far a point goes along +u, against v and
// up, times `scale`; extent: of the whole image, in the unit of those lengths. Throws likewise.
SlopeMap slopeMapFromOffsets(const Texture& offsets, float scale, glm::vec2 extent);

}  // namespace gp
