// What rays need of an environment image: its radiance in few bytes, and a table that directions
// are chosen from in proportion to luminance and solid angle.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "scene/large_pages.h"
#include "shared/scene_structs.h"

namespace gp {

struct EnvironmentTable {
    uint32_t width = 0, height = 0;  // of the image

    // The image, three mantissas of 9 bits and an exponent each: 4 bytes instead of 16, rounded to
    // a part in 1,000 of a pixel's largest channel (Radiance files have a part in 256). Rays read
    // it at random, and what counts is how much of it stays in the cache.
    LargeVector<uint32_t> texels;
    float texelScale = 1;     // what they are multiplied with

    // side * side cells over the image's unit square, an alias table in Morton order. A cell's
    // weight holds every pixel that bilinear reading brings into it, so none with light has density
    // zero.
    LargeVector<shared::EnvironmentCell> cells;
    // Each cell's density over the unit square, over densityScale: the upper half of a float. Rays
    // that miss everything ask for it, so it is apart and small. The weights themselves are rounded
    // to this form before the aliases are made: the densities are those of the table, exactly.
    std::vector<uint16_t> densities;
    float densityScale = 1;
    uint32_t side = 0;        // a power of two; 0: the image is black

    double meanLuminance = 0; // over the sphere, W/(m^2 sr) as luminance
    glm::dvec3 mean{0};       // the same as colour
    std::vector<glm::vec3> rowMeans;  // of each row of pixels, whose height in the sky is one

    bool black() const { return side == 0; }
    float density(uint32_t cell) const;
    glm::vec3 radiance(uint32_t x, uint32_t y) const;  // of a pixel, W/(m^2 sr)
};

// A float from its upper half.
inline float wideFloat(uint16_t upper) { return std::bit_cast<float>(uint32_t(upper) << 16); }

inline float EnvironmentTable::density(uint32_t cell) const {
    return wideFloat(densities[cell]) * densityScale;
}

// `rgba`: radiance in W/(m^2 sr), top row first, neither negative nor infinite; alpha is not read.
std::shared_ptr<const EnvironmentTable> makeEnvironmentTable(const float* rgba, uint32_t width,
                                                             uint32_t height);

// The same for skies that may be others in the next frame: coarser, and no direction is left out.
std::shared_ptr<EnvironmentTable> makeSkyTable(const float* rgba, uint32_t width, uint32_t height);
// Shows other radiance of the same size through such a table, directions chosen as before. False,
// and nothing is changed, where too much of the light lies where the table seldom looks.
bool refreshSkyTable(EnvironmentTable& table, const float* rgba);

}  // namespace gp
