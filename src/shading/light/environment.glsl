// The mapping of environment maps: latitude and longitude, Y up. The middle of the image looks
// along -Z (glTF's cameras do, unless turned), +X is right of it, +Y is the upper edge:
//   u = 0.25 is -X, u = 0.5 is -Z, u = 0.75 is +X, u = 0 or 1 is +Z; v = 0 is +Y, v = 1 is -Y.
#ifndef GP_SHADING_LIGHT_ENVIRONMENT_GLSL
#define GP_SHADING_LIGHT_ENVIRONMENT_GLSL
#include "shading/constants.glsl"
#include "shading/trigonometry.glsl"

vec2 environment_uv_from_direction(vec3 d) {
    float horizontal = sqrt(d.x * d.x + d.z * d.z);
    return vec2(0.5f + turns_from_vector(d.x, -d.z), 2.0f * turns_from_vector(horizontal, d.y));
}

vec3 environment_direction_from_uv(vec2 uv) {
    SinCos azimuth = sincos_turns(uv.x - 0.5f);
    SinCos polar = sincos_turns(0.5f * uv.y);
    return vec3(polar.s * azimuth.s, polar.c, -polar.s * azimuth.c);
}

// A density over the image's unit square as one over solid angle: the image has 2 pi^2 sin(theta)
// steradians per unit of area. 0 at the poles, where a row has no solid angle.
float environment_pdf_from_uv_pdf(float uv_pdf, vec3 d) {
    float horizontal = sqrt(d.x * d.x + d.z * d.z);
    return horizontal > 0.0f ? uv_pdf * INV_PI * INV_TWO_PI / horizontal : 0.0f;
}

#endif
