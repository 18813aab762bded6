// Surfaces as distributions of slopes. A facet m with m.z > 0 has the slope s = -(m.x, m.y) / m.z;
// P22(s) is the density of slopes over the horizontal area, D(m) = P22(s) / m.z^4 that of normals.
// The frame is that of the geometry, and the mean slope need not be zero: it is that of the
// mesosurface (a normal map, a wave) within the footprint.
// Based on: Dupuy et al. 2013, "Linear Efficient Antialiased Displacement and Reflectance Mapping".
#ifndef GP_SHADING_SLOPE_SLOPES_GLSL
#define GP_SHADING_SLOPE_SLOPES_GLSL
#include "shading/constants.glsl"
#include "shading/powers.glsl"
#include "shading/microfacet/beckmann.glsl"

// Gaussian slopes about a mean: Beckmann's distribution, sheared.
struct Slopes {
    vec2 mean;
    float var_x;  // variances, alpha^2 / 2; both above 0
    float var_y;
    float cov;    // |cov| < sqrt(var_x var_y)
};

vec2 slope_of(vec3 wm) {
    return vec2(-wm.x / wm.z, -wm.y / wm.z);
}

vec3 facet_of(vec2 s) {
    return normalize(vec3(-s.x, -s.y, 1.0f));
}

// Area, per horizontal area, that facets of slope s show to w; of the mean slope, it is the
// projected area of the mesosurface: A(w) of the literature.
// [Dupuy et al. 2013, section 4]
float slope_facing(vec2 s, vec3 w) {
    return w.z - w.x * s.x - w.y * s.y;
}

// [Dupuy et al. 2013, equation 6]
float slopes_p22(IN(Slopes) d, vec2 s) {
    vec2 c = s - d.mean;
    float det = d.var_x * d.var_y - d.cov * d.cov;
    float e = (c.x * c.x * d.var_y - 2.0f * c.x * c.y * d.cov + c.y * c.y * d.var_x) / det;
    float height = (0.5f * INV_PI) * inversesqrt(det);
    return e < 160.0f ? exp2_within_126(-0.5f / LN_TWO * e) * height : 0.0f;
}

// Two numbers of the normal distribution.
vec2 gaussian_pair(vec2 u) {
    vec2 x = vec2(clamp(2.0f * u.x - 1.0f, -0.9999999f, 0.9999999f),
                  clamp(2.0f * u.y - 1.0f, -0.9999999f, 0.9999999f));
    return vec2(erf_inverse(x.x), erf_inverse(x.y)) * 1.41421356f;
}

// A slope with the density P22: the Cholesky factor of the covariance times normal numbers.
vec2 slopes_sample(IN(Slopes) d, vec2 u) {
    vec2 n = gaussian_pair(u);
    float l_xx = sqrt(d.var_x);
    float l_xy = d.cov / l_xx;
    float l_yy = sqrt(max(d.var_y - l_xy * l_xy, 0.0f));
    return d.mean + vec2(l_xx * n.x, l_xy * n.x + l_yy * n.y);
}

#endif
