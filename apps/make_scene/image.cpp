#include "image.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <cmath>
#include <stdexcept>

namespace gp::make_scene {
namespace {

// [IEC 61966-2-1:1999], the sRGB transfer function and its inverse
float encodeSrgb(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear
                                : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}
float decodeSrgb(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f
                               : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t toByte(float value)
{
    return static_cast<std::uint8_t>(glm::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

Image makeImage(int width, int height, int channels)
{
    Image image{width, height, channels, {}};
    image.pixels.reserve(static_cast<std::size_t>(width * height * channels));
    return image;
}

void addColor(Image& image, glm::vec3 linear)
{
    for (int c = 0; c < 3; ++c)
        image.pixels.push_back(toByte(encodeSrgb(glm::clamp(linear[c], 0.0f, 1.0f))));
}

Image normalsFromHeights(const std::vector<Texel>& texels, glm::ivec2 size, glm::vec2 metres)
{
    Image image = makeImage(size.x, size.y, 3);
    const auto height = [&](int x, int y) {
        const int wrapped = ((y + size.y) % size.y) * size.x + (x + size.x) % size.x;
        return texels[static_cast<std::size_t>(wrapped)].height;
    };
    const glm::vec2 twoTexels = 2.0f * metres / glm::vec2(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const float du = (height(x + 1, y) - height(x - 1, y)) / twoTexels.x;
            const float dv = (height(x, y + 1) - height(x, y - 1)) / twoTexels.y;
            // glTF's green points up the picture, against v: hence the one plus sign.
            const glm::vec3 n = glm::normalize(glm::vec3(-du, dv, 1.0f));
            for (int c = 0; c < 3; ++c)
                image.pixels.push_back(toByte(n[c] * 0.5f + 0.5f));
        }
    return image;
}

}  // namespace

std::vector<std::uint8_t> encodePng(const Image& image)
{
    std::vector<std::uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<std::uint8_t>*>(context);
        const auto* begin = static_cast<const std::uint8_t*>(data);
        out.insert(out.end(), begin, begin + size);
    };
    if (stbi_write_png_to_func(append, &bytes, image.width, image.height, image.channels,
                               image.pixels.data(), image.width * image.channels) == 0)
        throw std::runtime_error("a texture could not be encoded as PNG (out of memory?)");
    return bytes;
}

MaterialImages bake(const BakeOptions& options, const TexelFunction& texel)
{
    const glm::ivec2 size = options.size;
    std::vector<Texel> texels;
    texels.reserve(static_cast<std::size_t>(size.x * size.y));
    MaterialImages maps;
    maps.color = makeImage(size.x, size.y, options.alpha ? 4 : 3);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(size);
            texels.push_back(texel(uv));
            addColor(maps.color, texels.back().color);
            if (options.alpha)
                maps.color.pixels.push_back(toByte(texels.back().alpha));
        }
    maps.normal = normalsFromHeights(texels, size, options.metres);
    maps.metallicRoughness = makeImage(size.x / 2, size.y / 2, 3);
    for (int y = 0; y < size.y / 2; ++y)
        for (int x = 0; x < size.x / 2; ++x) {
            const Texel& t = texels[static_cast<std::size_t>(2 * y * size.x + 2 * x)];
            maps.metallicRoughness.pixels.insert(
                maps.metallicRoughness.pixels.end(),
                {std::uint8_t{255}, toByte(t.roughness), toByte(t.metallic)});
        }
    return maps;
}

Image bakeColor(glm::ivec2 size, const std::function<glm::vec3(glm::vec2)>& color)
{
    Image image = makeImage(size.x, size.y, 3);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            addColor(image, color((glm::vec2(x, y) + 0.5f) / glm::vec2(size)));
    return image;
}

Image bakeNumbers(glm::ivec2 size, const std::function<glm::vec3(glm::vec2)>& numbers)
{
    Image image = makeImage(size.x, size.y, 3);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::vec3 value = numbers((glm::vec2(x, y) + 0.5f) / glm::vec2(size));
            for (int c = 0; c < 3; ++c)
                image.pixels.push_back(toByte(value[c]));
        }
    return image;
}

glm::vec3 srgb(std::uint32_t hex)
{
    const auto channel = [hex](unsigned shift) {
        return decodeSrgb(static_cast<float>((hex >> shift) & 255u) / 255.0f);
    };
    return glm::vec3(channel(16), channel(8), channel(0));
}

}  // namespace gp::make_scene
