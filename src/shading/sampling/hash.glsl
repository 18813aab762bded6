// Integer hashes: the randomness behind the sampler, and whatever else needs a number per cell.
#ifndef GP_SHADING_SAMPLING_HASH_GLSL
#define GP_SHADING_SAMPLING_HASH_GLSL

// A bijection of 32 bits in which every input bit flips every output bit half of the time.
// [Wellons 2018, "Prospecting for Hash Functions", lowbias32]
uint hash_u32(uint x) {
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    x ^= x >> 16u;
    return x;
}

// Three numbers into three, for seeds made of several parts (pixel and frame, cell of a grid).
// [Jarzynski and Olano 2020, JCGT 9(3), listing "pcg3d"]
IN_LOOPS uvec3 hash_u32x3(uvec3 v) {
    v.x = v.x * 1664525u + 1013904223u;
    v.y = v.y * 1664525u + 1013904223u;
    v.z = v.z * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.x ^= v.x >> 16u;
    v.y ^= v.y >> 16u;
    v.z ^= v.z >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

#endif
