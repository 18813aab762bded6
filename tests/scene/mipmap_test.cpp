// Chains of smaller copies against a plain computation in double precision.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "scene/mipmap.h"

using namespace gp;

namespace {

Image randomImage(uint32_t width, uint32_t height, PixelFormat format) {
    Image image;
    image.width = width;
    image.height = height;
    image.format = format;
    image.pixels.resize(size_t(width) * height * bytesPerPixel(format));
    std::mt19937 random(width * 31 + height);
    for (size_t i = 0; i < size_t(width) * height * 4; ++i) {
        if (format == PixelFormat::rgba8) image.bytes()[i] = uint8_t(random());
        else image.floats()[i] = float(random() % 1000) / 100.0f;
    }
    return image;
}

std::shared_ptr<const Texture> textureOf(const Image& image, ColorSpace space) {
    TextureDesc desc;
    desc.image = image;
    desc.colorSpace = space;
    return makeTexture(std::move(desc));
}

double decode(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double encode(double v) {
    return v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double value(const Texture& t, size_t level, uint32_t x, uint32_t y, size_t c) {
    const size_t i = (size_t(y) * t.levels[level].width + x) * 4 + c;
    const std::byte* p = t.pixels.data() + t.levels[level].offset;
    return t.format == PixelFormat::rgba8 ? double(reinterpret_cast<const uint8_t*>(p)[i]) / 255
                                          : double(reinterpret_cast<const float*>(p)[i]);
}

// The mean over the area that texel (x, y) of a level covers in the level before, by overlap.
double areaMean(const Texture& t, size_t level, uint32_t x, uint32_t y, size_t c, bool srgb) {
    const MipLevel& from = t.levels[level - 1];
    const MipLevel& to = t.levels[level];
    const double sx = double(from.width) / to.width, sy = double(from.height) / to.height;
    double sum = 0;
    for (uint32_t j = 0; j < from.height; ++j)
        for (uint32_t i = 0; i < from.width; ++i) {
            const double wx = std::min((x + 1) * sx, i + 1.0) - std::max(x * sx, double(i));
            const double wy = std::min((y + 1) * sy, j + 1.0) - std::max(y * sy, double(j));
            if (wx <= 0 || wy <= 0) continue;
            const double v = value(t, level - 1, i, j, c);
            sum += wx * wy * (srgb && c < 3 ? decode(v) : v);
        }
    sum /= sx * sy;
    return srgb && c < 3 ? encode(sum) : sum;
}

void expectMeans(const Texture& t, bool srgb, double tolerance) {
    for (size_t level = 1; level < t.levels.size(); ++level)
        for (uint32_t y = 0; y < t.levels[level].height; ++y)
            for (uint32_t x = 0; x < t.levels[level].width; ++x)
                for (size_t c = 0; c < 4; ++c)
                    ASSERT_NEAR(value(t, level, x, y, c), areaMean(t, level, x, y, c, srgb),
                                tolerance)
                        << "level " << level << " at " << x << ", " << y << " channel " << c;
}

}  // namespace

TEST(Mipmap, IsTheMeanInLinearLightForAnySize) {
    constexpr uint32_t sizes[][2] = {{16, 16}, {64, 8}, {1, 16}, {17, 13},
                                     {7, 1},   {30, 6}, {5, 12}};
    for (const auto& s : sizes) {
        SCOPED_TRACE(testing::Message() << s[0] << " x " << s[1]);
        const Image bytes = randomImage(s[0], s[1], PixelFormat::rgba8);
        // Half a byte of rounding, and a little for the 16-bit tables.
        expectMeans(*textureOf(bytes, ColorSpace::srgb), true, 0.52 / 255);
        expectMeans(*textureOf(bytes, ColorSpace::linear), false, 0.51 / 255);
        expectMeans(*textureOf(randomImage(s[0], s[1], PixelFormat::rgba32f), ColorSpace::linear),
                    false, 1e-4);
    }
}

TEST(Mipmap, EndsAtOneTexel) {
    const auto t = textureOf(randomImage(300, 5, PixelFormat::rgba8), ColorSpace::srgb);
    ASSERT_EQ(t->levels.size(), 9u);  // 300 150 75 37 18 9 4 2 1
    EXPECT_EQ(t->levels[3].width, 37u);
    EXPECT_EQ(t->levels[3].height, 1u);
    EXPECT_EQ(t->levels.back().offset + 4, t->pixels.size());
}

TEST(Mipmap, BlackAndWhiteMeetAtHalfTheLight) {
    Image image = randomImage(2, 1, PixelFormat::rgba8);
    for (int c = 0; c < 4; ++c) {
        image.bytes()[c] = 0;
        image.bytes()[4 + c] = 255;
    }
    const auto srgb = textureOf(image, ColorSpace::srgb);
    EXPECT_EQ(std::to_integer<int>(srgb->pixels[8]), 188);   // 0.5 in linear light
    EXPECT_EQ(std::to_integer<int>(srgb->pixels[11]), 128);  // alpha is linear
}

TEST(Texture, KnowsItsAlphaAndDecodesEncodedFloats) {
    Image image = randomImage(4, 4, PixelFormat::rgba8);
    for (size_t i = 3; i < image.pixels.size(); i += 4) image.bytes()[i] = 255;
    EXPECT_FALSE(textureOf(image, ColorSpace::srgb)->hasAlpha);
    image.bytes()[7] = 254;
    EXPECT_TRUE(textureOf(image, ColorSpace::srgb)->hasAlpha);

    Image wide = randomImage(1, 1, PixelFormat::rgba32f);
    for (int c = 0; c < 4; ++c) wide.floats()[c] = 0.5f;
    const auto t = textureOf(wide, ColorSpace::srgb);
    EXPECT_EQ(t->colorSpace, ColorSpace::linear);
    EXPECT_NEAR(value(*t, 0, 0, 0, 0), 0.21404, 1e-5);
    EXPECT_EQ(value(*t, 0, 0, 0, 3), 0.5);
}

TEST(Texture, WithoutChainHasOneLevel) {
    TextureDesc desc;
    desc.image = randomImage(8, 8, PixelFormat::rgba8);
    desc.mipmapped = false;
    const auto t = makeTexture(std::move(desc));
    EXPECT_EQ(t->levels.size(), 1u);
    EXPECT_EQ(t->pixels.size(), 256u);
}
