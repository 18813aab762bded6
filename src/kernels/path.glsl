// The reference: paths through pixels, a surface at a time. At every surface one light is chosen
// for a shadow ray, and one direction by the material; what both could have found is weighted
// between them. A backend traces the rays between the surfaces: path_begin, then, with what the
// path's ray met in `hit`, path_continue until the path has ended.
// Based on: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", chapters 8-10.
// Resources: those of the files included.
#ifndef GP_KERNELS_PATH_GLSL
#define GP_KERNELS_PATH_GLSL
#include "kernels/environment.glsl"
#include "kernels/leaving_ray.glsl"
#include "kernels/light_choice.glsl"
#include "kernels/material.glsl"
#include "kernels/path_state.glsl"
#include "kernels/shadowed_light.glsl"
#include "kernels/sky.glsl"
#include "kernels/surface.glsl"
#include "shading/colour.glsl"
#include "shading/medium.glsl"
#include "shading/sampling/mis.glsl"
#include "shading/sampling/sampler.glsl"

// Draws of one surface, in a fixed order: a path's dimensions do not depend on what was drawn
// before.
#define DRAWS_PER_VERTEX 4u
#define DRAW_CHOICES 0u    // light, lobe
#define DRAW_LIGHT 1u
#define DRAW_BSDF 2u
#define DRAW_OTHERS 3u     // level of detail, roulette

#define ROULETTE_DEPTH 2u         // surfaces that are never cut off
#define ROULETTE_SURVIVAL 0.95f   // at most

// One pair of the random numbers of the surface at `depth`.
vec2 draw_at(Sampler draws, uint depth, uint draw) {
    draws.dimension += depth * DRAWS_PER_VERTEX + draw;
    return sampler_next_2d(draws);
}

PathLight add_light(PathLight sum, vec3 light, uint depth) {
    LET_REF(FrameConstants) f = load_frame();
    if (depth == 0u) {
        sum.emission += light;
    } else if (depth == 1u) {
        sum.direct += light;
    } else {
        float l = f.clamp_indirect > 0.0f ? luminance(light) : 0.0f;
        sum.indirect += l > f.clamp_indirect ? light * (f.clamp_indirect / l) : light;
    }
    return sum;
}

// Everything infinitely far that a ray meets, weighted against the shadow rays of the vertex it
// left. `spread` as in RayCone; of_camera: no surface lies between.
vec3 sky_light(IN(PathVertex) from, vec3 direction, float spread, bool of_camera) {
    LET_REF(FrameConstants) f = load_frame();
    vec3 light = vec3(0.0f);
    if (of_camera && (f.sky & SKY_HIDDEN) != 0u) { return light; }
    if (sky_is_traced(of_camera)) {
        light = sky_background(direction, from.pdf > 0.0f ? 0.0f : spread);
    }
    if (f.environment_power > 0.0f) {
        EnvironmentLight sky = environment_light(direction, from.pdf > 0.0f);
        if (!sky_is_traced(of_camera)) { light = sky.radiance; }
        if (from.pdf > 0.0f) {
            float chosen = from.groups.resampled != 0u ? 1.0f
                           : from.groups.sum > 0.0f    ? from.groups.environment / from.groups.sum
                                                       : 0.0f;
            light *= mis_power(from.pdf, chosen * sky.pdf);
        }
    }
    if (from.pdf > 0.0f && from.groups.suns_elsewhere != 0u) { return light; }
    for (uint i = 0u; i < f.directional_lights; ++i) {
        LET_REF(LightRecord) record = load_light(i);
        DirectionalLight sun = directional_light(record);
        if (!directional_light_contains(sun, direction)) { continue; }
        float w = 1.0f;
        if (from.pdf > 0.0f) {
            w = mis_power(from.pdf, light_choice_pmf(from.groups, from.position, from.normal, i) *
                                    directional_light_pdf(sun, direction));
        }
        light += directional_light_radiance(sun) * w;
    }
    return light;
}

