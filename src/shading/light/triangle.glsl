// An emissive triangle, sampled uniformly by area: robust for the tiny and far triangles that
// emissive meshes are made of, where spherical areas cancel to nothing in single precision.
#ifndef GP_SHADING_LIGHT_TRIANGLE_GLSL
#define GP_SHADING_LIGHT_TRIANGLE_GLSL
#include "shading/light/light_sample.glsl"
#include "shading/sampling/warps.glsl"

struct TriangleLight {
    vec3 p0;
    vec3 edge_1;     // p1 - p0 and p2 - p0; light leaves along cross(edge_1, edge_2)
    vec3 edge_2;
    vec3 radiance;
    uint two_sided;
};

// The barycentric coordinates (of p0, p1, p2) at which triangle_light_sample finds its point, for
// whoever has a texture to look up there.
vec3 triangle_light_barycentrics(vec2 u) {
    return square_to_uniform_triangle(u);
}

// The density of triangle_light_sample at a hit; `to_light` leads from the shading point to it.
float triangle_light_pdf(IN(TriangleLight) l, vec3 to_light) {
    vec3 normal = cross(l.edge_1, l.edge_2);
    float double_area = length(normal);
    if (!(double_area > 0.0f)) {
        return 0.0f;
    }
    float cos_light = -dot(to_light, normal) / double_area *
                      inversesqrt(max(dot(to_light, to_light), 1.0e-30f));
    if (cos_light <= 0.0f && l.two_sided == 0u) {
        return 0.0f;
    }
    return solid_angle_pdf(2.0f / double_area, to_light, cos_light);
}

LightSample triangle_light_sample(IN(TriangleLight) l, vec3 p, vec2 u) {
    vec3 b = triangle_light_barycentrics(u);
    vec3 to_light = l.p0 - p + l.edge_1 * b.y + l.edge_2 * b.z;
    LightSample s = light_sample_none();
    s.pdf = triangle_light_pdf(l, to_light);
    s.distance = length(to_light);
    if (!(s.pdf > 0.0f && s.distance > 0.0f)) {
        return light_sample_none();
    }
    s.wi = to_light / s.distance;
    s.radiance = l.radiance;
    return s;
}

#endif
