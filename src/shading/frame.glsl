// Orthonormal frames: from world space to the local space of a surface (normal +Z, tangent +X,
// bitangent +Y) and back, and the 32-bit form in which normals and tangents are stored.
#ifndef GP_SHADING_FRAME_GLSL
#define GP_SHADING_FRAME_GLSL

struct Frame {
    vec3 t;
    vec3 b;
    vec3 n;
};

// A right-handed frame around the unit vector n. It jumps where n.z changes its sign, so nothing
// that must be smooth over a surface (anisotropy) may depend on it.
// [Duff et al. 2017, JCGT 6(1), listing 3]
Frame frame_from_normal(vec3 n) {
    float s = n.z >= 0.0f ? 1.0f : -1.0f;
    float a = -1.0f / (s + n.z);
    float b = n.x * n.y * a;
    Frame f;
    f.t = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
    f.b = vec3(b, s + n.y * n.y * a, -n.y);
    f.n = n;
    return f;
}

// The frame of a surface with a tangent as glTF stores it: `handedness` is +1 or -1 and turns the
// bitangent where texture space is mirrored. The normal is kept, the tangent is made orthogonal to
// it; a tangent that is zero or parallel to the normal is replaced by any orthogonal one.
Frame frame_from_normal_tangent(vec3 n, vec3 t, float handedness) {
    vec3 orthogonal = t - n * dot(n, t);
    float length_squared = dot(orthogonal, orthogonal);
    // Below this share of t's own length rounding errors decide where the difference points.
    if (!(length_squared > 1.0e-10f * dot(t, t))) {
        return frame_from_normal(n);
    }
    Frame f;
    f.t = orthogonal * inversesqrt(length_squared);
    f.b = cross(n, f.t) * handedness;
    f.n = n;
    return f;
}

vec3 local_from_world(IN(Frame) f, vec3 v) {
    return vec3(dot(v, f.t), dot(v, f.b), dot(v, f.n));
}

vec3 world_from_local(IN(Frame) f, vec3 v) {
    return f.t * v.x + f.b * v.y + f.n * v.z;
}

// The unit sphere on the square [-1, 1]^2: the octahedron |x| + |y| + |z| = 1 seen from +Z, its
// lower half folded outwards over the edges.
// [Cigolle et al. 2014, JCGT 3(2), section 3, "oct"]
vec2 octahedral_from_direction(vec3 d) {
    float inv_norm = 1.0f / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 p = vec2(d.x * inv_norm, d.y * inv_norm);
    if (d.z < 0.0f) {
        p = vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f),
                 (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
    }
    return p;
}

vec3 direction_from_octahedral(vec2 p) {
    float z = 1.0f - abs(p.x) - abs(p.y);
    float fold = max(-z, 0.0f);
    float x = p.x + (p.x >= 0.0f ? -fold : fold);
    float y = p.y + (p.y >= 0.0f ? -fold : fold);
    return normalize(vec3(x, y, z));
}

// Two's complement in the low bits, symmetric around zero: -1, 0 and 1 are kept exactly.
uint snorm_encode(float v, float scale, uint mask) {
    return uint(int(floor(clamp(v, -1.0f, 1.0f) * scale + 0.5f))) & mask;
}

// A unit vector in 2 x 16 bits; the angular error is below 7e-5 rad (tests/shading).
uint octahedral_encode(vec3 d) {
    vec2 p = octahedral_from_direction(d);
    return snorm_encode(p.x, 32767.0f, 0xFFFFu) | (snorm_encode(p.y, 32767.0f, 0xFFFFu) << 16u);
}

vec3 octahedral_decode(uint code) {
    float x = float(int(code << 16u) >> 16) / 32767.0f;
    float y = float(int(code) >> 16) / 32767.0f;
    return direction_from_octahedral(vec2(x, y));
}

// A tangent: 16 bits of x, 15 bits of y, and the sign of the bitangent in the highest bit.
uint tangent_encode(vec3 t, float handedness) {
    vec2 p = octahedral_from_direction(t);
    uint x = snorm_encode(p.x, 32767.0f, 0xFFFFu);
    uint y = snorm_encode(p.y, 16383.0f, 0x7FFFu);
    return x | (y << 16u) | (handedness < 0.0f ? 0x80000000u : 0u);
}

vec3 tangent_decode(uint code) {
    float x = float(int(code << 16u) >> 16) / 32767.0f;
    float y = float(int(code << 1u) >> 17) / 16383.0f;
    return direction_from_octahedral(vec2(x, y));
}

float tangent_decode_handedness(uint code) {
    return (code & 0x80000000u) != 0u ? -1.0f : 1.0f;
}

#endif
