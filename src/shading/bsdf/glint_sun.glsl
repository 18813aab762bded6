// Suns over surfaces of slopes (the model `glint`, the sea): their disc as slopes of the surface,
// so that one evaluation has all of its light.
#ifndef GP_SHADING_BSDF_GLINT_SUN_GLSL
#define GP_SHADING_BSDF_GLINT_SUN_GLSL
#include "shading/bsdf/bsdf.glsl"
#include "shading/light/directional.glsl"
#include "shading/slope/mean_slope.glsl"
#include "shading/slope/sun_disc.glsl"

// Below this sum of cosines of light and view no facet that matters reflects one into the other,
// and the spread of those that do has no bound.
#define SUN_LEAST_HEIGHT 1.0e-3f

// How many times wider than the disc (in slopes, seen from above) the narrowest slopes of a surface
// are, as variances, that the disc may be taken for a Gaussian: the highlight is then up to 3 % too
// bright in the middle.
#define SUN_LEAST_SPREAD 4.0f

// sin^2 of the disc's angular radius.
float sun_sin_squared(IN(DirectionalLight) sun) {
    return sun.one_minus_cos_max * (2.0f - sun.one_minus_cos_max);
}

// A pixel's kernel (as slot_e) with a covariance (xx, yy, xy) added: slopes get it, glints are
// blurred by it, each cell's own.
vec4 glint_kernel_with(vec4 kernel, vec3 covariance) {
    vec3 k = ndf_kernel(vec2(kernel.x, kernel.y), vec2(kernel.z, kernel.w)) * 0.5f;
    k = (k + covariance) * (1.0f / NDF_PIXEL_VARIANCE);
    // Two changes that have this covariance: the columns of its Cholesky factor.
    float xx = sqrt(max(k.x, 0.0f));
    float yx = xx > 0.0f ? k.z / xx : 0.0f;
    return vec4(xx, yx, 0.0f, sqrt(max(k.y - yx * yx, 0.0f)));
}

// Whether that leaves the highlight what it is.
bool slopes_hide_disc(IN(BsdfParams) m, IN(DirectionalLight) sun) {
    Slopes d = glint_of(m).slopes;
    float disc = SUN_LEAST_SPREAD * sun_sin_squared(sun) * (1.0f / 16.0f);
    // The determinant over the trace is at most the narrower of the two principal variances.
    return d.var_x * d.var_y - d.cov * d.cov >= disc * (d.var_x + d.var_y);
}

// What of f cos is the matte base's, under the facets.
vec3 slopes_matte_part(IN(BsdfParams) m, vec3 wo_local, vec3 wi_local) {
    if (glint_is_black(m, wo_local)) { return vec3(0.0f); }
    GlintView seen = glint_view(m, wo_local);
    vec3 i = seen.turned ? glint_turned(m, wi_local) : wi_local;
    vec2 mean = seen.g.slopes.mean;
    if (!seen.has_base || !(slope_facing(mean, i) > 0.0f)) { return vec3(0.0f); }
    vec3 base = glint_base_eval(m, seen, i).f_cos;
    return has_layers(m) ? base * glint_layers_through(m, seen.over, mean, seen.turned, i) : base;
}

// What of it is not the facets': that, and what layers over them add. disc: see coat_eval_disc.
vec3 slopes_part_without_facets(IN(BsdfParams) m, float disc, vec3 wo_local, vec3 wi_local) {
    vec3 matte = slopes_matte_part(m, wo_local, wi_local);
    if (!has_layers(m) || glint_is_black(m, wo_local)) { return matte; }
    GlintView seen = glint_view(m, wo_local);
    seen.over.layers.disc = disc;
    vec3 i = seen.turned ? glint_turned(m, wi_local) : wi_local;
    return matte + glint_under_layers(m, seen.over, seen.g.slopes.mean, seen.turned, i,
                                      bsdf_no_value()).f_cos;
}

// Whether sun_facets are what a surface reflects of a sun, wi_local to its middle.
bool reflects_sun(IN(BsdfParams) m, vec3 wo_local, vec3 wi_local, IN(DirectionalLight) sun) {
    if (m.model != MODEL_GLINT || !(sun.one_minus_cos_max > 0.0f)) { return false; }
    vec2 mean = glint_mean(m);
    return slope_facing(mean, wo_local) > 0.0f && slope_facing(mean, wi_local) > 0.0f &&
           wo_local.z + wi_local.z >= SUN_LEAST_HEIGHT;
}

