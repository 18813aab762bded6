// The furniture of the room; each piece stands on y = 0 around the origin. Wood has UVs in repeats
// of the wood texture already.
#pragma once

#include "glb.h"

#include <array>

namespace gp::make_scene {

Mesh diningTable();
Mesh chair();  // faces +Z
Mesh shelf();  // 1.2 x 2.0 x 0.3 m, its back at z = 0
constexpr std::size_t bookColors = 7;
std::array<Mesh, bookColors> shelfBooks(std::uint32_t seed);

struct FloorLamp {
    Mesh metal, shade, bulb;
};
FloorLamp floorLamp();

struct PottedPlant {
    Mesh pot, soil, leaves;
};
PottedPlant pottedPlant(std::uint32_t seed);

Mesh curtain(float width, float height, std::uint32_t seed);  // hangs down from y = 0
Image rugPattern();
Image landscapePainting();

// Stretches UVs in metres over the 1.2 x 0.4 m of the wood texture.
void grainUv(Mesh& mesh, glm::vec2 offset);

}  // namespace gp::make_scene
