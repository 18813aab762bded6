// What the surfaces of our scenes are made of, as functions over one repeat of a texture.
// All of them tile. The comment states the extent in metres that they are drawn for.
#pragma once

#include "image.h"

#include <cstdint>

namespace gp::make_scene {

struct WoodColors {
    glm::vec3 early = glm::vec3(0.5f);  // the pale part of a ring
    glm::vec3 late = glm::vec3(0.2f);   // the dark one
    float roughness = 0.5f;
};
TexelFunction wood(WoodColors colors, std::uint32_t seed);  // 1.2 x 0.4, grain along u

// Rows of hewn blocks, each row offset against the next, mortar between; 2 x 2.
TexelFunction stoneBlocks(glm::vec3 color, int rows, int columns, std::uint32_t seed);
TexelFunction flagstones(glm::vec3 color, int rows, int columns, std::uint32_t seed);  // 2 x 2
TexelFunction plaster(glm::vec3 color, std::uint32_t seed);                            // 2 x 2
TexelFunction weave(glm::vec3 color, int threads, std::uint32_t seed);  // 0.05 x 0.05
TexelFunction leather(glm::vec3 color, std::uint32_t seed);             // 0.1 x 0.1
TexelFunction foliage(glm::vec3 color, std::uint32_t seed);             // any; grass from afar

// Fruit skins: u around, v from the flower (0) to the stem (1).
TexelFunction appleSkin(glm::vec3 blush, glm::vec3 ground, std::uint32_t seed);
TexelFunction citrusSkin(glm::vec3 color, float dimples, std::uint32_t seed);
TexelFunction pearSkin(std::uint32_t seed);

// Leaves on a twig for alpha-masked cards; the twig along v.
TexelFunction ivy(std::uint32_t seed);

}  // namespace gp::make_scene
