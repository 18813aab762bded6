// The six faces of a cube map as OpenGL lays them out: +X, -X, +Y, -Y, +Z, -Z, each with s to the
// right and t downwards in [0, 1].
#ifndef GP_SHADING_LIGHT_CUBE_MAP_GLSL
#define GP_SHADING_LIGHT_CUBE_MAP_GLSL
#include "shading/constants.glsl"

struct CubePoint {
    uint face;
    vec2 st;
};

// The point of the cube that lies towards d, which need not be unit length.
CubePoint cube_point(vec3 d) {
    vec3 a = abs(d);
    float major;
    vec2 c;
    CubePoint p;
    // [OpenGL 4.6 specification, table 8.19]
    if (a.x >= a.y && a.x >= a.z) {
        p.face = d.x >= 0.0f ? 0u : 1u;
        major = a.x;
        c = vec2(d.x >= 0.0f ? -d.z : d.z, -d.y);
    } else if (a.y >= a.z) {
        p.face = d.y >= 0.0f ? 2u : 3u;
        major = a.y;
        c = vec2(d.x, d.y >= 0.0f ? d.z : -d.z);
    } else {
        p.face = d.z >= 0.0f ? 4u : 5u;
        major = a.z;
        c = vec2(d.z >= 0.0f ? d.x : -d.x, -d.y);
    }
    p.st = c * (0.5f / max(major, 1.0e-30f)) + 0.5f;
    return p;
}

// To a point of a face of the cube from -1 to 1; beyond the edges of the face it lies in its
// plane.
vec3 cube_direction(uint face, vec2 st) {
    float s = 2.0f * st.x - 1.0f;
    float t = 2.0f * st.y - 1.0f;
    // [OpenGL 4.6 specification, table 8.19], solved for the direction
    if (face == 0u) { return vec3(1.0f, -t, -s); }
    if (face == 1u) { return vec3(-1.0f, -t, s); }
    if (face == 2u) { return vec3(s, 1.0f, t); }
    if (face == 3u) { return vec3(s, -1.0f, -t); }
    if (face == 4u) { return vec3(s, -t, 1.0f); }
    return vec3(-s, -t, -1.0f);
}

#endif
