#include "scene/texture.h"

#include <algorithm>

#include "scene/mipmap.h"

namespace gp {

namespace {

bool someAlphaBelowOne(const std::byte* pixels, PixelFormat format, size_t texels) {
    if (format == PixelFormat::rgba32f) {
        const auto* floats = reinterpret_cast<const float*>(pixels);
        for (size_t i = 0; i < texels; ++i)
            if (floats[i * 4 + 3] < 1) return true;
        return false;
    }
    for (size_t i = 0; i < texels; ++i)
        if (pixels[i * 4 + 3] != std::byte(255)) return true;
    return false;
}

// Encoded floats (16-bit PNG) are decoded once, here: rgba32f textures always hold linear light.
void decodeFloats(Image& image) {
    for (size_t i = 0; i < size_t(image.width) * image.height; ++i)
        for (size_t c = 0; c < 3; ++c)
            image.floats()[i * 4 + c] = linearFromSrgb(image.floats()[i * 4 + c]);
}

}  // namespace

std::shared_ptr<Texture> makeTexture(TextureDesc&& desc) {
    auto texture = std::make_shared<Texture>();
    texture->name = std::move(desc.name);
    texture->format = desc.image.format;
    texture->colorSpace = desc.colorSpace;
    if (desc.image.format == PixelFormat::rgba32f && desc.colorSpace == ColorSpace::srgb) {
        decodeFloats(desc.image);
        texture->colorSpace = ColorSpace::linear;
    }
    texture->wrapU = desc.wrapU;
    texture->wrapV = desc.wrapV;
    texture->magFilter = desc.magFilter;
    texture->minFilter = desc.minFilter;
    texture->mipmapped = desc.mipmapped;
    texture->hasAlpha = someAlphaBelowOne(desc.image.pixels.data(), desc.image.format,
                                          size_t(desc.image.width) * desc.image.height);
    size_t bytes = 0;
    texture->levels = mipLayout(desc.image.width, desc.image.height, desc.image.format,
                                desc.mipmapped, bytes);
    texture->pixels.resize(bytes);
    std::copy(desc.image.pixels.begin(), desc.image.pixels.end(), texture->pixels.begin());
    desc.image.pixels = {};
    fillMipLevels(*texture, {0, 0, desc.image.width, desc.image.height});
    return texture;
}

void updateTexture(Texture& texture, const TexelRect& rect, const std::byte* rows, size_t stride) {
    const size_t texel = bytesPerPixel(texture.format), packed = texel * rect.width;
    const size_t width = texture.levels[0].width, height = texture.levels[0].height;
    std::byte* target = texture.pixels.data() + (rect.y * width + rect.x) * texel;
    bool some = false;
    for (size_t y = 0; y < rect.height; ++y) {
        std::byte* row = target + y * width * texel;
        std::copy_n(rows + y * stride, packed, row);
        some |= someAlphaBelowOne(row, texture.format, rect.width);
    }
    // Only where the rectangle may have held the last such texel all others are asked.
    texture.hasAlpha = some || (texture.hasAlpha && someAlphaBelowOne(texture.pixels.data(),
                                                                      texture.format,
                                                                      width * height));
    fillMipLevels(texture, rect);
    ++texture.revision;
}

}  // namespace gp
