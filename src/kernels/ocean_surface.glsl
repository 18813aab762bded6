// The sea at one point: all waves within the footprint as a distribution of slopes about a mean,
// over the plane of the water at rest. The triangles of the sea (scene/sea.h) only show what they
// can; they say where a ray met the water, not which way the water there is turned.
// Resources: sample_sea, and those of library_material.glsl.
#ifndef GP_KERNELS_OCEAN_SURFACE_GLSL
#define GP_KERNELS_OCEAN_SURFACE_GLSL
#include "kernels/library_material.glsl"
#include "shading/slope/slopes.glsl"

// Of fresh foam. [Koepke 1984, "Effective reflectance of oceanic whitecaps", Applied Optics 23(11)]
#define FOAM_ALBEDO 0.55f
// The mean slope shows at least so much of itself to the viewer: floats end not far below.
#define SEA_LEAST_FACING 1.0e-4f

// x towards +X, y towards -Z, up: the frame of scene/sea.h.
Frame sea_frame() {
    Frame f;
    f.t = vec3(1.0f, 0.0f, 0.0f);
    f.b = vec3(0.0f, 0.0f, -1.0f);
    f.n = vec3(0.0f, 1.0f, 0.0f);
    return f;
}

// A pixel may show the edge of a wave whose mean slope, over all of the footprint, is turned away
// from the viewer. It is then turned back, no farther than needed; masking stays right for any
// mean, so that no light is made. `side`: 1 from above, -1 from below.
vec2 seen_slope(vec2 mean, vec3 wo, float side) {
    float missing = SEA_LEAST_FACING - side * slope_facing(mean, wo);
    vec2 across = vec2(wo.x, wo.y);
    float square = dot(across, across);
    return missing > 0.0f && square > 1.0e-12f ? mean - across * (side * missing / square) : mean;
}

// Where the ray's cone meets the plane at rest: as wide as the cone, and longer towards the viewer.
SeaSlopes sea_slopes_seen(IN(Surface) s, vec3 wo) {
    vec2 along = vec2(wo.x, wo.y);
    float l = length(along);
    along = l > 1.0e-6f ? along / l : vec2(1.0f, 0.0f);
    float width = max(s.width, 1.0e-6f);
    vec2 d0 = along * (width / max(abs(wo.z), 1.0e-4f));
    return sample_sea(s.uv0, d0, vec2(-along.y, along.x) * width);
}

// Out of line, as all materials of the library. load_bsdf(m.bsdf) has the albedo of the water, of
// what comes back from below, as its base colour.
OUT_OF_LINE ShadingPoint ocean_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo) {
    ShadingPoint p;
    p.frame = sea_frame();
    p.emission = vec3(0.0f);
    p.attenuation = m.attenuation;
    p.flags = m.flags;
    vec3 wo_local = local_from_world(p.frame, wo);
    SeaSlopes sea = sea_slopes_seen(s, wo_local);
    vec2 mean = seen_slope(sea.mean, wo_local, s.front != 0u ? 1.0f : -1.0f);
    p.bsdf = load_bsdf(m.bsdf);
    // A matte share as large as its albedo, and all else clear: so that the exact Fresnel term
    // reflects, which is that of clear bodies.
    vec3 matte = mix(p.bsdf.base_color, vec3(FOAM_ALBEDO), clamp(sea.foam, 0.0f, 1.0f));
    float share = max_component(matte);
    p.bsdf.base_color = share > 0.0f ? matte / share : vec3(1.0f);
    p.bsdf.transmission = 1.0f - share;
    p.bsdf.alpha_x = max(sqrt(2.0f * sea.var_x), BSDF_MIN_ALPHA);
    p.bsdf.alpha_y = max(sqrt(2.0f * sea.var_y), BSDF_MIN_ALPHA);
    float spread = sqrt(sea.var_x * sea.var_y);
    p.bsdf.slot_a.x = mean.x;
    p.bsdf.slot_a.y = mean.y;
    p.bsdf.slot_a.z = spread > 0.0f ? sea.cov / spread : 0.0f;
    return p;
}

#endif
