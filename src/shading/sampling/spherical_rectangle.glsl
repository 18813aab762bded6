// Uniform directions towards a rectangle, by solid angle.
// [Urena, Fajardo and King 2013, "An Area-Preserving Parametrization for Spherical Rectangles"]
#ifndef GP_SHADING_SAMPLING_SPHERICAL_RECTANGLE_GLSL
#define GP_SHADING_SAMPLING_SPHERICAL_RECTANGLE_GLSL
#include "shading/constants.glsl"

// A rectangle seen from a point, in a frame whose x and y run along its edges and whose z points
// away from it: it covers [x0, x1] x [y0, y1] in the plane z = z0 <= 0.
struct SphericalRectangle {
    vec3 x_axis;
    vec3 y_axis;
    vec3 z_axis;
    float x0;
    float x1;
    float y0;
    float y1;
    float z0;
    float b0;  // z of the normals of the planes through the eye and the edges at y0 and y1
    float b1;
    float k;   // angles at x0 less pi: the area left of x is 0 there
    float solid_angle;
};

// asin to the last digits. The graphics interfaces promise 4096 units in the last place only, too
// few for a small difference of large angles.
// [Moshier 1992, Cephes Mathematical Library, asinf]
float arc_sine(float x) {
    float a = min(abs(x), 1.0f);
    bool steep = a > 0.5f;
    float z = steep ? 0.5f * (1.0f - a) : a * a;
    float s = steep ? sqrt(z) : a;
    float p = 4.2163199048e-2f;
    p = p * z + 2.4181311049e-2f;
    p = p * z + 4.5470025998e-2f;
    p = p * z + 7.4953002686e-2f;
    p = p * z + 1.6666752422e-1f;
    p = p * z * s + s;
    p = steep ? HALF_PI - 2.0f * p : p;
    return x < 0.0f ? -p : p;
}

// The solid angle of [x0, x1] x [y0, y1] at height z0: the angles of its spherical image, which are
// those between the planes through the eye and the edges, minus 2 pi.
float spherical_rectangle_excess(float x0, float x1, float y0, float y1, float z0) {
    float n0 = -y0 * inversesqrt(z0 * z0 + y0 * y0);
    float n1 = x1 * inversesqrt(z0 * z0 + x1 * x1);
    float n2 = y1 * inversesqrt(z0 * z0 + y1 * y1);
    float n3 = -x0 * inversesqrt(z0 * z0 + x0 * x0);
    // acos(-a b) = pi/2 + asin(a b): without pi the four terms keep their digits.
    return arc_sine(n0 * n1) + arc_sine(n1 * n2) + arc_sine(n2 * n3) + arc_sine(n3 * n0);
}

// `edge_x` and `edge_y` leave `corner` at right angles to each other.
SphericalRectangle spherical_rectangle(vec3 corner, vec3 edge_x, vec3 edge_y, vec3 eye) {
    SphericalRectangle r;
    float width = length(edge_x);
    float height = length(edge_y);
    r.x_axis = edge_x / width;
    r.y_axis = edge_y / height;
    r.z_axis = cross(r.x_axis, r.y_axis);
    vec3 d = corner - eye;
    r.z0 = dot(d, r.z_axis);
    if (r.z0 > 0.0f) {
        r.z_axis = -r.z_axis;
        r.z0 = -r.z0;
    }
    r.x0 = dot(d, r.x_axis);
    r.y0 = dot(d, r.y_axis);
    r.x1 = r.x0 + width;
    r.y1 = r.y0 + height;
    float n0 = -r.y0 * inversesqrt(r.z0 * r.z0 + r.y0 * r.y0);
    float n1 = r.x1 * inversesqrt(r.z0 * r.z0 + r.x1 * r.x1);
    float n2 = r.y1 * inversesqrt(r.z0 * r.z0 + r.y1 * r.y1);
    float n3 = -r.x0 * inversesqrt(r.z0 * r.z0 + r.x0 * r.x0);
    r.b0 = n0;
    r.b1 = n2;
    r.k = arc_sine(n2 * n3) + arc_sine(n3 * n0);
    r.solid_angle = arc_sine(n0 * n1) + arc_sine(n1 * n2) + r.k;
    return r;
}

// A point of the rectangle, relative to the eye; its direction is uniform in solid angle.
vec3 square_to_spherical_rectangle(IN(SphericalRectangle) r, vec2 u) {
    // With the angles measured from pi, phi_u of the paper is a - pi: both sine and cosine flip.
    float a = u.x * r.solid_angle - r.k;
    float sin_a = sin(a);
    float fu = (cos(a) * r.b0 + r.b1) / (sin_a != 0.0f ? sin_a : 1.0e-9f);
    // x / |z| is the cotangent of the angle whose cosine the paper calls cu; 1 - b0^2 taken from
    // the lengths keeps its digits where b0 is near 1.
    float c0_squared = r.z0 * r.z0 / (r.z0 * r.z0 + r.y0 * r.y0);
    float xu = -r.z0 * inversesqrt(max(fu * fu - c0_squared, 1.0e-20f));
    xu = clamp(fu > 0.0f ? xu : -xu, r.x0, r.x1);
    float d2 = xu * xu + r.z0 * r.z0;
    float h0 = r.y0 * inversesqrt(d2 + r.y0 * r.y0);
    float h1 = r.y1 * inversesqrt(d2 + r.y1 * r.y1);
    float hv = h0 + u.y * (h1 - h0);
    float yv = hv * sqrt(d2) * inversesqrt(max(1.0f - hv * hv, 1.0e-12f));
    yv = clamp(yv, r.y0, r.y1);
    return r.x_axis * xu + r.y_axis * yv + r.z_axis * r.z0;
}

// `p` is relative to the eye, too.
vec2 spherical_rectangle_to_square(IN(SphericalRectangle) r, vec3 p) {
    float x = dot(p, r.x_axis);
    float y = dot(p, r.y_axis);
    float left = spherical_rectangle_excess(r.x0, x, r.y0, r.y1, r.z0);
    float d2 = x * x + r.z0 * r.z0;
    float h0 = r.y0 * inversesqrt(d2 + r.y0 * r.y0);
    float h1 = r.y1 * inversesqrt(d2 + r.y1 * r.y1);
    float h = y * inversesqrt(d2 + y * y);
    vec2 u = vec2(left / r.solid_angle, (h - h0) / (h1 - h0));
    return clamp(u, vec2(0.0f), vec2(ONE_MINUS_EPSILON));
}

float spherical_rectangle_pdf(IN(SphericalRectangle) r) {
    return 1.0f / r.solid_angle;
}

#endif
