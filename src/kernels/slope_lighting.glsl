// Surfaces of slopes (the model `glint`, the sea) in GP_MODE_LOCAL: light from all sides as a sum
// over a few of their facets.
// Based on: Dupuy et al. 2013, "Linear Efficient Antialiased Displacement and Reflectance Mapping",
// section 5.
// Resources: load_local_lighting, sample_sky, sample_sky_irradiance.
#ifndef GP_KERNELS_SLOPE_LIGHTING_GLSL
#define GP_KERNELS_SLOPE_LIGHTING_GLSL
#include "kernels/shading_point.glsl"
#include "shading/slope/slope_environment.glsl"
#include "shared/scene_structs.glsl"

// Mean radiance from so many steradians about a direction of the world. What is read is spread as
// a texel is, three times as much as a box of its size: once by the texel, twice by reading between
// texels. So it is of a level with texels of a third of the area.
vec3 sky_within(vec3 direction, float solid_angle) {
    vec3 a = abs(direction);
    float major = max(a.x, max(a.y, a.z));
    // A cube's texels are the smaller the farther they are from the middle of a face.
    float texel = load_local_lighting().sky_texel * major * major * major;
    return sample_sky(direction, slope_light_lod(solid_angle / 3.0f, texel));
}

// What a facet sees below the horizon of its surface. That of the sea is other waves, which are
// taken for flat there: they reflect the sky. Everything else hides what is below it.
vec3 sky_of_facet(IN(ShadingPoint) p, vec3 wi_local, float solid_angle) {
    vec3 wi = world_from_local(p.frame, wi_local);
    if (wi_local.z > 0.0f) { return sky_within(wi, solid_angle); }
    if ((p.flags & MATERIAL_SEA) == 0u) { return vec3(0.0f); }
    float f = fresnel_dielectric(-wi_local.z, p.bsdf.ior);
    return sky_within(wi - p.frame.n * (2.0f * wi_local.z), solid_angle) * f;
}

// The matte base under the facets, its light gathered over the plane of the mean slope: what falls
// in under an angle is let through as much as it is on average.
vec3 base_lit_by_sky(IN(ShadingPoint) p, IN(GlintView) seen) {
    vec3 n = normalize(mesosurface_normal(seen.g.slopes.mean));
    n = seen.turned ? glint_turned(p.bsdf, n) : n;
    vec3 average = vec3(p.bsdf.slot_j.x);
    return coupled_diffuse(gltf_diffuse_color(p.bsdf), vec3(seen.through), average, average) *
           PI * sample_sky_irradiance(world_from_local(p.frame, n));
}

// Half of GGX's facets have slopes below alpha, and turn light by twice that: the cone in which it
// comes, steradians.
float coat_solid_angle(IN(BsdfParams) m) {
    return min(4.0f * PI * m.coat_alpha * m.coat_alpha, TWO_PI);
}

// `under`, the light of facets and base, seen through the layers, and what these reflect: the coat
// as a mirror about its normal of what its lobe covers, the sheen the irradiance.
OUT_OF_LINE vec3 layers_lit_by_sky(IN(ShadingPoint) p, IN(GlintView) seen, vec3 under) {
    Layers over = seen.over.layers;
    Frame frame = mesosurface_frame(seen.g.slopes.mean);
    vec3 n = frame.n;
    vec3 mirrored = world_from_local(frame, reflect(-seen.over.o, p.bsdf.coat_normal));
    if (seen.turned) {
        n = glint_turned(p.bsdf, n);
        mirrored = glint_turned(p.bsdf, mirrored);
    }
    vec3 sheen = p.bsdf.sheen_color * sheen_albedo_white(seen.over.o.z, p.bsdf.sheen_alpha);
    vec3 sum = under * over.sheen_through
             + sheen * sample_sky_irradiance(world_from_local(p.frame, n));
    if (!(p.bsdf.coat > 0.0f)) { return sum; }
    return sum * over.coat_through
         + sky_of_facet(p, mirrored, coat_solid_angle(p.bsdf)) * (1.0f - over.coat_through);
}

// Light from all sides, wo_local not inside of a solid body: facets reflect it as the sum of
// slope_light, the base is matte, and what is sent through is the mean of all sides.
vec3 slopes_lit_by_sky(IN(ShadingPoint) p, vec3 wo_local) {
    LET_REF(LocalLightingConstants) local = load_local_lighting();
    if (glint_is_black(p.bsdf, wo_local)) { return vec3(0.0f); }
    GlintView seen = glint_view(p.bsdf, wo_local);
    uint masking = glint_masking(p.bsdf) == GLINT_MASKING_SMITH ? SLOPE_MASKING_SMITH
                                                                : SLOPE_MASKING_V_CAVITY;
    uint n = local.sky_nodes;
    vec3 sum = vec3(0.0f);
    for (uint i = 0u; i < n * n; ++i) {
        SlopeLight facet = slope_light(seen.g.slopes, seen.o, n, i, masking);
        if (!(facet.weight > 0.0f)) { continue; }
        float cos_h = dot(seen.o, facet.wm);
        GltfFresnel f = glint_fresnel(p.bsdf, cos_h, glint_cos_behind(p.bsdf, cos_h, seen.eta),
                                      seen.eta);
        vec3 wi = seen.turned ? glint_turned(p.bsdf, facet.wi) : facet.wi;
        vec3 sky = sky_of_facet(p, wi, facet.solid_angle);
        sum += (f.reflected * sky + f.transmitted * local.sky_mean) * facet.weight;
    }
    sum = seen.has_base ? sum + base_lit_by_sky(p, seen) : sum;
    return has_layers(p.bsdf) ? layers_lit_by_sky(p, seen, sum) : sum;
}

// The same for any surface; those without slopes as if they were matte with their albedo.
vec3 lit_by_sky(IN(ShadingPoint) p, vec3 wo_local, vec3 albedo) {
    if (p.bsdf.model == MODEL_GLINT) {
        bool inside = p.bsdf.thin == 0u && slope_facing(glint_mean(p.bsdf), wo_local) < 0.0f;
        return inside ? albedo * load_local_lighting().sky_mean : slopes_lit_by_sky(p, wo_local);
    }
    vec3 n = side_of(p.bsdf, wo_local) < 0.0f ? -p.frame.n : p.frame.n;
    return albedo * sample_sky_irradiance(n);
}

#endif
