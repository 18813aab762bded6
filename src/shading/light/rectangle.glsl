// A rectangular light, sampled uniformly in the solid angle it fills.
#ifndef GP_SHADING_LIGHT_RECTANGLE_GLSL
#define GP_SHADING_LIGHT_RECTANGLE_GLSL
#include "shading/light/light_sample.glsl"
#include "shading/sampling/spherical_rectangle.glsl"

// Below this solid angle (1/sr inverse) the light is sampled by area: the angle is a difference of
// angles, and in single precision 1e-6 of them is noise; a rectangle so small is nearly flat.
#define RECTANGLE_LIGHT_MIN_SOLID_ANGLE 0.01f

struct RectangleLight {
    vec3 corner;
    vec3 edge_x;      // both edges leave the corner; light leaves along cross(edge_x, edge_y)
    vec3 edge_y;
    vec3 radiance;
    uint two_sided;
};

bool rectangle_light_faces(IN(RectangleLight) l, vec3 p) {
    return l.two_sided != 0u || dot(p - l.corner, cross(l.edge_x, l.edge_y)) > 0.0f;
}

// Only true rectangles can be sampled by solid angle; other parallelograms are by area.
bool rectangle_light_is_square(IN(RectangleLight) l) {
    float c = dot(l.edge_x, l.edge_y);
    return c * c <= 1.0e-8f * dot(l.edge_x, l.edge_x) * dot(l.edge_y, l.edge_y);
}

bool rectangle_light_by_solid_angle(IN(RectangleLight) l, IN(SphericalRectangle) r) {
    return r.solid_angle > RECTANGLE_LIGHT_MIN_SOLID_ANGLE && rectangle_light_is_square(l);
}

// The density by area, at the point p + to_light of the rectangle.
float rectangle_light_area_pdf(IN(RectangleLight) l, vec3 to_light) {
    vec3 normal = cross(l.edge_x, l.edge_y);
    float area = length(normal);
    float cos_light = dot(to_light, normal) / area *
                      inversesqrt(max(dot(to_light, to_light), 1.0e-30f));
    return solid_angle_pdf(1.0f / area, to_light, cos_light);
}

// The density of rectangle_light_sample at a hit; `to_light` leads from p to it (not unit).
float rectangle_light_pdf(IN(RectangleLight) l, vec3 p, vec3 to_light) {
    if (!rectangle_light_faces(l, p)) {
        return 0.0f;
    }
    SphericalRectangle r = spherical_rectangle(l.corner, l.edge_x, l.edge_y, p);
    return rectangle_light_by_solid_angle(l, r) ? spherical_rectangle_pdf(r)
                                                : rectangle_light_area_pdf(l, to_light);
}

LightSample rectangle_light_sample(IN(RectangleLight) l, vec3 p, vec2 u) {
    if (!rectangle_light_faces(l, p)) {
        return light_sample_none();
    }
    SphericalRectangle r = spherical_rectangle(l.corner, l.edge_x, l.edge_y, p);
    LightSample s = light_sample_none();
    vec3 to_light;
    if (rectangle_light_by_solid_angle(l, r)) {
        to_light = square_to_spherical_rectangle(r, u);
        s.pdf = spherical_rectangle_pdf(r);
    } else {
        to_light = l.corner - p + l.edge_x * u.x + l.edge_y * u.y;
        s.pdf = rectangle_light_area_pdf(l, to_light);
    }
    s.distance = length(to_light);
    if (!(s.distance > 0.0f)) {
        return light_sample_none();
    }
    s.wi = to_light / s.distance;
    s.radiance = l.radiance;
    return s;
}

#endif
