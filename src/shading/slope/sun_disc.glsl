// A sun with a disc on Gaussian slopes: what it gives is the density of slopes, averaged over the
// slopes that reflect some point of the disc. Where slopes are wide that is a Gaussian again, with
// the disc's variance added (sun_slope_covariance); where they are narrow it is the disc's sharp
// image. Here is the factor from one to the other.
// Directions to the disc are mapped to slopes as sun_slope_covariance does, to first order. In
// radii of the disc the average is the share of a Gaussian that lies within the unit disc.
#ifndef GP_SHADING_SLOPE_SUN_DISC_GLSL
#define GP_SHADING_SLOPE_SUN_DISC_GLSL
#include "shading/frame.glsl"
#include "shading/slope/ndf_filtering.glsl"

// From this deviation on, in radii, the Gaussian is as good: off by 0.4 % at most.
#define SUN_DISC_WIDE 1.5f
// Below, the edge is as sharp as float can have it.
#define SUN_DISC_NARROWEST 1.0e-3f

// Two strips of the disc, at the middle +- offset: the Gaussian's share in each by its width.
float disc_strips(vec2 at, float narrow, float wide, float middle, float offset) {
    float sum = 0.0f;
    for (int i = 0; i < 2; ++i) {
        float x = i == 0 ? middle - offset : middle + offset;
        float z = (x - at.x) / narrow;
        float h = sqrt(max(1.0f - x * x, 0.0f));
        float scale = 0.70710678f / wide;
        sum += exp(-0.5f * z * z) *
               (erf_approximation((h - at.y) * scale) + erf_approximation((h + at.y) * scale));
    }
    return sum;
}

// The share of a Gaussian about `at`, of deviations narrow <= wide along x and y, that lies within
// the unit disc; at least 0 along both. Six strips [Gauss] of where the narrow side has its light,
// exact along the wide one: off by less than 0.5 % of all, at the rim of the sharpest by 5 %.
float gaussian_in_disc(vec2 at, float narrow, float wide) {
    float low = max(min(at.x, 1.0f) - 3.0f * narrow, -1.0f);
    float high = min(at.x + 3.0f * narrow, 1.0f);
    float middle = 0.5f * (low + high);
    float half_width = 0.5f * (high - low);
    float sum = 0.467913935f * disc_strips(at, narrow, wide, middle, 0.238619186f * half_width)
              + 0.360761573f * disc_strips(at, narrow, wide, middle, 0.661209386f * half_width)
              + 0.171324492f * disc_strips(at, narrow, wide, middle, 0.932469514f * half_width);
    return max(0.199471140f * sum * half_width / narrow, 0.0f);
}

// That share over what it is where the disc counts as a Gaussian of its variance, 1/4 of a radius
// squared along each axis. 0 outside of the disc's image, where nothing is left of the light.
float disc_over_gaussian(vec2 at, float narrow, float wide) {
    if (narrow >= SUN_DISC_WIDE) { return 1.0f; }
    if (at.x > 1.0f + 6.0f * narrow || at.y > 1.0f + 6.0f * wide) { return 0.0f; }
    float n2 = narrow * narrow + 0.25f;
    float w2 = wide * wide + 0.25f;
    float e = at.x * at.x / n2 + at.y * at.y / w2;
    float gaussian = 0.5f * inversesqrt(n2 * w2) * exp(-0.5f * e);
    bool inside = length(at) + 4.0f * wide <= 1.0f;
    return (inside ? 1.0f : gaussian_in_disc(at, narrow, wide)) / gaussian;
}

// What slopes d reflect of a disc of the angular radius (radians, above 0) about wi into wo, over
// what they do when widened by sun_slope_covariance. wo and wi: unit length, (wo + wi).z > 0.
float sun_disc_shape(IN(Slopes) d, vec3 wo, vec3 wi, float radius) {
    Frame f = frame_from_normal(wi);
    vec2 a = slope_change(wo + wi, f.t) * radius;
    vec2 b = slope_change(wo + wi, f.b) * radius;
    // By the least eigenvalue of one and the largest of the other, whatever their axes.
    float det_d = d.var_x * d.var_y - d.cov * d.cov;
    float spread = a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y;
    bool wide = det_d >= SUN_DISC_WIDE * SUN_DISC_WIDE * spread * (d.var_x + d.var_y);
    float det = a.x * b.y - a.y * b.x;
    if (wide || abs(det) < 1.0e-18f) { return 1.0f; }
    // Rows of the inverse of (a, b): from slopes to radii of the disc.
    vec2 p = vec2(b.y, -b.x) / det;
    vec2 q = vec2(-a.y, a.x) / det;
    vec2 s = slope_of(wo + wi) - d.mean;
    vec2 at = vec2(dot(p, s), dot(q, s));
    vec2 sp = vec2(d.var_x * p.x + d.cov * p.y, d.cov * p.x + d.var_y * p.y);
    vec2 sq = vec2(d.var_x * q.x + d.cov * q.y, d.cov * q.x + d.var_y * q.y);
    PrincipalWidths w = principal_widths(vec3(dot(p, sp), dot(q, sq), dot(p, sq)));
    float narrow = max(w.alpha_y, SUN_DISC_NARROWEST);
    float along = abs(dot(at, w.axis));
    float across = abs(at.x * w.axis.y - at.y * w.axis.x);
    return disc_over_gaussian(vec2(across, along), narrow, max(w.alpha_x, narrow));
}

#endif
