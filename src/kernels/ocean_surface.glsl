// The sea at one point: all waves within the footprint as a distribution of slopes about a mean,
// over the plane of the water at rest. The triangles of the sea (scene/sea.h) only show what they
// can; they say where a ray met the water, not which way the water there is turned.
// Resources: sample_sea, and those of library_material.glsl.
#ifndef GP_KERNELS_OCEAN_SURFACE_GLSL
#define GP_KERNELS_OCEAN_SURFACE_GLSL
#include "kernels/library_material.glsl"
#include "kernels/sea_frame.glsl"
#include "shading/slope/mean_slope.glsl"

// Of fresh foam. [Koepke 1984, "Effective reflectance of oceanic whitecaps", Applied Optics 23(11)]
#define FOAM_ALBEDO 0.55f

// What a pixel shows of the plane at rest, and how its half vectors differ.
struct SeaFootprint {
    vec2 d0;   // sides of a parallelogram, metres
    vec2 d1;
    vec2 k0;   // change of the slope of the half vector along them: that of the view, as the waves
    vec2 k1;   // within the footprint are in its slopes already
};

// Where the ray's cone meets the plane: as wide as the cone, and longer towards the viewer.
SeaFootprint sea_footprint(IN(RayCone) cone, vec3 wo) {
    vec2 along = vec2(wo.x, wo.y);
    float l = length(along);
    along = l > 1.0e-6f ? along / l : vec2(1.0f, 0.0f);
    vec2 across = vec2(-along.y, along.x);
    float width = max(abs(cone.width), 1.0e-6f);
    float turn = 0.5f * abs(cone.spread) * glint_kernel_share(cone.spread);
    SeaFootprint f;
    f.d0 = along * (width / max(abs(wo.z), 1.0e-4f));
    f.d1 = across * width;
    f.k0 = along * turn;
    f.k1 = across * turn;
    return f;
}

// All that a pixel has of the sea.
struct SeaSeen {
    SeaFootprint footprint;
    SeaSlopes slopes;
};

SeaSeen sea_seen(IN(Surface) s, vec3 wo) {
    SeaSeen seen;
    seen.footprint = sea_footprint(s.cone, local_from_world(sea_frame(), wo));
    seen.slopes = sample_sea(s.uv0, seen.footprint.d0, seen.footprint.d1);
    return seen;
}

// Out of line, as all materials of the library. load_bsdf(m.bsdf) has the albedo of the water, of
// what comes back from below, as its base colour. seen: by sea_seen.
OUT_OF_LINE ShadingPoint ocean_point_seen(IN(MaterialRecord) m, IN(Surface) s, vec3 wo,
                                          IN(SeaSeen) seen) {
    ShadingPoint p;
    p.frame = sea_frame();
    p.emission = vec3(0.0f);
    p.attenuation = m.attenuation;
    p.flags = m.flags;
    vec3 wo_local = local_from_world(p.frame, wo);
    SeaSlopes sea = seen.slopes;
    // A long footprint may show a crest of waves whose mean slope is turned away from the viewer.
    vec2 mean = slope_mean_in_view(sea.mean, s.front != 0u ? wo_local : -wo_local);
    p.bsdf = load_bsdf(m.bsdf);
    bool deep = (m.flags & MATERIAL_SOLID) == 0u && s.front != 0u;
    if (!deep) { p.bsdf.base_color = vec3(0.0f); }
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
    p.bsdf.slot_c.x = s.uv0.x;
    p.bsdf.slot_c.y = s.uv0.y;
    // Below deep water nothing is seen: what comes back from there is its albedo. Who is below it
    // sees out as through clear water.
    p.bsdf.slot_c.w = deep ? 1.0f : 0.0f;
    p.bsdf.slot_d = vec4(seen.footprint.d0, seen.footprint.d1);
    p.bsdf.slot_e = vec4(seen.footprint.k0, seen.footprint.k1);
    GlintBase base = glint_base_at(p.bsdf);
    GLINT_SET_BASE(p.bsdf, base)
    return p;
}

OUT_OF_LINE ShadingPoint ocean_point(IN(MaterialRecord) m, IN(Surface) s, vec3 wo) {
    return ocean_point_seen(m, s, wo, sea_seen(s, wo));
}

#endif