// The weight of light that a ray found at light `index`, where its shadow rays could have found it
// too.
float found_light_weight(IN(PathVertex) from, uint index, vec3 direction, float t) {
    if (from.pdf == 0.0f || index == NO_INDEX) { return 1.0f; }
    LET_REF(LightRecord) record = load_light(index);
    return mis_power(from.pdf, light_choice_pmf(from.groups, from.position, from.normal, index) *
                               light_pdf(record, from.position, direction * t));
}

vec3 guide_albedo(IN(ShadingPoint) p, vec3 wo) {
    if ((p.flags & MATERIAL_UNLIT) != 0u) { return p.bsdf.base_color; }
    return bsdf_albedo(p.bsdf, abs(dot(shown_normal(p), wo)));
}

PathGuides guides_but_albedo(IN(ShadingPoint) p, IN(Hit) hit) {
    PathGuides g;
    g.coverage = 1.0f;
    g.depth = hit.t;
    g.instance = hit.instance + 1u;
    g.normal = shown_normal(p);
    g.albedo = vec3(0.0f);
    g.roughness = sqrt(p.bsdf.alpha_y);
    g.metallic = p.bsdf.metallic;
    return g;
}

PathGuides guides_of(IN(ShadingPoint) p, IN(Hit) hit, vec3 wo) {
    PathGuides g = guides_but_albedo(p, hit);
    g.albedo = guide_albedo(p, wo);
    return g;
}

PathGuides no_guides() {
    PathGuides g;
    g.albedo = vec3(0.0f);
    g.coverage = 0.0f;
    g.normal = vec3(0.0f);
    g.depth = 0.0f;
    g.roughness = 0.0f;
    g.metallic = 0.0f;
    g.instance = 0u;
    return g;
}

// `ray`: the camera's, `cone`: its cone.
PathState path_begin(Ray ray, RayCone cone, IN(Sampler) draws) {
    PathState path;
    path.ray = ray;
    path.hit.instance = HIT_NOTHING;
    path.cone = cone;
    path.draws = draws;
    path.from.position = ray.origin;
    path.from.pdf = 0.0f;
    path.throughput = vec3(1.0f);
    path.eta_scale = 1.0f;
    path_set_water(path, (load_frame().water & WATER_CAMERA) != 0u ? PATH_IN_WATER : 0u);
    path.depth = 0u;
    path.ended = 0u;
    path.light.emission = vec3(0.0f);
    path.light.direct = vec3(0.0f);
    path.light.indirect = vec3(0.0f);
    path.guides = no_guides();
    return path;
}

void path_end(INOUT(PathState) path, vec3 light) {
    path.light = add_light(path.light, path.throughput * light, path.depth);
    path.ended = 1u;
}

// A lamp's shape.
void path_end_at_light(INOUT(PathState) path) {
    LET_REF(LightRecord) record = load_light(path.hit.primitive);
    if (path.depth == 0u) { path.guides.coverage = 1.0f; }
    path_end(path, light_radiance(record, path.from.position, path.ray.direction) *
                       found_light_weight(path.from, path.hit.primitive, path.ray.direction,
                                          path.hit.t));
}

// What the surface itself shines towards wo: a lamp of triangles, or an unlit surface, which is
// shown to the camera and in mirrors but casts no light on anything.
vec3 own_light(IN(PathState) path, IN(ShadingPoint) p) {
    if ((p.flags & MATERIAL_UNLIT) != 0u) {
        return path.from.pdf == 0.0f ? p.bsdf.base_color : vec3(0.0f);
    }
    if ((p.flags & MATERIAL_EMISSIVE) == 0u) { return vec3(0.0f); }
    uint light = load_light_of_triangle(path.hit.instance, path.hit.primitive);
    return p.emission * found_light_weight(path.from, light, path.ray.direction, path.hit.t);
}

