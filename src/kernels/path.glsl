// The reference: one whole path through a pixel. At every surface one light is chosen for a shadow
// ray, and one direction by the material; what both could have found is weighted between them.
// Based on: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", chapters 8-10.
// Resources: trace_closest, trace_visible, note_shadow_ray, and those of the files included.
#ifndef GP_KERNELS_PATH_GLSL
#define GP_KERNELS_PATH_GLSL
#include "kernels/environment.glsl"
#include "kernels/light_choice.glsl"
#include "kernels/material.glsl"
#include "kernels/surface.glsl"
#include "shading/colour.glsl"
#include "shading/medium.glsl"
#include "shading/ray_offset.glsl"
#include "shading/sampling/mis.glsl"
#include "shading/sampling/sampler.glsl"

// The light that a path brings to its pixel, by how often it was reflected.
struct PathLight {
    vec3 emission;
    vec3 direct;
    vec3 indirect;
};

// What the first surface leaves for guides and layers.
struct PathGuides {
    vec3 albedo;
    float coverage;
    vec3 normal;
    float depth;      // metres along the ray
    float roughness;
    float metallic;
    uint instance;    // 1 + index, 0: nothing
};

struct PathSample {
    PathLight light;
    PathGuides guides;
};

// The vertex that a ray leaves, as far as the weight of what it meets depends on it.
struct PathVertex {
    vec3 position;
    float pdf;          // of the ray's direction; 0: not to be weighted (camera, mirror-like)
    vec3 normal;        // of the surface; the zero vector where light from both sides counts
    LightGroups groups; // what its shadow ray was chosen among
};

// Where a path stands.
struct PathState {
    vec3 throughput;
    float eta_scale;    // radiance is compressed by refraction; roulette must not see that
    vec3 attenuation;   // of the medium around, 1/m
    uint depth;         // surfaces met so far
};

// Draws of one surface, in a fixed order: a path's dimensions do not depend on what was drawn
// before.
#define DRAWS_PER_VERTEX 4u
#define DRAW_CHOICES 0u    // light, lobe
#define DRAW_LIGHT 1u
#define DRAW_BSDF 2u
#define DRAW_OTHERS 3u     // level of detail, roulette

