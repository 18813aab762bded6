// Lamps as a rasteriser has them: points in their middle with all of their power, whose light may
// fall off as no real light does.
#ifndef GP_SHADING_LIGHT_LAMP_POINT_GLSL
#define GP_SHADING_LIGHT_LAMP_POINT_GLSL
#include "shading/light/rectangle.glsl"
#include "shading/light/sphere.glsl"
#include "shading/light/triangle.glsl"

// GpFalloff.
#define FALLOFF_INVERSE_SQUARE 0u
#define FALLOFF_INVERSE 1u
#define FALLOFF_NONE 2u

// The point with a sphere's intensity: its radiance times the area of its disk.
SphereLight sphere_light_as_point(IN(SphereLight) l) {
    SphereLight point = l;
    if (l.radius > 0.0f) {
        point.emission = l.emission * (PI * l.radius * l.radius);
        point.radius = 0.0f;
    }
    return point;
}

// The point with the intensity that a flat light has towards p: its radiance times its area as p
// sees it, the limit of lights that are small or far. `normal` is as long as the area.
SphereLight flat_light_as_point(vec3 centre, vec3 normal, vec3 radiance, uint two_sided, vec3 p) {
    SphereLight point;
    point.position = centre;
    vec3 d = p - point.position;
    float area = dot(d, normal) * inversesqrt(max(dot(d, d), 1.0e-30f));
    point.emission = radiance * (two_sided != 0u ? abs(area) : max(area, 0.0f));
    point.radius = 0.0f;
    point.axis = vec3(0.0f, 0.0f, 1.0f);
    point.cos_inner = 1.0f;
    point.cos_outer = -2.0f;
    return point;
}

SphereLight rectangle_light_as_point(IN(RectangleLight) l, vec3 p) {
    return flat_light_as_point(l.corner + (l.edge_x + l.edge_y) * 0.5f, cross(l.edge_x, l.edge_y),
                               l.radiance, l.two_sided, p);
}

SphereLight triangle_light_as_point(IN(TriangleLight) l, vec3 p) {
    return flat_light_as_point(l.p0 + (l.edge_1 + l.edge_2) * (1.0f / 3.0f),
                               cross(l.edge_1, l.edge_2) * 0.5f, l.radiance, l.two_sided, p);
}

// The sample of a point, whose light falls off with the square of the distance, with another
// falloff: that of one metre everywhere, or of its root.
LightSample light_sample_with_falloff(IN(LightSample) s, uint falloff) {
    LightSample changed = s;
    if (falloff == FALLOFF_INVERSE) {
        changed.radiance = s.radiance * s.distance;
    } else if (falloff == FALLOFF_NONE) {
        changed.radiance = s.radiance * (s.distance * s.distance);
    }
    return changed;
}

#endif
