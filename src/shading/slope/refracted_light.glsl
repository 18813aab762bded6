// Directions below a rough surface into which its facets refract light that comes from one
// direction: for choosing directions that may see that light, not for how much there is. Slopes are
// drawn as they are spread over horizontal area, whether the light can see them or not.
// Frame: that of the geometry; wl leads up to the light, w up to the surface.
#ifndef GP_SHADING_SLOPE_REFRACTED_LIGHT_GLSL
#define GP_SHADING_SLOPE_REFRACTED_LIGHT_GLSL
#include "shading/fresnel.glsl"
#include "shading/slope/slopes.glsl"

// Where, from below, the light is seen through a facet of a slope from d; `ior` is that below over
// that above, above 1. The zero vector where the facet is turned away from the light or from below.
vec3 refracted_light_sample(IN(Slopes) d, vec3 wl, float ior, vec2 u) {
    vec3 wm = facet_of(slopes_sample(d, u));
    float cos_l = dot(wl, wm);
    if (!(cos_l > 0.0f)) { return vec3(0.0f); }
    vec3 w = -refracted(wl, wm, ior, fresnel_g(cos_l, ior));
    return w.z > 0.0f ? w : vec3(0.0f);
}

// The density of w in solid angle; what the sample loses to the zero vector is not in it.
// [Walter et al. 2007, EGSR, equations 16 and 17]
float refracted_light_pdf(IN(Slopes) d, vec3 wl, float ior, vec3 w) {
    vec3 h = ior * w - wl;
    float square = dot(h, h);
    if (!(w.z > 0.0f) || !(square > 0.0f)) { return 0.0f; }
    vec3 wm = h * inversesqrt(square);
    float cos_w = dot(w, wm);
    if (!(wm.z > 1.0e-6f) || !(dot(wl, wm) > 0.0f) || !(cos_w > 0.0f)) { return 0.0f; }
    return slopes_p22(d, slope_of(wm)) * (ior * ior * cos_w / (square * wm.z * wm.z * wm.z));
}

#endif
