// A texture with new pixels in a rectangle is the texture of the whole new picture, all levels.
#include <random>

#include <gtest/gtest.h>

#include "scene/texture.h"

namespace gp {
namespace {

class TextureUpdate : public ::testing::Test {
protected:
    Image picture(uint32_t width, uint32_t height, PixelFormat format) {
        Image image;
        image.width = width, image.height = height, image.format = format;
        image.pixels.resize(size_t(width) * height * bytesPerPixel(format));
        for (size_t i = 0; i < size_t(width) * height * 4; ++i)
            if (format == PixelFormat::rgba8)
                image.bytes()[i] = uint8_t(i % 4 == 3 ? 255 : random() >> 24);
            else
                image.floats()[i] = i % 4 == 3 ? 1.0f : float(random() >> 20);
        return image;
    }
    static std::shared_ptr<Texture> textureOf(const Image& image) {
        TextureDesc desc;
        desc.image = image;
        if (image.format == PixelFormat::rgba32f) desc.colorSpace = ColorSpace::linear;
        return makeTexture(std::move(desc));
    }
    uint32_t below(uint32_t n) { return uint32_t(random()) % n; }
    std::mt19937 random{3};
};

TEST_F(TextureUpdate, AnyRectangleOfAnySize) {
    for (int round = 0; round < 300; ++round) {
        const auto format = round % 2 ? PixelFormat::rgba8 : PixelFormat::rgba32f;
        const uint32_t width = 1 + below(40), height = 1 + below(40);
        Image image = picture(width, height, format);
        const auto texture = textureOf(image);
        TexelRect rect;
        rect.x = below(width), rect.y = below(height);
        rect.width = 1 + below(width - rect.x), rect.height = 1 + below(height - rect.y);
        const Image patch = picture(rect.width + 3, rect.height, format);
        const size_t texel = bytesPerPixel(format), stride = texel * patch.width;
        for (size_t y = 0; y < rect.height; ++y)
            std::copy_n(&patch.pixels[y * stride], rect.width * texel,
                        &image.pixels[((rect.y + y) * width + rect.x) * texel]);
        updateTexture(*texture, rect, patch.pixels.data(), stride);
        ASSERT_TRUE(texture->pixels == textureOf(image)->pixels)
            << width << " x " << height << ": " << rect.width << " x " << rect.height << " at "
            << rect.x << ", " << rect.y;
    }
}

TEST_F(TextureUpdate, KnowsWhetherThereIsAlpha) {
    const auto texture = textureOf(picture(4, 4, PixelFormat::rgba8));
    EXPECT_FALSE(texture->hasAlpha);
    const std::byte thin[4] = {}, solid[4] = {std::byte(9), std::byte(9), std::byte(9),
                                              std::byte(255)};
    updateTexture(*texture, {1, 1, 1, 1}, thin, 4);
    updateTexture(*texture, {2, 3, 1, 1}, thin, 4);
    EXPECT_TRUE(texture->hasAlpha);
    updateTexture(*texture, {1, 1, 1, 1}, solid, 4);
    EXPECT_TRUE(texture->hasAlpha);
    updateTexture(*texture, {2, 3, 1, 1}, solid, 4);
    EXPECT_FALSE(texture->hasAlpha);
}

}  // namespace
}  // namespace gp