// What reflects a sun: its kernel is wider by the slopes that the disc takes, which has the same
// light, and the same variance of the highlight.
struct SunFacets {
    vec4 kernel;      // in the place of the material's own
    GlintFacet facet;
};

// material: its slopes, kernel: its slot_e. Without branches, so that loops become vectors.
SunFacets sun_facets(IN(Slopes) material, vec4 kernel, uint masking, vec3 wo_local, vec3 wi_local,
                     float sin_radius) {
    SunFacets s;
    s.kernel =
        glint_kernel_with(kernel, sun_slope_covariance(wo_local, wi_local, sin_radius));
    Slopes d = glint_kernel_added(material, vec2(s.kernel.x, s.kernel.y),
                                  vec2(s.kernel.z, s.kernel.w));
    s.facet = glint_reflection(masking, d, wo_local, wi_local);
    return s;
}

// Of the facets that are there: their density of slopes over that of glint_density, by which the
// highlight of smooth ones is a disc's sharp image where they are narrower than it, as that of a
// coat is. Glints keep the Gaussian, as their cells are made for covariances.
float sun_shape(IN(BsdfParams) m, vec3 wo_local, vec3 wi_local, IN(DirectionalLight) sun) {
    if (glint_method(m) != GLINT_SMOOTH) { return 1.0f; }
    return sun_disc_shape(glint_of(m).slopes, wo_local, wi_local, sqrt(sun_sin_squared(sun)));
}

float sun_facet_density(IN(BsdfParams) m, IN(SunFacets) s, vec3 wo_local, vec3 wi_local,
                        IN(DirectionalLight) sun) {
    GlintDensity p22 = glint_density(glint_method(m), glint_of(m, s.kernel), s.facet.slope);
    return p22.value * sun_shape(m, wo_local, wi_local, sun);
}

// How the facets that stand in the dictionary are found.
IN_LOOPS GlintLookup sun_lookup(IN(BsdfParams) m, IN(SunFacets) s) {
    return glint_lookup(glint_of(m, s.kernel), s.facet.slope);
}

// f cos of a sun where no layer and no film lies over the facets: `facets` times their
// sun_facet_density, and `matte`.
struct SunShares {
    vec3 facets;
    vec3 matte;
};

bool has_sun_shares(IN(BsdfParams) m) {
    return !has_layers(m) && m.iridescence <= 0.0f;
}

// Without branches, so that loops become vectors.
SunShares sun_shares(IN(BsdfParams) m, IN(GlintFacet) facet, vec3 wo_local, vec3 wi_local) {
    GlintView seen;
    seen.g.slopes.mean = glint_mean(m);
    seen.eta = relative_ior(m.ior, 1.0f);
    seen.through = glint_through(m, mesosurface_cosine(seen.g.slopes.mean, wo_local));
    float cos_t = glint_cos_behind(m, facet.cos_h, seen.eta);
    SunShares shares;
    shares.facets = glint_fresnel(m, facet.cos_h, cos_t, seen.eta).reflected * facet.f_cos;
    shares.matte = glint_base_eval(m, seen, wi_local).f_cos;  // of no colour where there is none
    return shares;
}

// f cos of a sun.
vec3 sun_facets_f_cos(IN(BsdfParams) m, IN(SunFacets) s, vec3 wo_local, vec3 wi_local,
                      IN(DirectionalLight) sun) {
    float disc = sun.one_minus_cos_max;
    GlintView seen = glint_view(m, s.kernel, wo_local);
    seen.over.layers.disc = disc;
    vec3 f_cos = glint_facet_value(m, seen, s.facet, wi_local, true, false).f_cos;
    float shape = sun_shape(m, wo_local, wi_local, sun);
    if (shape == 1.0f) { return f_cos; }
    vec3 rest = slopes_part_without_facets(m, disc, wo_local, wi_local);
    return rest + (f_cos - rest) * shape;
}

vec3 sun_f_cos(IN(BsdfParams) m, vec3 wo_local, vec3 wi_local, IN(DirectionalLight) sun) {
    if (!reflects_sun(m, wo_local, wi_local, sun)) {
        return bsdf_eval(m, wo_local, wi_local).f_cos;
    }
    SunFacets s = sun_facets(glint_material_slopes(m), m.slot_e, glint_masking(m), wo_local,
                             wi_local, sqrt(sun_sin_squared(sun)));
    return sun_facets_f_cos(m, s, wo_local, wi_local, sun);
}

#endif
