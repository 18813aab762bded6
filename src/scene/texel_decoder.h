// The texels of a texture as linear colours, for what is made from them when a scene is committed.
// (Kernels read textures by backend/cpu/texture_sampling.h.)
#pragma once

#include <glm/glm.hpp>

#include "scene/mipmap.h"
#include "scene/texture.h"

namespace gp {

// The texture must live as long.
class TexelDecoder {
public:
    explicit TexelDecoder(const Texture& texture) : texture_(texture) {
        const bool srgb = texture.colorSpace == ColorSpace::srgb;
        for (int i = 0; i < 256; ++i)
            values_[i] = srgb ? linearFromSrgb(float(i) / 255) : float(i) / 255;
    }

    // Texel i of a level, row after row.
    glm::vec3 at(const MipLevel& level, size_t i) const {
        const std::byte* pixels = texture_.pixels.data() + level.offset;
        if (texture_.format == PixelFormat::rgba32f) {
            const auto* p = reinterpret_cast<const float*>(pixels) + 4 * i;
            return {p[0], p[1], p[2]};
        }
        const auto* p = reinterpret_cast<const uint8_t*>(pixels) + 4 * i;
        return {values_[p[0]], values_[p[1]], values_[p[2]]};
    }

private:
    const Texture& texture_;
    float values_[256];  // of one 8-bit channel
};

}  // namespace gp
