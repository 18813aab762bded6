// Indirect diffuse light at a pixel's mapped normal, from what rays over the unmapped one gathered.
#ifndef GP_SHADING_INDIRECT_LIGHT_GLSL
#define GP_SHADING_INDIRECT_LIGHT_GLSL
#include "shading/sh.glsl"

// `moments`: x is irradiance / pi at the normal n0, yzw the cosine-weighted mean of radiance times
// direction over its hemisphere, V = integral of L(w) w cos / pi. Both are plain means over
// cosine-distributed rays, so that they are accumulated and filtered as any light; a projection on
// spherical harmonics would weigh rays near the horizon by 1 / cos and need the other hemisphere,
// which a surface never sees.
//
// Let L(w) = a + b.w be a radiance field of l <= 1, z be n0, t be tangential to it. Then
//   x = a + (2/3) b_z,  V_t = b_t / 4 (the integral of x^2 cos is pi / 4),
//   irradiance / pi at any normal n = a + (2/3) b.n  [Ramamoorthi and Hanrahan 2001]
//                                   = a + (2/3) b_z n_z + (8/3) V_t.n_t.
// For a small tilt n_z is 1 but for the square of the tilt, and the sum is x + (8/3) V_t.n_t. For
// large tilts a and b_z would be needed apart; V_z has them, but solving for them makes noise 18
// times larger. Instead x fades as (1 + n_z) / 2, the share of the tilted hemisphere that lies over
// the horizon of n0: below it there is the surface itself.
float indirect_at_normal(vec4 moments, vec3 n0, vec3 n) {
    float aligned = dot(n, n0);
    vec3 v = vec3(moments.y, moments.z, moments.w);
    float tangential = dot(v, n) - dot(v, n0) * aligned;
    return max(moments.x * (0.5f + 0.5f * aligned) + (8.0f / 3.0f) * tangential, 0.0f);
}

// Light over albedo of a pixel with mapped normal n. `chroma`: its Co and Cg, which grow and fall
// with the luma; never negative.
vec3 indirect_relit(vec4 moments, vec2 chroma, vec3 n0, vec3 n) {
    ShLuma at_n0;
    at_n0.luma = moments;
    at_n0.chroma = chroma;
    return sh_luma_colour(at_n0, indirect_at_normal(moments, n0, n));
}

#endif