// The path goes on along b, or ends. u_roulette below 0: it is not cut off by chance.
void path_leave(INOUT(PathState) path, IN(Surface) s, IN(ShadingPoint) p, IN(PathVertex) at,
                vec3 wo_local, IN(BsdfSample) b, float u_roulette) {
    path.ended = 1u;
    if (!(b.pdf > 0.0f) || !(max_component(b.weight) > 0.0f)) { return; }
    vec3 wi = world_from_local(p.frame, b.wi);
    vec3 wo = -path.ray.direction;
    if (!sides_agree(s, p, wo, wi, wo_local, b.wi)) { return; }
    path.throughput *= b.weight;
    if ((b.lobe & LOBE_TRANSMISSION) != 0u && p.bsdf.thin == 0u) {
        bool entering = side_of(p.bsdf, wo_local) > 0.0f;
        if ((p.flags & MATERIAL_SEA) != 0u) {
            path_set_water(path, entering ? PATH_IN_WATER : path.water & PATH_LIT_THROUGH);
        } else {
            path.attenuation = entering ? p.attenuation : vec3(0.0f);
            if (path.water != 0u) { path_change_body(path, entering); }
        }
        float eta = entering ? p.bsdf.ior : 1.0f / p.bsdf.ior;
        path.eta_scale *= eta * eta;
    }
    // Roulette: paths that carry little end early, the others make up for them.
    // [Arvo and Kirk 1990, "Particle Transport and Image Synthesis"]
    if (u_roulette >= 0.0f) {
        float survival = min(max_component(path.throughput) * path.eta_scale, ROULETTE_SURVIVAL);
        if (u_roulette >= survival) { return; }
        path.throughput /= survival;
    }
    if (path.water != 0u) { path.water = path_water_from(path.water, p.flags); }
    path.from = at;
    path.from.pdf = bsdf_is_specular(p.bsdf) ? 0.0f : b.pdf;
    path.cone =
        ray_cone_bounce(path.cone, (b.lobe & LOBE_DIFFUSE) != 0u ? 1.0f : p.bsdf.alpha_x);
    path.ray = ray_from(s, leaving_side(s, p, wo, wi), wi, FLOAT_MAX);
    path.depth += 1u;
    path.ended = 0u;
    environment_expect_light(wi);
}

PathVertex path_vertex(IN(Surface) s, vec3 wo, bool transmissive) {
    PathVertex at;
    at.position = s.position;
    at.normal = transmissive ? vec3(0.0f) : dot(s.ng, wo) > 0.0f ? s.ng : -s.ng;
    at.groups = light_groups(at.position, at.normal);
    at.pdf = 0.0f;
    return at;
}

// How light finds p, on the side that the path comes from.
Around path_around(uint water, vec3 attenuation, IN(ShadingPoint) p) {
    Around around = around_of(attenuation);
    if ((water & PATH_IN_WATER) == 0u || (p.flags & MATERIAL_SEA) != 0u ||
        bsdf_is_specular(p.bsdf)) {
        return around;
    }
    bool bends = (load_frame().water & WATER_BENDS) != 0u;
    around.bends = bends ? 1u : 0u;
    around.guided = bends ? 0.0f : load_frame().water_guided;
    return around;
}

// The PATH_ bits of what leaves p on the same side: far light that `around` has brought there must
// not be found again.
uint path_water_behind(uint water, IN(ShadingPoint) p, IN(Around) around) {
    if ((p.flags & MATERIAL_SEA) != 0u) { return water; }
    return (water & (PATH_IN_WATER | PATH_IN_BODY)) | (around.bends != 0u ? PATH_LIT_THROUGH : 0u);
}

