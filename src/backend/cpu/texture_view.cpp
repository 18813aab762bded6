#include "backend/cpu/texture_view.h"

#include <algorithm>
#include <cmath>

namespace gp::cpu {

TextureView textureView(const Texture& t) {
    TextureView v{};
    v.width = t.levels[0].width, v.height = t.levels[0].height;
    v.levelCount = uint32_t(std::min<size_t>(t.levels.size(), std::size(v.levels)));
    for (size_t i = 0; i < std::size(v.levels); ++i)
        v.levels[i] = reinterpret_cast<const uint8_t*>(t.pixels.data()) +
                      t.levels[std::min<size_t>(i, v.levelCount - 1)].offset;
    v.halfLog2Texels = 0.5f * std::log2(float(v.width) * float(v.height));
    v.isFloat = t.format == PixelFormat::rgba32f, v.isSrgb = t.colorSpace == ColorSpace::srgb;
    v.wrapU = uint8_t(t.wrapU), v.wrapV = uint8_t(t.wrapV);
    v.magNearest = t.magFilter == Filter::nearest, v.minNearest = t.minFilter == Filter::nearest;
    return v;
}

SlopeMapView slopeMapView(const SlopeMap& map) {
    SlopeMapView v{};
    const size_t last = std::min(map.levels.size(), std::size(v.levels)) - 1;
    for (size_t i = 0; i < std::size(v.levels); ++i)
        v.levels[i] = map.texels.data() + map.levels[std::min(i, last)].offset;
    const bool clamped = map.wrapU == Wrap::clampToEdge || map.wrapV == Wrap::clampToEdge;
    v.size = {map.levels[0].width, map.levels[0].height, uint32_t(last + 1), clamped ? 0u : 1u};
    v.wrapU = uint8_t(map.wrapU), v.wrapV = uint8_t(map.wrapV);
    return v;
}

}  // namespace gp::cpu
