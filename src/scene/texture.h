// A texture: an image, how to read it, and its chain of smaller copies.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/image.h"
#include "scene/large_pages.h"

namespace gp {

enum class Wrap : uint8_t { repeat, clampToEdge, mirroredRepeat };
enum class Filter : uint8_t { linear, nearest };
enum class ColorSpace : uint8_t { linear, srgb };  // srgb: RGB decoded on reading, alpha is linear

struct MipLevel {
    uint32_t width = 0, height = 0;
    size_t offset = 0;  // in bytes, into Texture::pixels
};

// Shared between materials and scenes. Size, format and how it is read stay; only updateTexture
// changes the pixels.
struct Texture {
    std::string name;
    PixelFormat format = PixelFormat::rgba8;
    ColorSpace colorSpace = ColorSpace::srgb;
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    Filter magFilter = Filter::linear, minFilter = Filter::linear;
    bool mipmapped = true;
    uint64_t revision = 0;         // grows with every change of the pixels
    bool hasAlpha = false;         // some texel's alpha is below one
    std::vector<MipLevel> levels;  // level 0 is the image itself
    LargeVector<std::byte> pixels; // all levels, level 0 first
};

struct TextureDesc {
    std::string name;
    Image image;
    ColorSpace colorSpace = ColorSpace::srgb;
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    Filter magFilter = Filter::linear, minFilter = Filter::linear;
    bool mipmapped = true;
};

// Takes the pixels and builds the chain (box filter in linear light, down to 1x1).
std::shared_ptr<Texture> makeTexture(TextureDesc&& desc);

// New pixels in a rectangle of level 0, which must lie inside, and in every level below it. `rows`
// are of the texture's format, `stride` bytes apart.
struct TexelRect {
    uint32_t x = 0, y = 0, width = 0, height = 0;
};
void updateTexture(Texture& texture, const TexelRect& rect, const std::byte* rows, size_t stride);

// A texture as a material uses it: which set of coordinates, moved by uv' = uvTransform * (u, v,
// 1).
struct TextureUse {
    std::shared_ptr<const Texture> texture;  // null: none
    uint32_t texCoord = 0;                   // 0 or 1
    glm::mat3x2 uvTransform{1, 0, 0, 1, 0, 0};
};

}  // namespace gp
