// Where a ray met a triangle: position, frames, texture coordinates, the level of detail of
// textures. Resources: load_instance, load_triangle, load_uv1, load_vertex_color.
#ifndef GP_KERNELS_SURFACE_GLSL
#define GP_KERNELS_SURFACE_GLSL
#include "shading/frame.glsl"
#include "shading/ray_cone.glsl"
#include "shared/scene_structs.glsl"

struct Surface {
    vec3 position;
    vec3 ng;           // geometric normal of the front side, unit length
    Frame frame;       // interpolated normal, on the side of ng, and tangent
    vec2 uv0;
    vec2 uv1;
    vec4 color;        // of the vertices
    float lod;  // log2 of the texture area per pixel's footprint, before a texture's own size
    uint material;
    uint front;        // 1: the ray came from the front
    Hit hit;           // only with SURFACE_FOOTPRINT, as the next
    RayCone cone;
};

vec3 transform_point(IN(InstanceRecord) r, vec3 p) {
    vec4 q = vec4(p, 1.0f);
    return vec3(dot(r.world_from_object[0], q), dot(r.world_from_object[1], q),
                dot(r.world_from_object[2], q));
}

vec3 transform_vector(IN(InstanceRecord) r, vec3 p) {
    vec4 q = vec4(p, 0.0f);
    return vec3(dot(r.world_from_object[0], q), dot(r.world_from_object[1], q),
                dot(r.world_from_object[2], q));
}

vec3 transform_normal(IN(InstanceRecord) r, vec3 n) {
    vec4 q = vec4(n, 0.0f);
    return vec3(dot(r.normal_from_object[0], q), dot(r.normal_from_object[1], q),
                dot(r.normal_from_object[2], q));
}

vec2 interpolate(vec2 a, vec2 b, vec2 c, float u, float v) {
    return a * (1.0f - u - v) + b * u + c * v;
}

vec3 interpolate(vec3 a, vec3 b, vec3 c, float u, float v) {
    return a * (1.0f - u - v) + b * u + c * v;
}

// A shading normal that the ray cannot have seen (it points away from wo although the surface does
// not) is bent until it is just visible; otherwise silhouettes of coarse meshes turn black.
vec3 bend_to_viewer(vec3 n, vec3 wo) {
    float c = dot(n, wo);
    return c > 0.0f ? n : normalize(n + wo * (1.0e-3f - c));
}

// What the material will ask of a surface beside position and normal.
#define SURFACE_UV 1u       // texture coordinates and colours
#define SURFACE_TANGENT 2u  // for normal maps and anisotropy
#define SURFACE_FOOTPRINT 4u  // what pixel_turns asks: who wants it computes it
#define SURFACE_PLACE 8u    // of all these only uv0 and the footprint: `frame` is that of ng

vec3 surface_position(IN(Hit) hit) {
    LET_REF(InstanceRecord) instance = load_instance(hit.instance);
    TriangleCorners c = load_triangle(instance.geometry, hit.primitive);
    return transform_point(instance, interpolate(c.p0, c.p1, c.p2, hit.u, hit.v));
}

// `cone` is the ray's cone at the hit; `needs`: SURFACE_ bits.
Surface load_surface(IN(Hit) hit, vec3 direction, IN(RayCone) cone, uint needs) {
    LET_REF(InstanceRecord) instance = load_instance(hit.instance);
    TriangleCorners c = load_triangle(instance.geometry, hit.primitive);
    Surface s;
    s.material = instance.material;
    s.position = transform_point(instance, interpolate(c.p0, c.p1, c.p2, hit.u, hit.v));
    vec3 e1 = transform_vector(instance, c.p1 - c.p0);
    vec3 e2 = transform_vector(instance, c.p2 - c.p0);
    vec3 ng = cross(e1, e2);
    float twice_area = max(length(ng), 1.0e-30f);
    // A mirroring transform turns the winding; the front stays the front (glTF 2.0, 3.7.4).
    s.ng = ng * ((instance.mirrored != 0u ? -1.0f : 1.0f) / twice_area);
    s.front = dot(s.ng, direction) <= 0.0f ? 1u : 0u;
    s.uv0 = vec2(0.0f);
    s.uv1 = vec2(0.0f);
    s.color = vec4(1.0f);
    s.lod = 0.0f;
    if (needs == SURFACE_PLACE) {
        s.frame = frame_from_normal(s.ng);
        s.uv0 = interpolate(c.uv0, c.uv1, c.uv2, hit.u, hit.v);
        s.hit = hit;
        s.cone = cone;
        return s;
    }
    vec3 n = transform_normal(
        instance, interpolate(octahedral_decode(c.normal0), octahedral_decode(c.normal1),
                              octahedral_decode(c.normal2), hit.u, hit.v));
    float n_squared = dot(n, n);
    n = n_squared > 0.0f ? n * inversesqrt(n_squared) : s.ng;
    n = dot(n, s.ng) < 0.0f ? -n : n;
    s.frame = frame_from_normal(n);
    if (needs == 0u) { return s; }
    if ((needs & SURFACE_FOOTPRINT) != 0u) {
        s.hit = hit;
        s.cone = cone;
    }
    // A code of zero says that there is none.
    if ((needs & SURFACE_TANGENT) != 0u && c.tangent0 != 0u) {
        vec3 t = transform_vector(
            instance, interpolate(tangent_decode(c.tangent0), tangent_decode(c.tangent1),
                                  tangent_decode(c.tangent2), hit.u, hit.v));
        float handedness = tangent_decode_handedness(c.tangent0);
        s.frame =
            frame_from_normal_tangent(n, t, instance.mirrored != 0u ? -handedness : handedness);
    }
    s.uv0 = interpolate(c.uv0, c.uv1, c.uv2, hit.u, hit.v);
    s.uv1 = load_uv1(instance.geometry, hit.primitive, hit.u, hit.v);
    s.color = load_vertex_color(instance.geometry, hit.primitive, hit.u, hit.v);
    vec2 d1 = c.uv1 - c.uv0;
    vec2 d2 = c.uv2 - c.uv0;
    float signed_uv_area = d1.x * d2.y - d1.y * d2.x;
    if ((needs & SURFACE_TANGENT) != 0u && c.tangent0 == 0u && signed_uv_area != 0.0f) {
        // Without tangents of its own: where u grows on this triangle; v grows downwards.
        float turn = signed_uv_area < 0.0f ? -1.0f : 1.0f;
        s.frame = frame_from_normal_tangent(n, (e1 * d2.y - e2 * d1.y) * turn,
                                            instance.mirrored != 0u ? turn : -turn);
    }
    s.lod = ray_cone_lod(cone, abs(signed_uv_area), twice_area, dot(s.ng, direction));
    return s;
}

#endif
