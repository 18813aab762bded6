// The mapping of environment maps: latitude and longitude, Y up. The middle of the image looks
// along -Z (glTF's cameras do, unless turned), +X is right of it, +Y is the upper edge:
//   u = 0.25 is -X, u = 0.5 is -Z, u = 0.75 is +X, u = 0 or 1 is +Z; v = 0 is +Y, v = 1 is -Y.
#ifndef GP_SHADING_LIGHT_ENVIRONMENT_GLSL
#define GP_SHADING_LIGHT_ENVIRONMENT_GLSL
#include "shading/constants.glsl"

vec2 environment_uv_from_direction(vec3 d) {
    float horizontal = sqrt(d.x * d.x + d.z * d.z);
    float azimuth = horizontal > 0.0f ? atan(d.x, -d.z) : 0.0f;
    return vec2(0.5f + azimuth * INV_TWO_PI, atan(horizontal, d.y) * INV_PI);
}

vec3 environment_direction_from_uv(vec2 uv) {
    float azimuth = (uv.x - 0.5f) * TWO_PI;
    float polar = uv.y * PI;
    float horizontal = sin(polar);
    return vec3(horizontal * sin(azimuth), cos(polar), -horizontal * cos(azimuth));
}

// A density over the image's unit square as one over solid angle: the image has 2 pi^2 sin(theta)
// steradians per unit of area. 0 at the poles, where a row has no solid angle.
float environment_pdf_from_uv_pdf(float uv_pdf, vec3 d) {
    float horizontal = sqrt(d.x * d.x + d.z * d.z);
    return horizontal > 0.0f ? uv_pdf * INV_PI * INV_TWO_PI / horizontal : 0.0f;
}

#endif
