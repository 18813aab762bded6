#include "scene/slope_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include "scene/mipmap.h"
#include "scene/texel_decoder.h"

#include "shading/lang.h"
GP_SHADING_BEGIN
#include "shading/slope/lean.glsl"
GP_SHADING_END

namespace gp {
namespace {

using shading::Slopes;

// Moments of one level at full precision: levels are made from each other, and rounding each to
// halves before the next would add up.
struct Level {
    uint32_t width, height;
    LargeVector<Slopes> texels;
};

// The exact mean over the share of the source texels that each target texel covers, odd sizes
// included.
Level halved(const Level& source) {
    Level target{std::max(source.width / 2, 1u), std::max(source.height / 2, 1u), {}};
    target.texels.resize(size_t(target.width) * target.height);
    tbb::parallel_for(0u, target.height, [&](uint32_t y) {
        const BoxTaps ty = boxTaps(y, source.height, target.height);
        for (uint32_t x = 0; x < target.width; ++x) {
            const BoxTaps tx = boxTaps(x, source.width, target.width);
            Slopes sum = shading::slopes_constant(glm::vec2(0));
            float weight = 0;
            for (uint32_t j = 0; j < ty.count; ++j)
                for (uint32_t i = 0; i < tx.count; ++i) {
                    const float w = ty.weight[j] * tx.weight[i];
                    weight += w;
                    const size_t at = size_t(ty.first + j) * source.width + tx.first + i;
                    sum = shading::slopes_mixed(sum, source.texels[at], w / weight);
                }
            target.texels[size_t(y) * target.width + x] = sum;
        }
    });
    return target;
}

void appendLevel(SlopeMap& map, const Level& level) {
    const size_t first = map.texels.size();
    map.levels.push_back({level.width, level.height, first});
    map.texels.resize(first + level.texels.size());
    for (size_t i = 0; i < level.texels.size(); ++i)
        map.texels[first + i] =
            std::bit_cast<PackedSlopes>(shading::slope_texel_encode(level.texels[i]));
}

SlopeMap chainOf(Level level, Wrap wrapU, Wrap wrapV) {
    SlopeMap map;
    map.wrapU = wrapU, map.wrapV = wrapV;
    map.texels.reserve(level.texels.size() + level.texels.size() / 2 + 64);
    for (;;) {
        appendLevel(map, level);
        if (level.width == 1 && level.height == 1) return map;
        level = halved(level);
    }
}

// The offsets of a grid, fetched once, on metres and wrapped.
class Surface {
public:
    explicit Surface(const DisplacementGrid& g)
        : grid_(g), texel_(g.extent / glm::vec2(g.width, g.height)),
          offsets_(size_t(g.width) * g.height) {
        tbb::parallel_for(0u, g.height, [&](uint32_t y) {
            for (uint32_t x = 0; x < g.width; ++x) offsets_[size_t(y) * g.width + x] =
                g.offset(x, y);
        });
    }

    // Over texel (x, y): four quarters of the bilinear patches around it. Two points of Gauss and
    // Legendre an axis are exact for the first two moments of what is linear, as slopes of a
    // bilinear height field are.
    Slopes texel(int x, int y) const {
        Slopes sum = shading::slopes_constant(glm::vec2(0));
        int count = 0;
        for (int j = -1; j <= 0; ++j)
            for (int i = -1; i <= 0; ++i) {
                const Patch patch = patchAt(x + i, y + j);
                for (int k = 0; k < 4; ++k) {
                    const glm::vec2 in(0.25f + 0.1443376f * (k % 2 == 0 ? -1.0f : 1.0f),
                                       0.25f + 0.1443376f * (k < 2 ? -1.0f : 1.0f));
                    const glm::vec2 f = in + 0.5f * glm::vec2(-i, -j);
                    sum = shading::slopes_mixed(sum, shading::slopes_constant(slopeAt(patch, f)),
                                                1.0f / float(++count));
                }
            }
        return sum;
    }

private:
    struct Patch {
        glm::vec3 corner[2][2];  // [y][x], v grows downwards
    };

    Patch patchAt(int x, int y) const {
        Patch p;
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const int cx = shading::wrapped_texel(x + i, int(grid_.width), uint(grid_.wrapU));
                const int cy = shading::wrapped_texel(y + j, int(grid_.height), uint(grid_.wrapV));
                p.corner[j][i] = offsets_[size_t(cy) * grid_.width + size_t(cx)];
            }
        return p;
    }