// The surface that path.hit names: its own light, a shadow ray, the next ray.
void path_scatter(INOUT(PathState) path) {
    LET_REF(FrameConstants) f = load_frame();
    LET_REF(MaterialRecord) material = load_material(load_instance(path.hit.instance).material);
    bool roulette = f.russian_roulette != 0u && path.depth >= ROULETTE_DEPTH;
    vec2 u_others = vec2(0.0f);
    if (roulette || material.textures != 0u) {
        u_others = draw_at(path.draws, path.depth, DRAW_OTHERS);
    }
    bool diffuse = f.diffuse_shading != 0u;
    bool matte = diffuse || (material.flags & MATERIAL_MATTE) != 0u;
    vec2 u_choices = vec2(0.0f);
    if (!matte || f.only_environment == 0u) {
        u_choices = draw_at(path.draws, path.depth, DRAW_CHOICES);
    }
    vec3 wo = -path.ray.direction;
    path.cone = ray_cone_propagate(path.cone, path.hit.t);
    Surface s = load_surface(path.hit, path.ray.direction, path.cone,
                             surface_needs(material, diffuse));
    PathVertex at =
        path_vertex(s, wo, !diffuse && (material.flags & MATERIAL_LIT_FROM_BELOW) != 0u);
    if (path.water != 0u && path_sea_hides(path.water, material.flags)) {
        at.groups = light_groups_near(at.groups);
    }
    ChosenLight light = choose_light_point(at.groups, at.position, at.normal, u_choices.x,
                                           draw_at(path.draws, path.depth, DRAW_LIGHT));
    ShadingPoint p = load_shading_point(material, s, wo, u_others.x, diffuse);
    if (path.depth == 0u) { path.guides = guides_of(p, path.hit, wo); }
    path.light = add_light(path.light, path.throughput * own_light(path, p), path.depth);
    path.ended = 1u;
    if ((p.flags & MATERIAL_UNLIT) != 0u || path.depth > f.max_bounces) { return; }

    vec3 wo_local = local_from_world(p.frame, wo);
    // The last surface's own ray would only weigh against the shadow ray: where that finds
    // infinitely far light well by itself, it is left out.
    bool last = path.depth == f.max_bounces &&
                (f.last_by_lights != 0u ||
                 (f.tree_nodes == 0u && p.bsdf.model == MODEL_LAMBERT));
    Around around = path_around(path.water, path.attenuation, p);
    if (!bsdf_is_specular(p.bsdf)) {
        ShadowedLight arrived = shadowed_light(s, p, light, wo_local, wo, around, !last, 0.0f);
        path.light = add_light(path.light, path.throughput * (arrived.f_cos * arrived.light),
                               path.depth + 1u);
        if (last) { return; }
    }
    vec2 u_bsdf = draw_at(path.draws, path.depth, DRAW_BSDF);
    BsdfSample b = bsdf_sample(p.bsdf, wo_local, unguided(around.guided, u_choices.y), u_bsdf);
    if (path.water != 0u) {
        if (around.guided > 0.0f) {
            GuidedSample next = guided_sample(p, wo_local, b, around.guided, u_choices.y, u_bsdf);
            path.eta_scale *= next.narrowing;
            b = next.b;
        }
        path.water = path_water_behind(path.water, p, around);
    }
    path_leave(path, s, p, at, wo_local, b, roulette ? u_others.y : -1.0f);
}

// path.hit has become known; path_continue follows, after something else has been done.
void path_expect(IN(PathState) path) {
    if (path.hit.instance != HIT_NOTHING && path.hit.instance != HIT_LIGHT) {
        environment_expect_sample(draw_at(path.draws, path.depth, DRAW_LIGHT));
    }
}

// From what the path's ray met to the next ray, or to the end.
void path_continue(INOUT(PathState) path) {
    if (path.water != 0u) {
        path.light =
            add_light(path.light, path.throughput * path_water_light(path), path.depth);
    }
    if (path.hit.instance == HIT_NOTHING) {
        // An absorbing medium without an end lets nothing through.
        if (path.attenuation != vec3(0.0f)) {
            path.throughput *= medium_transmittance(path.attenuation, FLOAT_MAX);
        }
        if ((path.water & PATH_LIT_THROUGH) != 0u) { path.throughput = vec3(0.0f); }
        path_end(path, sky_light(path.from, path.ray.direction, path.cone.spread,
                                 path.depth == 0u));
        return;
    }
    if (path.attenuation != vec3(0.0f)) {
        path.throughput *= medium_transmittance(path.attenuation, path.hit.t);
    }
    if (path.hit.instance == HIT_LIGHT) {
        path_end_at_light(path);
    } else {
        path_scatter(path);
    }
}

#endif
