// Moments of slopes over an area: how they add up over texels, maps and scales, and how an image
// of them is read under the footprint of a pixel. The second moments are always central ones, the
// covariance about the mean of the same area: M - B B^T of the literature is a difference of equal
// numbers where |B| is above sigma (docs/water.md has the errors), while every step here adds what
// is positive.
// Based on: Olano and Baker 2010, "LEAN Mapping", I3D. What we do otherwise: central moments; the
// spread between texels that a linear read of raw moments would give is added when texels are
// mixed, so the results are the same numbers.
#ifndef GP_SHADING_SLOPE_LEAN_GLSL
#define GP_SHADING_SLOPE_LEAN_GLSL
#include "shading/slope/footprint.glsl"
#include "shading/slope/slopes.glsl"

// Steeper slopes of a map (86 degrees) are cut: one broken texel must not widen a whole level.
#define SLOPE_LIMIT 16.0f
// Probes along the footprint; a longer one is read from coarser levels.
#define SLOPE_PROBES 16.0f

// A texel of such an image, 16 bytes.
struct SlopeTexel {
    float mean_x;
    float mean_y;
    uint deviations;    // two half floats: of the standard deviation a half keeps 3 digits down
                        // to 6e-5, of the variance only down to the square root of that
    float correlation;  // -1..1
};

// A mirror of this slope, and the identity of slopes_added.
Slopes slopes_constant(vec2 mean) {
    Slopes s;
    s.mean = mean;
    s.var_x = 0.0f;
    s.var_y = 0.0f;
    s.cov = 0.0f;
    return s;
}

// The slopes of (1 - t) of an area with a and t of it with b: exact, however they overlap.
// [Chan, Golub, LeVeque 1983, "Algorithms for Computing the Sample Variance", equation 2.1b]
Slopes slopes_mixed(IN(Slopes) a, IN(Slopes) b, float t) {
    vec2 step = b.mean - a.mean;
    float between = t * (1.0f - t);
    Slopes s;
    s.mean = a.mean + step * t;
    s.var_x = mix(a.var_x, b.var_x, t) + between * step.x * step.x;
    s.var_y = mix(a.var_y, b.var_y, t) + between * step.y * step.y;
    s.cov = mix(a.cov, b.cov, t) + between * step.x * step.y;
    return s;
}

// The sum of two height fields whose slopes know nothing of each other (a map over a map, a rough
// surface on a wave). [Olano and Baker 2010, section 4.3; the term of the means is in the mean]
Slopes slopes_added(IN(Slopes) a, IN(Slopes) b) {
    Slopes s;
    s.mean = a.mean + b.mean;
    s.var_x = a.var_x + b.var_x;
    s.var_y = a.var_y + b.var_y;
    s.cov = a.cov + b.cov;
    return s;
}

// Heights times k.x over lengths along x, k.y over those along y: the slopes' own factors.
Slopes slopes_scaled(IN(Slopes) a, vec2 k) {
    Slopes s;
    s.mean = a.mean * k;
    s.var_x = a.var_x * k.x * k.x;
    s.var_y = a.var_y * k.y * k.y;
    s.cov = a.cov * k.x * k.y;
    return s;
}

// In a frame whose tangent is turned by the angle of this cosine and sine.
Slopes slopes_turned(IN(Slopes) a, float c, float s) {
    Slopes t;
    t.mean = vec2(c * a.mean.x + s * a.mean.y, c * a.mean.y - s * a.mean.x);
    t.var_x = c * c * a.var_x + 2.0f * c * s * a.cov + s * s * a.var_y;
    t.var_y = s * s * a.var_x - 2.0f * c * s * a.cov + c * c * a.var_y;
    t.cov = (c * c - s * s) * a.cov + c * s * (a.var_y - a.var_x);
    return t;
}

// Of the same surface from its back, with normal and bitangent turned round.
Slopes slopes_of_back(IN(Slopes) a) {
    return slopes_scaled(a, vec2(-1.0f, 1.0f));
}

// The slope that a normal map's texel stands for; zero where it is not finite.
vec2 slope_from_texel(vec3 n) {
    vec2 s = vec2(-n.x, -n.y) / max(n.z, 1.0e-3f);
    float l = length(s);
    if (!(l <= 1.0e30f)) { return vec2(0.0f); }
    return l > SLOPE_LIMIT ? s * (SLOPE_LIMIT / l) : s;
}

SlopeTexel slope_texel_encode(IN(Slopes) s) {
    vec2 deviations = vec2(sqrt(max(s.var_x, 0.0f)), sqrt(max(s.var_y, 0.0f)));
    float product = deviations.x * deviations.y;
    SlopeTexel t;
    t.mean_x = s.mean.x;
    t.mean_y = s.mean.y;
    t.deviations = packHalf2x16(deviations);
    t.correlation = product > 0.0f ? clamp(s.cov / product, -1.0f, 1.0f) : 0.0f;
    return t;
}

Slopes slope_texel_decode(IN(SlopeTexel) t) {
    vec2 deviations = unpackHalf2x16(t.deviations);
    Slopes s;
    s.mean = vec2(t.mean_x, t.mean_y);
    s.var_x = deviations.x * deviations.x;
    s.var_y = deviations.y * deviations.y;
    s.cov = t.correlation * deviations.x * deviations.y;
    return s;
}

// How a footprint is read: `count` probes at uv + (i - (count - 1) / 2) step, at this level of
// detail (0: the image itself).
struct SlopeProbes {
    vec2 step;
    float level;
    int count;
};

// d0, d1: change of uv per pixel along two axes; size: of the image, texels. The footprint is the
// ellipse of both; its short axis chooses the level, probes go along the long one.
// [McCormack et al. 1999, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping", 3.1]
SlopeProbes slope_probes(vec2 d0, vec2 d1, vec2 size) {
    FootprintEllipse e = footprint_ellipse(d0 * size, d1 * size);
    // Nothing is finer than a texel.
    float across = max(max(e.minor, e.major / SLOPE_PROBES), 1.0f);
    float count = clamp(ceil(e.major / across - 1.0e-3f), 1.0f, SLOPE_PROBES);
    SlopeProbes p;
    p.count = int(count);
    p.level = log2(across);
    p.step = e.axis * (e.major / count) / size;
    return p;
}

// Texel i of n under a texture's wrap mode: 0 repeat, 1 clamp, 2 mirror (gp::Wrap).
int wrapped_texel(int i, int n, uint wrap) {
    if (i >= 0 && i < n) { return i; }
    if (wrap == 1u) { return i < 0 ? 0 : n - 1; }
    int period = wrap == 2u ? 2 * n : n;
    int k = i % period;
    k = k < 0 ? k + period : k;
    return k < n ? k : period - 1 - k;
}

#endif
