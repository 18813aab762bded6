// Pictures of 8 bits a channel, made from functions over the unit square.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace gp::make_scene {

struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;  // 1 to 4, as PNG counts them
    std::vector<std::uint8_t> pixels;
};

std::vector<std::uint8_t> encodePng(const Image& image);

// What a material is at one point. Colours are linear Rec. 709.
struct Texel {
    glm::vec3 color = glm::vec3(0.5f);
    float alpha = 1.0f;
    float height = 0.0f;  // metres
    float roughness = 0.5f;
    float metallic = 0.0f;
};
using TexelFunction = std::function<Texel(glm::vec2 uv)>;

// The three textures of a glTF metallic-roughness material. Texture row 0 is v = 0.
struct MaterialImages {
    Image color;              // sRGB; with alpha when the bake asked for it
    Image normal;             // tangent space, from the height
    Image metallicRoughness;  // half the resolution: it varies slowly and weighs little
};
struct BakeOptions {
    glm::ivec2 size = glm::ivec2(512);     // pixels
    glm::vec2 metres = glm::vec2(1.0f);    // extent that one repeat has in the scene
    bool alpha = false;
};
MaterialImages bake(const BakeOptions& options, const TexelFunction& texel);

// A colour picture alone, sRGB; and one of numbers, stored as they are.
Image bakeColor(glm::ivec2 size, const std::function<glm::vec3(glm::vec2)>& color);
Image bakeNumbers(glm::ivec2 size, const std::function<glm::vec3(glm::vec2)>& numbers);

// The linear colour of an sRGB triple as people write it, 0xRRGGBB.
glm::vec3 srgb(std::uint32_t hex);

}  // namespace gp::make_scene
