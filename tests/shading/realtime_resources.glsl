// The resource functions of src/kernels/realtime over plain buffers, enough for the GLSL compiler
// to check every kernel; those that trace rays also need kernel_resources.glsl.
#include "shared/realtime_structs.glsl"
#include "shading/camera.glsl"
#include "shading/rgb9e5.glsl"
#include "shading/sampling/sampler.glsl"

layout(std430, binding = 20) readonly buffer RealtimeBuffer {
    RealtimeConstants realtime_constants;
    CameraParams camera_now;
    CameraParams camera_before;
};
layout(std430, binding = 21) buffer ImageBuffer { uint image_words[]; };
layout(std430, binding = 22) readonly buffer PreviousBuffer {
    PreviousInstance previous_instances[];
};
layout(std430, binding = 23) readonly buffer PreviousCornerBuffer {
    PreviousCorners previous_corners[];
};
layout(std430, binding = 24) readonly buffer CurrentBuffer { uint current_of_previous[]; };

RealtimeConstants load_realtime() { return realtime_constants; }
CameraParams load_camera() { return camera_now; }
CameraParams load_previous_camera() { return camera_before; }
PreviousInstance load_previous_instance(uint i) { return previous_instances[i]; }
PreviousCorners load_previous_corners(uint instance, uint primitive) {
    return previous_corners[instance + primitive];
}
uint load_current_instance(uint previous) { return current_of_previous[previous]; }
layout(std430, binding = 25) readonly buffer CurrentLightBuffer {
    uint current_light_of_previous[];
};
uint load_current_light(uint previous) { return current_light_of_previous[previous]; }
void note_draws(Sampler draws) {}

#define VALUE_FLOAT1 float
#define VALUE_UINT1 uint
#define VALUE_UINT2 uvec2
#define VALUE_HALF2 vec2
#define VALUE_HALF4 vec4
#define VALUE_POSITIVE3 vec4
#define VALUE_RGB9E5 vec3
#define VALUE_UNORM2 vec2
#define VALUE_UNORM4 vec4

#define READ_FLOAT1(i) uintBitsToFloat(image_words[i])
#define READ_UINT1(i) image_words[i]
#define READ_UINT2(i) uvec2(image_words[2u * i], image_words[2u * i + 1u])
#define READ_HALF2(i) unpackHalf2x16(image_words[i])
#define READ_HALF4(i) vec4(unpackHalf2x16(image_words[2u * i]), \
                           unpackHalf2x16(image_words[2u * i + 1u]))
#define READ_POSITIVE3(i) vec4(unpackHalf2x16((image_words[i] & 0x7FFu) << 4u).x, \
                               unpackHalf2x16((image_words[i] >> 11u & 0x7FFu) << 4u).x, \
                               unpackHalf2x16(image_words[i] >> 22u << 5u).x, 0.0f)
#define READ_RGB9E5(i) rgb9e5_decode(image_words[i])
#define READ_UNORM2(i) unpackUnorm4x8(image_words[i / 2u] >> 16u * (i & 1u)).xy
#define READ_UNORM4(i) unpackUnorm4x8(image_words[i])

#define WRITE_FLOAT1(i, v) image_words[i] = floatBitsToUint(v);
#define WRITE_UINT1(i, v) image_words[i] = v;
#define WRITE_UINT2(i, v) image_words[2u * i] = v.x; image_words[2u * i + 1u] = v.y;
#define WRITE_HALF2(i, v) image_words[i] = packHalf2x16(v);
#define WRITE_HALF4(i, v) image_words[2u * i] = packHalf2x16(vec2(v.x, v.y)); \
                          image_words[2u * i + 1u] = packHalf2x16(vec2(v.z, v.w));
#define WRITE_POSITIVE3(i, v) image_words[i] = \
    packHalf2x16(vec2(max(v.x, 0.0f), 0.0f)) >> 4u | \
    packHalf2x16(vec2(max(v.y, 0.0f), 0.0f)) >> 4u << 11u | \
    packHalf2x16(vec2(max(v.z, 0.0f), 0.0f)) >> 5u << 22u;
#define WRITE_RGB9E5(i, v) image_words[i] = rgb9e5_encode(v);
// Two pixels a word, as if no other invocation wrote the other one.
#define WRITE_UNORM2(i, v) image_words[i / 2u] = bitfieldInsert( \
    image_words[i / 2u], packUnorm4x8(vec4(v, 0.0f, 0.0f)), int(16u * (i & 1u)), 16);
#define WRITE_UNORM4(i, v) image_words[i] = packUnorm4x8(v);

ivec2 size_of_FULL() { return realtime_constants.size; }
ivec2 size_of_THIRD() { return (realtime_constants.size + 2) / 3; }
ivec2 size_of_OUTPUT() { return realtime_constants.output_size; }
uint pixel_index(ivec2 p, ivec2 size, uint copy) {
    return uint(size.x * size.y) * copy + uint(p.y * size.x + p.x);
}

// Each image as if it began where the buffer does: only the compiler looks.
#define X(name, format, size, copies, memory, meaning) \
    VALUE_##format load_##name(ivec2 p) { \
        return READ_##format(pixel_index(p, size_of_##size(), 0u)); \
    } \
    VALUE_##format load_previous_##name(ivec2 p) { \
        return READ_##format(pixel_index(p, size_of_##size(), 1u)); \
    } \
    void store_##name(ivec2 p, VALUE_##format v) { \
        uint i = pixel_index(p, size_of_##size(), 0u); \
        WRITE_##format(i, v) \
    }
#include "shared/realtime_images.def"
#undef X
