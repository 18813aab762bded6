// From the unit square to the domains that a renderer samples, and back. `square_to_x` maps uniform
// u in [0, 1)^2, `x_to_square` is its inverse, `x_pdf` the density that results. Maps that keep
// neighbours together are preferred, so that stratified points stay stratified.
#ifndef GP_SHADING_SAMPLING_WARPS_GLSL
#define GP_SHADING_SAMPLING_WARPS_GLSL
#include "shading/constants.glsl"

// The unit disk, by area: concentric squares become concentric circles. Polar coordinates; the
// radius is signed, and exact: whoever needs 1 - r^2 takes it from here rather than from x and y.
// [Shirley and Chiu 1997, Journal of Graphics Tools 2(3)]
vec2 square_to_concentric_polar(vec2 u) {
    float a = 2.0f * u.x - 1.0f;
    float b = 2.0f * u.y - 1.0f;
    if (a == 0.0f && b == 0.0f) {
        return vec2(0.0f);
    }
    return abs(a) > abs(b) ? vec2(a, QUARTER_PI * (b / a))
                           : vec2(b, HALF_PI - QUARTER_PI * (a / b));
}

vec2 square_to_concentric_disk(vec2 u) {
    vec2 polar = square_to_concentric_polar(u);
    return vec2(polar.x * cos(polar.y), polar.x * sin(polar.y));
}

vec2 concentric_disk_to_square(vec2 p) {
    // Turned into the quadrant around +X, so that the angle stays within [-pi/4, pi/4].
    float r = length(p);
    if (r == 0.0f) {
        return vec2(0.5f);
    }
    bool wide = abs(p.x) > abs(p.y);
    float major = wide ? p.x : p.y;
    float minor_angle = wide ? atan(p.y / p.x) : atan(p.x / p.y);
    float a = major > 0.0f ? r : -r;
    float b = a * minor_angle / QUARTER_PI;
    vec2 p_square = wide ? vec2(a, b) : vec2(b, a);
    return clamp(0.5f * p_square + vec2(0.5f), vec2(0.0f), vec2(ONE_MINUS_EPSILON));
}

float concentric_disk_pdf() {
    return INV_PI;
}

// The hemisphere around +Z by projected solid angle: the disk lifted up to the sphere (Malley).
vec3 square_to_cosine_hemisphere(vec2 u) {
    vec2 polar = square_to_concentric_polar(u);
    float r = polar.x;
    return vec3(r * cos(polar.y), r * sin(polar.y), sqrt((1.0f - r) * (1.0f + r)));
}

vec2 cosine_hemisphere_to_square(vec3 d) {
    return concentric_disk_to_square(vec2(d.x, d.y));
}

float cosine_hemisphere_pdf(vec3 d) {
    return max(d.z, 0.0f) * INV_PI;
}

// The cone around +Z by solid angle. It is given by 1 - cos of its half angle, which keeps its
// digits where the cosine itself has none left: for the sun 1 - cos is 1.1e-5.
vec3 square_to_uniform_cone(vec2 u, float one_minus_cos_max) {
    // By Archimedes the height over a cap is uniform, as the squared radius over a disk is.
    vec2 polar = square_to_concentric_polar(u);
    float height = one_minus_cos_max * polar.x * polar.x;
    float sin_theta = polar.x * sqrt(one_minus_cos_max * (2.0f - height));
    return vec3(sin_theta * cos(polar.y), sin_theta * sin(polar.y), 1.0f - height);
}

vec2 uniform_cone_to_square(vec3 d, float one_minus_cos_max) {
    float sin_squared = d.x * d.x + d.y * d.y;
    // 1 - cos, from the sine in the upper half, where subtracting would cancel.
    float height = d.z > 0.0f ? sin_squared / (1.0f + d.z) : 1.0f - d.z;
    float r = sqrt(height / one_minus_cos_max);
    float scale = sin_squared > 0.0f ? r * inversesqrt(sin_squared) : 0.0f;
    return concentric_disk_to_square(vec2(d.x * scale, d.y * scale));
}

// Density inside of the cone; the caller knows whether a direction is inside.
float uniform_cone_pdf(float one_minus_cos_max) {
    return INV_TWO_PI / one_minus_cos_max;
}

// The unit vector of height z at the azimuth phi.
vec3 direction_from_height(float z, float phi) {
    float r = sqrt(max((1.0f - z) * (1.0f + z), 0.0f));
    return vec3(r * cos(phi), r * sin(phi), z);
}

vec3 square_to_uniform_hemisphere(vec2 u) {
    return square_to_uniform_cone(u, 1.0f);
}

vec2 uniform_hemisphere_to_square(vec3 d) {
    return uniform_cone_to_square(d, 1.0f);
}

float uniform_hemisphere_pdf(vec3 d) {
    return d.z >= 0.0f ? INV_TWO_PI : 0.0f;
}

vec3 square_to_uniform_sphere(vec2 u) {
    float z = 1.0f - 2.0f * u.x;
    float r = 2.0f * sqrt(max(0.0f, u.x * (1.0f - u.x)));
    float phi = TWO_PI * u.y;
    return vec3(r * cos(phi), r * sin(phi), z);
}

vec2 uniform_sphere_to_square(vec3 d) {
    float phi = d.x == 0.0f && d.y == 0.0f ? 0.0f : atan(d.y, d.x) * INV_TWO_PI;
    vec2 u = vec2(0.5f - 0.5f * d.z, phi < 0.0f ? phi + 1.0f : phi);
    return clamp(u, vec2(0.0f), vec2(ONE_MINUS_EPSILON));
}

float uniform_sphere_pdf() {
    return INV_FOUR_PI;
}

// Barycentric coordinates of a triangle, by area.
// [Heitz 2019, "A Low-Distortion Map Between Triangle and Square", listing 1]
vec3 square_to_uniform_triangle(vec2 u) {
    vec2 b = u.y > u.x ? vec2(0.5f * u.x, u.y - 0.5f * u.x) : vec2(u.x - 0.5f * u.y, 0.5f * u.y);
    return vec3(b.x, b.y, 1.0f - b.x - b.y);
}

vec2 uniform_triangle_to_square(vec3 b) {
    vec2 u = b.y > b.x ? vec2(2.0f * b.x, b.x + b.y) : vec2(b.x + b.y, 2.0f * b.y);
    return clamp(u, vec2(0.0f), vec2(ONE_MINUS_EPSILON));
}

float uniform_triangle_pdf(float area) {
    return 1.0f / area;
}

#endif
