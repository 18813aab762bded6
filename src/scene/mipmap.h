// The chain of smaller copies of an image.
#pragma once

#include "scene/texture.h"

namespace gp {

// The levels of a chain down to 1x1 (or of level 0 alone), and how many bytes they take.
std::vector<MipLevel> mipLayout(uint32_t width, uint32_t height, PixelFormat format,
                                bool mipmapped, size_t& totalBytes);

// The share of up to three source texels in texel i of the next level, along one axis.
struct BoxTaps {
    uint32_t first = 0, count = 1;
    float weight[3] = {1, 0, 0};
};
BoxTaps boxTaps(uint32_t i, uint32_t from, uint32_t to);

// The sRGB transfer function, both ways. [IEC 61966-2-1:1999, 5.2]
float linearFromSrgb(float v);
float srgbFromLinear(float v);

// Fills every level of `texture` from the one before it: a box filter in linear light. Where a
// size is odd, each smaller texel takes its exact share of three texels, so that nothing shifts.
// Only what depends on `changed`, a rectangle of level 0, is filled.
void fillMipLevels(Texture& texture, TexelRect changed);

}  // namespace gp
