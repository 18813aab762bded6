// Three colours in 32 bits: nine bits each, and one exponent of five bits for all.
// [Khronos, EXT_texture_shared_exponent, section "Encode" and "Decode"]
#ifndef GP_SHADING_RGB9E5_GLSL
#define GP_SHADING_RGB9E5_GLSL
#include "shading/constants.glsl"

#define RGB9E5_LARGEST 65408.0f  // 511 / 512 * 2^16

// 2^e for e of a normal number.
float rgb9e5_power(int e) {
    return uintBitsToFloat(uint(e + 127) << 23u);
}

// What is negative or no number becomes 0, what is too large the largest; rounded to nearest.
uint rgb9e5_encode(vec3 v) {
    vec3 c = vec3(v.x > 0.0f ? min(v.x, RGB9E5_LARGEST) : 0.0f,
                  v.y > 0.0f ? min(v.y, RGB9E5_LARGEST) : 0.0f,
                  v.z > 0.0f ? min(v.z, RGB9E5_LARGEST) : 0.0f);
    float most = max(c.x, max(c.y, c.z));
    int shared_exponent = max(int(floatBitsToUint(most) >> 23u) - 127, -16) + 1;
    // A largest one that would be rounded up to 512 needs the next exponent.
    if (floor(most * rgb9e5_power(9 - shared_exponent) + 0.5f) >= 512.0f) { shared_exponent += 1; }
    float scale = rgb9e5_power(9 - shared_exponent);
    return uint(floor(c.x * scale + 0.5f)) | (uint(floor(c.y * scale + 0.5f)) << 9u) |
           (uint(floor(c.z * scale + 0.5f)) << 18u) | (uint(shared_exponent + 15) << 27u);
}

vec3 rgb9e5_decode(uint code) {
    float scale = rgb9e5_power(int(code >> 27u) - 24);
    return vec3(float(code & 511u), float((code >> 9u) & 511u), float((code >> 18u) & 511u)) *
           scale;
}

#endif
