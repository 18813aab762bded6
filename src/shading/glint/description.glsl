// What is known of the glints within a footprint, and the limits within which it is read.
#ifndef GP_SHADING_GLINT_DESCRIPTION_GLSL
#define GP_SHADING_GLINT_DESCRIPTION_GLSL
#include "shading/slope/ndf_filtering.glsl"
#include "shading/slope/slopes.glsl"

// All zero but the slopes: the plain Gaussian. Whatever is not finite or beyond these limits is
// read as the nearest number within them; NaN as "nothing": no facets, no kernel, no correlation.
struct Glint {
    Slopes slopes;      // mean and covariance of everything: material, maps, footprint kernel;
                        // variances 1e-8 … 1e4, correlation within +-0.999
    vec2 uv;            // texture position; density counts facets by its unit area
    vec2 d0;            // change of uv per pixel along the two axes of the footprint; both may be 0
    vec2 d1;
    float log_density;  // natural logarithm of facets per unit area of uv, of the share of the
                        // surface that carries them; -60 … 60
    float area;         // that share, 0 … 1; the rest is smooth (below 1e-5: all)
    float jitter;       // of the density from cell to cell: standard deviation in levels (factors
                        // of 4), evenly distributed; 0 … 3
    vec2 k0;            // kernel: change of the half vector's slope along the pixel's two axes; its
    vec2 k1;            // covariance (glint_kernel_added) is in slopes already
    uvec2 dictionary;   // scene/glint_dictionary.h, a table of lang.h; 0: plain Gaussian
    uint seed;
};

#define GLINT_LEAST_VARIANCE 1.0e-8f
#define GLINT_LARGEST_VARIANCE 1.0e4f
#define GLINT_LARGEST_CORRELATION 0.999f
#define GLINT_LEAST_AREA 1.0e-5f
#define GLINT_LARGEST_LOG_DENSITY 60.0f
#define GLINT_LARGEST_JITTER 3.0f

// Comparisons with NaN are false, hence their form.
float glint_limited(float x, float lowest, float highest) {
    return x > lowest ? min(x, highest) : lowest;
}

Slopes glint_slopes_within(IN(Glint) g) {
    Slopes d;
    d.mean = g.slopes.mean;
    d.var_x = glint_limited(g.slopes.var_x, GLINT_LEAST_VARIANCE, GLINT_LARGEST_VARIANCE);
    d.var_y = glint_limited(g.slopes.var_y, GLINT_LEAST_VARIANCE, GLINT_LARGEST_VARIANCE);
    float limit = GLINT_LARGEST_CORRELATION * sqrt(d.var_x * d.var_y);
    bool inside = abs(g.slopes.cov) <= limit;
    float nearest = g.slopes.cov > 0.0f ? limit : (g.slopes.cov < 0.0f ? -limit : 0.0f);
    d.cov = inside ? g.slopes.cov : nearest;
    return d;
}

// The slopes with what the pixel's kernel adds: it is part of the surface that the pixel sees.
Slopes glint_kernel_added(IN(Slopes) d, vec2 k0, vec2 k1) {
    return slopes_widened(d, ndf_kernel(k0, k1) * 0.5f);
}

// Slopes in units of their own spread: the covariance becomes the identity, so that what is known
// of the standard normal distribution holds for any. [Chermain et al. 2021, "Real-Time Geometric
// Glint Anti-Aliasing with Normal Map Filtering", section 4; by the Cholesky factor]
struct Whitening {
    float xx;   // the lower triangle of the inverse of the factor
    float yx;
    float yy;
};

Whitening whitening_of(IN(Slopes) d) {
    float l_xx = sqrt(d.var_x);
    float l_yx = d.cov / l_xx;
    float l_yy = sqrt(max(d.var_y - l_yx * l_yx, 1.0e-3f * GLINT_LEAST_VARIANCE));
    Whitening w;
    w.xx = 1.0f / l_xx;
    w.yy = 1.0f / l_yy;
    w.yx = -l_yx * w.xx * w.yy;
    return w;
}

vec2 whitened(IN(Whitening) w, vec2 v) {
    return vec2(w.xx * v.x, w.yx * v.x + w.yy * v.y);
}

vec2 unwhitened(IN(Whitening) w, vec2 v) {
    float x = v.x / w.xx;
    return vec2(x, (v.y - w.yx * x) / w.yy);
}

#endif
