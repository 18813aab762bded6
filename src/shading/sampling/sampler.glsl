// The random numbers of a path, without state in memory: a function of pixel, sample, dimension and
// seed, hence the same on any thread, machine and backend.
//
// Each draw of a pixel is its own Owen-scrambled (0,2)-sequence over the samples; draws are padded:
// the order of the samples is shuffled for each, by a scramble of the index that keeps every
// aligned block of 2^k samples together, so all of them stay stratified at every power of two.
// [Burley 2020, JCGT 9(4), section 4, "shuffled scrambled Sobol"]
#ifndef GP_SHADING_SAMPLING_SAMPLER_GLSL
#define GP_SHADING_SAMPLING_SAMPLER_GLSL
#include "shading/sampling/hash.glsl"
#include "shading/sampling/sobol.glsl"

// `dimension` counts draws, of one or two numbers alike; it may be assigned, which fixes what a
// decision of a path draws from whatever was drawn before it.
struct Sampler {
    uint pixel_hash;
    uint sample_index;
    uint dimension;
};

Sampler sampler_begin(uvec2 pixel, uint sample_index, uint seed) {
    Sampler s;
    s.pixel_hash = hash_u32x3(uvec3(pixel.x, pixel.y, seed)).z;
    s.sample_index = sample_index;
    s.dimension = 0u;
    return s;
}

// The seed of a draw. The golden ratio spreads neighbouring dimensions over all 32 bits.
uint sampler_draw_seed(IN(Sampler) s) {
    return hash_u32(s.pixel_hash + s.dimension * 0x9E3779B9u);
}

// Each scramble of a draw has a seed of its own. The fold brings high bits down: the lowest bits of
// a seed act on the leading digits, and those of mere multiples would always flip together.
uint sampler_axis_seed(uint draw_seed, uint multiplier) {
    uint x = draw_seed * multiplier;
    return x ^ (x >> 15u);
}

uint sampler_shuffled_index(IN(Sampler) s, uint draw_seed) {
    return owen_scramble(s.sample_index, draw_seed);
}

float sampler_next_1d(INOUT(Sampler) s) {
    uint seed = sampler_draw_seed(s);
    s.dimension += 1u;
    uint index = sampler_shuffled_index(s, seed);
    uint seed_x = sampler_axis_seed(seed, 0x85EBCA6Bu);
    return unit_float(reverse_bits(owen_scramble_reversed(index, seed_x)));
}

vec2 sampler_next_2d(INOUT(Sampler) s) {
    uint seed = sampler_draw_seed(s);
    s.dimension += 1u;
    uint index = sampler_shuffled_index(s, seed);
    uint seed_x = sampler_axis_seed(seed, 0x85EBCA6Bu);
    uint seed_y = sampler_axis_seed(seed, 0xC2B2AE35u);
    uint x = owen_scramble_reversed(index, seed_x);
    uint y = owen_scramble_reversed(sobol_second_reversed(index), seed_y);
    return vec2(unit_float(reverse_bits(x)), unit_float(reverse_bits(y)));
}

#endif
