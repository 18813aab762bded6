// Light from all sides on a distribution of slopes, as a sum over a few of its facets: for each of
// n x n slopes a direction to look up, the level of detail at which it stands for its share of the
// sphere, and a weight. Numbers in, numbers out: whoever has the environment reads it.
//   L_o = sum over nodes of F(dot(wo, m)) L(wi, lod) weight
// Based on: Dupuy et al. 2013, "Linear Efficient Antialiased Displacement and Reflectance Mapping",
// section 5; ours: nodes of equal weight, and the masking by V-cavities.
#ifndef GP_SHADING_SLOPE_SLOPE_ENVIRONMENT_GLSL
#define GP_SHADING_SLOPE_SLOPE_ENVIRONMENT_GLSL
#include "shading/slope/sheared_cavity.glsl"
#include "shading/slope/smith_slopes.glsl"

#define SLOPE_MASKING_V_CAVITY 0u
#define SLOPE_MASKING_SMITH 1u

// A number of the normal distribution, what it counts, and the width that it stands for.
struct NormalNode {
    float x;
    float weight;  // all of them: 1
    float width;
};

// Node i of n = 3, 4 or 5 (any other n is 5): the mean of the i-th of n parts of equal probability.
// Nodes of Gauss and Hermite, exact for polynomials, were off by 4 % on average where these, of
// n = 5, are off by 2.3 %: masking has kinks, and most of their directions count next to nothing.
// The spread within a part is the level of detail's.
NormalNode normal_node(uint n, uint i) {
    NormalNode node;
    uint j = min(i, n - 1u - i);  // from the end of its half
    if (n == 3u) {
        node.x = j == 0u ? 1.09079932f : 0.0f;
    } else if (n == 4u) {
        node.x = j == 0u ? 1.27110629f : 0.324662831f;
    } else {
        node.x = j == 0u ? 1.39980960f : (j == 1u ? 0.531903065f : 0.0f);
    }
    node.weight = 1.0f / float(n);
    node.width = node.weight * 2.50662827f * exp(0.5f * node.x * node.x);
    node.x = i < n - 1u - i ? -node.x : node.x;
    return node;
}

// One facet of the sum.
struct SlopeLight {
    vec3 wm;
    vec3 wi;            // may point below the horizon (wi.z < 0): what stands there is the caller's
    float weight;       // of F times the radiance from wi; 0 where wo or wi does not see the facet
    float solid_angle;  // of the light that this facet stands for, steradians
};

// Facet i of the n * n, n = 3, 4 or 5, that wo sees; masking: SLOPE_MASKING_. The frame is that of
// the geometry, and A(wo) must be above 0 (slope_mean_in_view).
SlopeLight slope_light(IN(Slopes) d, vec3 wo, uint n, uint i, uint masking) {
    NormalNode a = normal_node(n, i / n);
    NormalNode b = normal_node(n, i % n);
    float l_xx = sqrt(d.var_x);
    float l_xy = d.cov / l_xx;
    float l_yy = sqrt(max(d.var_y - l_xy * l_xy, 0.0f));
    vec2 s = d.mean + vec2(l_xx * a.x, l_xy * a.x + l_yy * b.x);
    float facing = slope_facing(s, wo);
    SlopeLight light;
    light.wm = facet_of(s);
    float cosine = facing * light.wm.z;
    light.wi = light.wm * (2.0f * cosine) - wo;
    light.weight = 0.0f;
    light.solid_angle = 0.0f;
    if (!(facing > 0.0f)) {
        return light;
    }
    float g2 = masking == SLOPE_MASKING_SMITH ? slopes_smith_g2(d, wo, light.wi)
                                              : sheared_cavity_g2(d.mean, s, wo, light.wi);
    light.weight = a.weight * b.weight * g2 * facing / slope_facing(d.mean, wo);
    // d wi = 4 (wo.m) d wm, and d wm = m.z^3 ds.
    float z2 = light.wm.z * light.wm.z;
    light.solid_angle =
        4.0f * cosine * z2 * light.wm.z * (l_xx * l_yy * a.width * b.width);
    return light;
}

// The level, 0 the finest, whose texels are as large as the light's solid angle; texel: steradians
// of one of the finest level, 4 pi / (6 res^2) on average for a cube.
float slope_light_lod(float solid_angle, float texel) {
    return 0.5f * log2(max(solid_angle / texel, 1.0f));
}

#endif