#define SHADOW_MARGIN 1.0e-4f     // of a shadow ray's length: it must not meet the light itself
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
// left.
vec3 sky_light(IN(PathVertex) from, vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    vec3 light = vec3(0.0f);
    if (f.environment_power > 0.0f) {
        EnvironmentLight sky = environment_light(direction, from.pdf > 0.0f);
        light = sky.radiance;
        if (from.pdf > 0.0f) {
            float chosen = from.groups.environment / light_groups_sum(from.groups);
            light *= mis_power(from.pdf, chosen * sky.pdf);
        }
    }
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

PathGuides guides_of(IN(ShadingPoint) p, IN(Hit) hit, vec3 wo) {
    PathGuides g;
    g.coverage = 1.0f;
    g.depth = hit.t;
    g.instance = hit.instance + 1u;
    g.normal = p.frame.n;
    g.albedo = (p.flags & MATERIAL_UNLIT) != 0u ? p.bsdf.base_color
                                                : bsdf_albedo(p.bsdf, abs(dot(p.frame.n, wo)));
    g.roughness = sqrt(p.bsdf.alpha_y);
    g.metallic = p.bsdf.metallic;
    return g;
}

PathSample empty_path_sample() {
    PathSample r;
    r.light.emission = vec3(0.0f);
    r.light.direct = vec3(0.0f);
    r.light.indirect = vec3(0.0f);
    r.guides.albedo = vec3(0.0f);
    r.guides.coverage = 0.0f;
    r.guides.normal = vec3(0.0f);
    r.guides.depth = 0.0f;
    r.guides.roughness = 0.0f;
    r.guides.metallic = 0.0f;
    r.guides.instance = 0u;
    return r;
}

// Whether light turning from wo to wi stays on the side of the surface that its shading normal
// says; a normal map or smooth shading must not make light leak through, nor back.
bool sides_agree(IN(Surface) s, vec3 wo, vec3 wi, vec3 wo_local, vec3 wi_local) {
    bool reflected = (wi_local.z > 0.0f) == (wo_local.z > 0.0f);
    return reflected == ((dot(s.ng, wi) > 0.0f) == (dot(s.ng, wo) > 0.0f));
}

Ray ray_from(IN(Surface) s, vec3 direction, float t_max) {
    Ray ray;
    ray.origin = offset_ray_origin(s.position, dot(s.ng, direction) > 0.0f ? s.ng : -s.ng);
    ray.direction = direction;
    ray.t_min = 0.0f;
    ray.t_max = t_max;
    return ray;
}

// To the chosen point of a light. It is aimed anew from the moved origin: where the light is seen
// edge-on, the old direction would meet it far before that point, and the light would shadow
// itself.
Ray shadow_ray(IN(Surface) s, IN(LightSample) light) {
    Ray ray = ray_from(s, light.wi, light.distance);
    if (light.distance < FLOAT_MAX) {
        vec3 to_light = s.position + light.wi * light.distance - ray.origin;
        float distance = length(to_light);
        ray.direction = to_light / max(distance, 1.0e-30f);
        ray.t_max = distance * (1.0f - SHADOW_MARGIN);
    }
    return ray;
}

// The shadow ray of a surface to the light chosen for it; `attenuation` is that of the medium on
// wo's side. Returns reflected radiance, without the path's throughput.
vec3 shadowed_light(IN(Surface) s, IN(ShadingPoint) p, IN(ChosenLight) choice, vec3 wo_local,
                    vec3 wo, vec3 attenuation, bool weigh) {
    LET_REF(LightSample) light = choice.point;
    if (light.pdf <= 0.0f) { return vec3(0.0f); }
    vec3 wi_local = local_from_world(p.frame, light.wi);
    if (!sides_agree(s, wo, light.wi, wo_local, wi_local)) { return vec3(0.0f); }
    BsdfValue value = bsdf_eval(p.bsdf, wo_local, wi_local);
    vec3 radiance = value.f_cos * chosen_light_radiance(choice);
    if (!(max_component(radiance) > 0.0f)) { return vec3(0.0f); }
    float density = choice.pmf * light.pdf;
    float w = light.is_delta != 0u || !weigh ? 1.0f : mis_power(density, value.pdf);
    float visible = trace_visible(shadow_ray(s, light));
    note_shadow_ray(light_group(choice.light), max_component(radiance) / density, visible);
    // What surrounds the surface absorbs; infinitely far light is never inside of a body.
    bool reflected = (wi_local.z > 0.0f) == (wo_local.z > 0.0f);
    if (reflected && attenuation != vec3(0.0f) && light.distance < FLOAT_MAX) {
        radiance *= medium_transmittance(attenuation, light.distance);
    }
    return radiance * (w / density * visible);
}

// `ray` and `hit`: the camera ray and what it met; `cone`: its cone; `draws`: at the path's first
// draw.
PathSample trace_path(Ray ray, Hit hit, RayCone cone, IN(Sampler) draws) {
    LET_REF(FrameConstants) f = load_frame();
    PathSample r = empty_path_sample();
    PathVertex from;
    from.position = ray.origin;
    from.pdf = 0.0f;
    PathState state;
    state.throughput = vec3(1.0f);
    state.eta_scale = 1.0f;
    state.attenuation = vec3(0.0f);
    state.depth = 0u;

    while (true) {
        if (hit.instance == HIT_NOTHING) {
            r.light =
                add_light(r.light, state.throughput * sky_light(from, ray.direction), state.depth);
            break;
        }
        if (state.attenuation != vec3(0.0f)) {
            state.throughput *= medium_transmittance(state.attenuation, hit.t);
        }
        if (hit.instance == HIT_LIGHT) {
            LET_REF(LightRecord) record = load_light(hit.primitive);
            vec3 emitted = light_radiance(record, from.position, ray.direction) *
                         found_light_weight(from, hit.primitive, ray.direction, hit.t);
            r.light = add_light(r.light, state.throughput * emitted, state.depth);
            r.guides.coverage = state.depth == 0u ? 1.0f : r.guides.coverage;
            break;
        }
        LET_REF(MaterialRecord) material = load_material(load_instance(hit.instance).material);
        bool roulette = f.russian_roulette != 0u && state.depth >= ROULETTE_DEPTH;
        vec2 u_light = draw_at(draws, state.depth, DRAW_LIGHT);
        environment_expect_sample(u_light);
        vec2 u_others = vec2(0.0f);
        if (roulette || material.textures != 0u) {
            u_others = draw_at(draws, state.depth, DRAW_OTHERS);
        }
        vec3 wo = -ray.direction;
        cone = ray_cone_propagate(cone, hit.t);
        bool textured = material.textures != 0u || (material.flags & MATERIAL_NEEDS_UV) != 0u;
        Surface s = load_surface(hit, ray.direction, cone, textured);
        PathVertex at;
        at.position = s.position;
        at.normal = dot(s.ng, wo) > 0.0f ? s.ng : -s.ng;
        if (f.diffuse_shading == 0u && (material.flags & MATERIAL_TRANSMISSIVE) != 0u) {
            at.normal = vec3(0.0f);
        }
        at.groups = light_groups(at.position, at.normal);
        vec2 u_choices = draw_at(draws, state.depth, DRAW_CHOICES);
        ChosenLight light =
            choose_light_point(at.groups, at.position, at.normal, u_choices.x, u_light);
        ShadingPoint p = load_shading_point(material, s, wo, u_others.x, f.diffuse_shading != 0u);
        if (state.depth == 0u) { r.guides = guides_of(p, hit, wo); }
        if ((p.flags & MATERIAL_UNLIT) != 0u) {
            // Shown to the camera and in mirrors; it casts no light on anything.
            vec3 shown = from.pdf == 0.0f ? p.bsdf.base_color : vec3(0.0f);
            r.light = add_light(r.light, state.throughput * shown, state.depth);
            break;
        }
        if ((p.flags & MATERIAL_EMISSIVE) != 0u) {
            float w = found_light_weight(from, load_light_of_triangle(hit.instance, hit.primitive),
                                         ray.direction, hit.t);
            r.light = add_light(r.light, state.throughput * p.emission * w, state.depth);
        }
        if (state.depth > f.max_bounces) { break; }

        // Light that is chosen, and light that the material finds by itself.
        vec3 wo_local = local_from_world(p.frame, wo);
        bool specular = bsdf_is_specular(p.bsdf);
        // The last surface's own ray would only weigh against the shadow ray: where that finds
        // infinitely far light well by itself, it is left out.
        bool last =
            state.depth == f.max_bounces && f.tree_nodes == 0u && p.bsdf.model == MODEL_LAMBERT;
        if (!specular) {
            vec3 direct = shadowed_light(s, p, light, wo_local, wo, state.attenuation, !last);
            r.light = add_light(r.light, state.throughput * direct, state.depth + 1u);
        }
        if (last && !specular) { break; }
        BsdfSample b =
            bsdf_sample(p.bsdf, wo_local, u_choices.y, draw_at(draws, state.depth, DRAW_BSDF));
        if (!(b.pdf > 0.0f) || !(max_component(b.weight) > 0.0f)) { break; }
        vec3 wi = world_from_local(p.frame, b.wi);
        if (!sides_agree(s, wo, wi, wo_local, b.wi)) { break; }
        state.throughput *= b.weight;
        if ((b.lobe & LOBE_TRANSMISSION) != 0u && p.bsdf.thin == 0u) {
            bool entering = wo_local.z > 0.0f;
            state.attenuation = entering ? p.attenuation : vec3(0.0f);
            float eta = entering ? p.bsdf.ior : 1.0f / p.bsdf.ior;
            state.eta_scale *= eta * eta;
        }

        // Roulette: paths that carry little end early, the others make up for them.
        // [Arvo and Kirk 1990, "Particle Transport and Image Synthesis"]
        if (roulette) {
            float survival =
                min(max_component(state.throughput) * state.eta_scale, ROULETTE_SURVIVAL);
            if (u_others.y >= survival) { break; }
            state.throughput /= survival;
        }

        from = at;
        from.pdf = specular ? 0.0f : b.pdf;
        cone = ray_cone_bounce(cone, (b.lobe & LOBE_DIFFUSE) != 0u ? 1.0f : p.bsdf.alpha_x);
        ray = ray_from(s, wi, FLOAT_MAX);
        state.depth += 1u;
        environment_expect_light(wi);
        hit = trace_closest(ray);
    }
    return r;
}

#endif
