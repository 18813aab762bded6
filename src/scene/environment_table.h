// What rays need of an environment image: its radiance in few bytes, and a table that directions
// are chosen from in proportion to luminance and solid angle.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/image.h"
#include "shared/scene_structs.h"

namespace gp {

struct EnvironmentTable {
    // The image, three mantissas of 9 bits and an exponent each: 4 bytes instead of 16, rounded to
    // a part in 1,000 of a pixel's largest channel (Radiance files have a part in 256). Rays read
    // it at random, and what counts is how much of it stays in the cache.
    std::vector<uint32_t> texels;
    float texelScale = 1;     // what they are multiplied with

    // side * side cells over the image's unit square, an alias table in Morton order. A cell's
    // weight holds every pixel that bilinear reading brings into it, so none with light has density
    // zero.
    std::vector<shared::EnvironmentCell> cells;
    uint32_t side = 0;        // a power of two; 0: the image is black

    double meanLuminance = 0; // over the sphere, W/(m^2 sr) as luminance

    bool empty() const { return side == 0; }
};

// `image` is rgba32f.
EnvironmentTable makeEnvironmentTable(const Image& image);

}  // namespace gp
