#include "scene/texture.h"

#include "scene/mipmap.h"

namespace gp {

namespace {

bool someAlphaBelowOne(const Image& image) {
    const size_t texels = size_t(image.width) * image.height;
    if (image.format == PixelFormat::rgba32f) {
        for (size_t i = 0; i < texels; ++i)
            if (image.floats()[i * 4 + 3] < 1) return true;
        return false;
    }
    for (size_t i = 0; i < texels; ++i)
        if (image.bytes()[i * 4 + 3] != 255) return true;
    return false;
}

// Encoded floats (16-bit PNG) are decoded once, here: rgba32f textures always hold linear light.
void decodeFloats(Image& image) {
    for (size_t i = 0; i < size_t(image.width) * image.height; ++i)
        for (size_t c = 0; c < 3; ++c)
            image.floats()[i * 4 + c] = linearFromSrgb(image.floats()[i * 4 + c]);
}

}  // namespace

std::shared_ptr<const Texture> makeTexture(TextureDesc&& desc) {
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
    texture->hasAlpha = someAlphaBelowOne(desc.image);
    size_t bytes = 0;
    texture->levels = mipLayout(desc.image.width, desc.image.height, desc.image.format,
                                desc.mipmapped, bytes);
    texture->pixels.resize(bytes);
    std::copy(desc.image.pixels.begin(), desc.image.pixels.end(), texture->pixels.begin());
    desc.image.pixels = {};
    fillMipLevels(*texture);
    return texture;
}

}  // namespace gp
