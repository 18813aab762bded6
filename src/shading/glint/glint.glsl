// Glints: the slopes of the single facets that a footprint holds. A surface of countable facets has
// the distribution of its slopes only on average; what a pixel sees are the facets in it.
// Conventions of slopes are those of slope/slopes.glsl: the frame is that of the geometry.
// Based on: Chermain et al. 2020, "Procedural Physically based BRDF for Real-Time Rendering of
// Glints", Computer Graphics Forum 39(7).
#ifndef GP_SHADING_GLINT_GLINT_GLSL
#define GP_SHADING_GLINT_GLINT_GLSL
#include "shading/slope/slopes.glsl"

// What a footprint shows. All zero but the slopes is the plain Gaussian.
struct Glint {
    Slopes slopes;      // mean and covariance of everything: material, maps, footprint kernel
    vec2 uv;            // texture position; density counts facets by its unit area
    vec2 d0;            // change of uv per pixel along the two axes of the footprint
    vec2 d1;
    float log_density;  // natural logarithm of facets per unit area of uv
    float area;         // share of the surface that carries facets, 0 … 1; the rest is smooth
    float jitter;       // of the density from cell to cell: standard deviation in levels (of 4)
    vec2 k0;            // kernel: change of the half vector's slope along the pixel's two axes
    vec2 k1;
    uvec2 dictionary;   // table of lang.h; 0: none, plain Gaussian
    uint seed;
};

// Density of slopes (not centred) over the footprint, per horizontal area.
float glint_p22(IN(Glint) g, vec2 s) {
    return slopes_p22(g.slopes, s);
}

// A slope with the density glint_p22, which is symmetric about g.slopes.mean. All numbers uniform.
vec2 glint_sample(IN(Glint) g, vec2 u, float) {  // the last chooses the cell, once there are cells
    return slopes_sample(g.slopes, u);
}

#endif
