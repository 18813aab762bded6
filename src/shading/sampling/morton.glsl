// Morton order: a square grid of 2^k cells a side as a line that keeps neighbours near each other.
#ifndef GP_SHADING_SAMPLING_MORTON_GLSL
#define GP_SHADING_SAMPLING_MORTON_GLSL

// The low 16 bits, spread to the even places.
uint morton_spread(uint x) {
    x &= 0xFFFFu;
    x = (x | (x << 8u)) & 0x00FF00FFu;
    x = (x | (x << 4u)) & 0x0F0F0F0Fu;
    x = (x | (x << 2u)) & 0x33333333u;
    return (x | (x << 1u)) & 0x55555555u;
}

// The even places, gathered in the low 16 bits.
uint morton_gather(uint x) {
    x &= 0x55555555u;
    x = (x | (x >> 1u)) & 0x33333333u;
    x = (x | (x >> 2u)) & 0x0F0F0F0Fu;
    x = (x | (x >> 4u)) & 0x00FF00FFu;
    return (x | (x >> 8u)) & 0x0000FFFFu;
}

uint morton_from_cell(uvec2 cell) {
    return morton_spread(cell.x) | (morton_spread(cell.y) << 1u);
}

uvec2 cell_from_morton(uint index) {
    return uvec2(morton_gather(index), morton_gather(index >> 1u));
}

#endif
