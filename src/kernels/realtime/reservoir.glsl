// Light samples that pixels hand on: one is kept of many, with a weight for all of them.
// [Bitterli, Wyman, Pharr, Shirley, Lefohn, Jarosz 2020, "Spatiotemporal Reservoir Resampling for
//  Real-Time Ray Tracing with Dynamic Direct Lighting", algorithms 2 and 4]
#ifndef GP_KERNELS_REALTIME_RESERVOIR_GLSL
#define GP_KERNELS_REALTIME_RESERVOIR_GLSL
#include "shading/constants.glsl"
#include "shared/scene_structs.glsl"

#define RESERVOIR_MOST_COUNT 4095.0f

// A point of a light is the light and the two random numbers that lead to it: then the same sample
// has the same density at every pixel, and no Jacobian is needed.
struct Reservoir {
    uint light;      // NO_INDEX: none
    vec2 u;
    float weight;    // one over the density of the sample, resampling included
    float count;     // of samples that it stands for
};

Reservoir reservoir_empty() {
    Reservoir r;
    r.light = NO_INDEX;
    r.u = vec2(0.0f);
    r.weight = 0.0f;
    r.count = 0.0f;
    return r;
}

uvec2 reservoir_pack_sample(IN(Reservoir) r) {
    return uvec2(r.light, floatBitsToUint(r.u.x));
}

// The weight loses the 12 lowest bits of its mantissa to the count.
uvec2 reservoir_pack_weight(IN(Reservoir) r) {
    uint weight = (floatBitsToUint(clamp(r.weight, 0.0f, 1.0e30f)) + 2048u) & 0xFFFFF000u;
    return uvec2(floatBitsToUint(r.u.y),
                 weight | uint(clamp(r.count, 0.0f, RESERVOIR_MOST_COUNT) + 0.5f));
}

Reservoir reservoir_unpack(uvec2 sample_bits, uvec2 weight_bits) {
    Reservoir r;
    r.light = sample_bits.x;
    r.u = vec2(uintBitsToFloat(sample_bits.y), uintBitsToFloat(weight_bits.x));
    r.weight = uintBitsToFloat(weight_bits.y & 0xFFFFF000u);
    r.count = float(weight_bits.y & 4095u);
    return r;
}

// A stream of samples of which one is kept, each in proportion to its weight.
struct ReservoirStream {
    Reservoir kept;
    float sum;       // of weights
    float target;    // of the sample that is kept
};

ReservoirStream reservoir_stream_empty() {
    ReservoirStream s;
    s.kept = reservoir_empty();
    s.sum = 0.0f;
    s.target = 0.0f;
    return s;
}

// `target` is what the sample would bring to this pixel; the sample stands for `count` others.
// `u` in [0, 1) decides. Returns whether it is the one that is kept now.
bool reservoir_offer(INOUT(ReservoirStream) s, uint light, vec2 light_u, float target,
                     float weight, float count, float u) {
    float w = target * weight * count;
    s.kept.count += count;
    if (!(w > 0.0f) || !(w < FLOAT_MAX)) { return false; }
    s.sum += w;
    if (u * s.sum >= w) { return false; }
    s.kept.light = light;
    s.kept.u = light_u;
    s.target = target;
    return true;
}

// The reservoir that comes out, where `count` samples could have been the one that is kept.
Reservoir reservoir_finished(IN(ReservoirStream) s, float count) {
    Reservoir r = s.kept;
    r.weight = s.target > 0.0f && count > 0.0f ? s.sum / (s.target * count) : 0.0f;
    return r;
}

#endif
