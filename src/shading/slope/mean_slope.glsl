// What is done to distributions of slopes before they are shaded: a mean that the viewer could not
// see, and the width that the sun adds.
#ifndef GP_SHADING_SLOPE_MEAN_SLOPE_GLSL
#define GP_SHADING_SLOPE_MEAN_SLOPE_GLSL
#include "shading/slope/slopes.glsl"

// Projected area that is left to a mesosurface turned away, over that of the geometry. Smaller
// would be as good for energy; below 1e-5 A(wo) has no digits left in float.
#define SLOPE_LEAST_FACING 1.0e-3f

// The mean slope, pulled back along the view's azimuth until wo (unit length, not straight below)
// sees the mesosurface: A(wo) > 0. Normal maps and filtered means can turn a surface away although
// its geometry is in sight; waves that are really displaced cannot. Any mean keeps the identity of
// visible area, so energy is bounded, but the reflectance is not reciprocal there.
vec2 slope_mean_in_view(vec2 mean, vec3 wo) {
    float least = SLOPE_LEAST_FACING * max(wo.z, SLOPE_LEAST_FACING);
    float missing = least - slope_facing(mean, wo);
    float r2 = wo.x * wo.x + wo.y * wo.y;
    return missing > 0.0f && r2 > 0.0f ? mean - vec2(wo.x, wo.y) * (missing / r2) : mean;
}

// Covariance (xx, yy, xy) that is added to slopes.
Slopes slopes_widened(IN(Slopes) d, vec3 covariance) {
    Slopes wider = d;
    wider.var_x += covariance.x;
    wider.var_y += covariance.y;
    wider.cov += covariance.z;
    return wider;
}

// The slope of the facet that reflects wi into wo moves by this where wi moves by t.
// From s = -v.xy / v.z of the unnormalised half vector v = wo + wi.
vec2 slope_change(vec3 v, vec3 t) {
    vec2 s = slope_of(v);
    return vec2(-(t.x + s.x * t.z) / v.z, -(t.y + s.y * t.z) / v.z);
}

// Covariance (xx, yy, xy) of the slopes that reflect some point of a disc-shaped light, of the
// angular radius (radians, small) about wi, into wo; (wo + wi).z > 0. A uniform disc has the
// variance r^2 / 4 along each axis; where wo = wi is the normal, r^2 / 16 is left of it, and the
// more of it the more light grazes: across the plane of wo and wi slopes turn by half of wi's
// angle over the cosine between them.
vec3 sun_slope_covariance(vec3 wo, vec3 wi, float radius) {
    vec3 helper = abs(wi.z) < 0.9f ? vec3(0.0f, 0.0f, 1.0f) : vec3(1.0f, 0.0f, 0.0f);
    vec3 t = normalize(cross(helper, wi));
    vec2 a = slope_change(wo + wi, t);
    vec2 b = slope_change(wo + wi, cross(wi, t));
    float variance = 0.25f * radius * radius;
    return vec3(a.x * a.x + b.x * b.x, a.y * a.y + b.y * b.y, a.x * a.y + b.x * b.y) * variance;
}

#endif
