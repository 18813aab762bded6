// Smith's masking of Gaussian slopes about any mean: heights and slopes of neighbouring points are
// independent, and nothing else is assumed. A direction w sees a Gaussian of mean A(w) and of the
// deviation below along w, so that Beckmann's Lambda is all that is needed: the shear that takes
// the mean slope away turns w into (x, y, A(w)) and leaves heights, hence visibility, alone.
// Based on: Dupuy et al. 2013, "Linear Efficient Antialiased Displacement and Reflectance Mapping",
// section 4; height-correlated: Heitz 2014, JCGT 3(2).
#ifndef GP_SHADING_SLOPE_SMITH_SLOPES_GLSL
#define GP_SHADING_SLOPE_SMITH_SLOPES_GLSL
#include "shading/slope/slopes.glsl"

// Of a direction that sees nothing of the mesosurface: so large that masking is 0, and two of
// them still have a finite sum.
#define SMITH_LAMBDA_HIDDEN 1.0e30f

// Variance of s.x w.x + s.y w.y, which is that of slope_facing.
float slopes_variance_along(IN(Slopes) d, vec3 w) {
    return max(w.x * w.x * d.var_x + 2.0f * (w.x * w.y * d.cov) + w.y * w.y * d.var_y, 0.0f);
}

// Hidden area over visible area. [Dupuy et al. 2013, equation 10]
float slopes_smith_lambda(IN(Slopes) d, vec3 w) {
    float facing = slope_facing(d.mean, w);
    if (!(facing > 0.0f)) {
        return SMITH_LAMBDA_HIDDEN;
    }
    // Unit roughness: alpha^2 = 2 variance is in the direction.
    float across = sqrt(2.0f * slopes_variance_along(d, w));
    return beckmann_lambda(vec3(across, 0.0f, facing), 1.0f, 1.0f);
}

// Share of the facets turned towards w that w sees; the same for all of them.
float slopes_smith_g1(IN(Slopes) d, vec3 w) {
    return 1.0f / (1.0f + slopes_smith_lambda(d, w));
}

// What both see: a facet high up is likely to be seen by both. [Heitz 2014, equation 99]
float slopes_smith_g2(IN(Slopes) d, vec3 wo, vec3 wi) {
    return 1.0f / (1.0f + slopes_smith_lambda(d, wo) + slopes_smith_lambda(d, wi));
}

#endif