    // J^T s = grad h for the map x -> x + D(x). [Horvath 2015, "Empirical directional wave spectra
    // for computer graphics", section 6; the whole inverse, not its diagonal]
    glm::vec2 slopeAt(const Patch& p, glm::vec2 f) const {
        const glm::vec3 du = glm::mix(p.corner[0][1] - p.corner[0][0],
                                      p.corner[1][1] - p.corner[1][0], f.y) / texel_.x;
        const glm::vec3 dv = glm::mix(p.corner[0][0] - p.corner[1][0],
                                      p.corner[0][1] - p.corner[1][1], f.x) / texel_.y;
        const float xx = 1 + du.x, yx = du.y, xy = dv.x, yy = 1 + dv.y;
        const float det = std::max(xx * yy - xy * yx, 0.05f);  // beyond, the surface folds
        return shading::slope_from_texel(
            {-(yy * du.z - yx * dv.z) / det, -(xx * dv.z - xy * du.z) / det, 1});
    }

    const DisplacementGrid& grid_;
    glm::vec2 texel_;  // metres
    LargeVector<glm::vec3> offsets_;
};

}  // namespace

SlopeMap slopeMapFromNormals(const Texture& normals) {
    const MipLevel& image = normals.levels[0];
    const TexelDecoder decoder(normals);
    Level level{image.width, image.height, {}};
    level.texels.resize(size_t(image.width) * image.height);
    tbb::parallel_for(0u, image.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < image.width; ++x) {
            const size_t i = size_t(y) * image.width + x;
            const glm::vec3 n = decoder.at(image, i) * 2.0f - 1.0f;
            level.texels[i] = shading::slopes_constant(shading::slope_from_texel(n));
        }
    });
    return chainOf(std::move(level), normals.wrapU, normals.wrapV);
}

SlopeMap slopeMapFromDisplacement(const DisplacementGrid& grid) {
    if (grid.width == 0 || grid.height == 0)
        throw std::invalid_argument("slope map: the grid is empty");
    if (!(grid.extent.x > 0 && grid.extent.y > 0))
        throw std::invalid_argument("slope map: the extent must be above 0");
    if (grid.wrapU == Wrap::mirroredRepeat || grid.wrapV == Wrap::mirroredRepeat)
        throw std::invalid_argument("slope map: mirrored wraps are not supported");
    const Surface surface(grid);
    Level level{grid.width, grid.height, {}};
    level.texels.resize(size_t(grid.width) * grid.height);
    tbb::parallel_for(0u, grid.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < grid.width; ++x)
            level.texels[size_t(y) * grid.width + x] = surface.texel(int(x), int(y));
    });
    SlopeMap map = chainOf(std::move(level), grid.wrapU, grid.wrapV);
    map.rise = grid.extent;
    return map;
}

static DisplacementGrid gridOf(const Texture& image, glm::vec2 extent) {
    DisplacementGrid grid;
    grid.width = image.levels[0].width, grid.height = image.levels[0].height;
    grid.extent = extent;
    grid.wrapU = image.wrapU, grid.wrapV = image.wrapV;
    return grid;
}

SlopeMap slopeMapFromHeights(const Texture& heights) {
    const MipLevel& image = heights.levels[0];
    const TexelDecoder decoder(heights);
    float lowest = std::numeric_limits<float>::max(), highest = -lowest;
    for (size_t i = 0; i < size_t(image.width) * image.height; ++i) {
        const float h = decoder.at(image, i).x;
        if (std::isfinite(h)) lowest = std::min(lowest, h), highest = std::max(highest, h);
    }
    const float range = highest - lowest;
    const float unit = range > 0 && std::isfinite(range) ? range : 1.0f;
    // In texels, and heights of one unit.
    DisplacementGrid grid = gridOf(heights, glm::vec2(image.width, image.height));
    grid.offset = [&](uint32_t x, uint32_t y) {
        const float h = decoder.at(image, size_t(y) * image.width + x).x;
        return glm::vec3(0, 0, (h - lowest) / unit);
    };
    SlopeMap map = slopeMapFromDisplacement(grid);
    map.rise *= unit;
    return map;
}

SlopeMap slopeMapFromOffsets(const Texture& offsets, float scale, glm::vec2 extent) {
    const TexelDecoder decoder(offsets);
    DisplacementGrid grid = gridOf(offsets, extent);
    grid.offset = [&](uint32_t x, uint32_t y) {
        return decoder.at(offsets.levels[0], size_t(y) * grid.width + x) * scale;
    };
    return slopeMapFromDisplacement(grid);
}

}  // namespace gp
