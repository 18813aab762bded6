// V-cavity masking of slopes about any mean. A height field sbar.x + h0 with centred h0 is a
// vertical shear of h0, which keeps what is visible, what is a height field, and horizontal area:
// the pair of a facet of slope s is the one of slope 2 sbar - s. The identity of visible area,
//   int G1 <w, m> D dm = max(A(w), 0),
// holds exactly for every P22 that is symmetric about sbar: Gaussians, glints and their mixtures
// (docs/water.md; the tilted form of earlier work, which breaks it, is tilted_cavity.glsl).
// Based on: Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the
// Distribution of Visible Normals", EGSR; the shear is ours.
#ifndef GP_SHADING_SLOPE_SHEARED_CAVITY_GLSL
#define GP_SHADING_SLOPE_SHEARED_CAVITY_GLSL
#include "shading/slope/slopes.glsl"

// Share of the facets of slope s that w sees; mean: of the distribution.
float sheared_cavity_g1(vec2 mean, vec2 s, vec3 w) {
    float facing = slope_facing(s, w);
    return facing > 0.0f ? clamp(2.0f * slope_facing(mean, w) / facing, 0.0f, 1.0f) : 0.0f;
}

// Both directions: the deeper shadow counts. [Cook and Torrance 1982, ACM TOG 1(1)]
float sheared_cavity_g2(vec2 mean, vec2 s, vec3 wo, vec3 wi) {
    return min(sheared_cavity_g1(mean, s, wo), sheared_cavity_g1(mean, s, wi));
}

// From a slope of density P22 to one of density P22 G1 <w, m~> / A(w), those that w sees: the
// facet or its pair, by the area that each shows. u in [0, 1).
vec2 sheared_cavity_visible(vec2 mean, vec2 s, vec3 w, float u) {
    vec2 pair = 2.0f * mean - s;
    float facing = max(slope_facing(s, w), 0.0f);
    float pair_facing = max(slope_facing(pair, w), 0.0f);
    return u * (facing + pair_facing) < pair_facing ? pair : s;
}

#endif
