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

}  // namespace gp::cpu
