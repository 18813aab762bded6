// The first two dimensions of the Sobol' sequence, a (0,2)-sequence, and hash-based scrambling as
// Owen's. Numbers are kept with their bits reversed as long as possible: in that form the first
// dimension is the index itself and scrambling is a hash in which bits act only upwards.
#ifndef GP_SHADING_SAMPLING_SOBOL_GLSL
#define GP_SHADING_SAMPLING_SOBOL_GLSL
#include "shading/constants.glsl"

uint reverse_bits(uint x) {
    x = ((x >> 1u) & 0x55555555u) | ((x & 0x55555555u) << 1u);
    x = ((x >> 2u) & 0x33333333u) | ((x & 0x33333333u) << 2u);
    x = ((x >> 4u) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4u);
    // Compilers know the byte swap by this form and make it one instruction.
    return (x >> 24u) | ((x >> 8u) & 0xFF00u) | ((x << 8u) & 0xFF0000u) | (x << 24u);
}

// The second Sobol' dimension of `index`, bits reversed. Its generator matrix is Pascal's triangle
// modulo 2, and binomial(k, j) is odd exactly where the bits of j are among those of k (Lucas); so
// bit j of the product is the exclusive or over all k that contain j: one butterfly step a bit.
uint sobol_second_reversed(uint index) {
    uint x = index;
    x ^= (x >> 1u) & 0x55555555u;
    x ^= (x >> 2u) & 0x33333333u;
    x ^= (x >> 4u) & 0x0F0F0F0Fu;
    x ^= (x >> 8u) & 0x00FF00FFu;
    x ^= x >> 16u;
    return x;
}

// A random permutation in which each bit depends on the lower ones only: Owen's nested uniform
// scramble of a number whose bits are reversed.
// [Burley 2020, JCGT 9(4), section 3; constants: Vegdahl 2021, "Building a Better LK Hash"]
uint owen_scramble_reversed(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// The same for a number in natural order: its highest bits choose what happens to the lower ones.
uint owen_scramble(uint x, uint seed) {
    return reverse_bits(owen_scramble_reversed(reverse_bits(x), seed));
}

// The upper 24 bits as a float in [0, 1): never 1, as rounding all 32 bits could give.
float unit_float(uint x) {
    return float(x >> 8u) * EXP2_MINUS_24;
}

#endif
