// The pieces of the corridor. UVs of stone and wood are in repeats of their textures already.
#pragma once

#include "glb.h"

namespace gp::make_scene {

// The corridor runs along -Z; its section is a half circle on two walls.
constexpr float corridorHalfWidth = 1.5f;   // metres
constexpr float corridorSpring = 2.0f;      // height at which the vault begins

// Two piers and the arch between them, of single stones, in the plane z = 0.
Mesh stoneRib(std::uint32_t seed);

// Fixed to a wall at the origin whose normal is +X.
struct Torch {
    Mesh iron, shaft, flame;
};
Torch torch(std::uint32_t seed);

// A door in a stone frame against a wall at x = 0 whose normal is +X; opens on the floor y = 0.
struct Door {
    Mesh planks, iron, frame;
};
Door door(std::uint32_t seed);

struct Barrel {
    Mesh staves, hoops;
};
Barrel barrel();
Mesh crate();

Image flameGradient();         // emission; v from the root of the flame to its tip
MaterialImages puddleImages();  // blended: the alpha fades towards an uneven shore
MaterialImages grateImages();   // masked: forged bars, 4 x 5 fields

}  // namespace gp::make_scene
