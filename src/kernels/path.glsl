// The reference: one whole path through a pixel. At every surface one light is chosen for a shadow ray,
// and one direction by the material; what both could have found is weighted between them.
// Based on: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", chapters 8 to 10.
// Resources: trace_closest, trace_visible, and those of the files included.
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

// What a path gives to its pixel; the guides are those of the first surface.
struct PathSample {
    vec3 emission;
    float coverage;
    vec3 direct;
    float depth;      // metres along the ray
    vec3 indirect;
    float roughness;
    vec3 albedo;
    float metallic;
    vec3 normal;
    uint instance;    // 1 + index, 0: nothing
};

// The vertex that a ray leaves, as far as the weight of what it meets depends on it.
struct PathVertex {
    vec3 position;
    vec3 normal;        // of the surface; the zero vector where light from both sides counts
    float pdf;          // of the ray's direction; 0: not to be weighted (camera, mirror-like)
};

// Where a path stands.
struct PathState {
    vec3 throughput;
    float eta_scale;    // radiance is compressed by refraction; roulette must not see that
    vec3 attenuation;   // of the medium around, 1/m
    uint depth;         // surfaces met so far
};

// Draws of one surface, in a fixed order: a path's dimensions do not depend on what was drawn before.
#define DRAWS_PER_VERTEX 6u
#define DRAW_LIGHT_CHOICE 0u
#define DRAW_LIGHT 1u
#define DRAW_LOBE 2u
#define DRAW_BSDF 3u
#define DRAW_ROULETTE 4u
#define DRAW_DETAIL 5u

#define SHADOW_MARGIN 1.0e-4f     // of a shadow ray's length: it must not meet the light itself
#define ROULETTE_DEPTH 2u         // surfaces that are never cut off
#define ROULETTE_SURVIVAL 0.95f   // at most

PathSample add_light(PathSample r, vec3 light, uint depth) {
    LET_REF(FrameConstants) f = load_frame();
    if (depth == 0u) {
        r.emission += light;
    } else if (depth == 1u) {
        r.direct += light;
    } else {
        float l = luminance(light);
        bool clamped = f.clamp_indirect > 0.0f && l > f.clamp_indirect;
        r.indirect += clamped ? light * (f.clamp_indirect / l) : light;
    }
    return r;
}

// Everything infinitely far that a ray meets, weighted against the shadow rays of the vertex it left.
vec3 sky_light(IN(PathVertex) from, vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    vec3 light = environment_radiance(direction);
    if (from.pdf > 0.0f && f.environment_power > 0.0f) {
        light *= mis_power(from.pdf, light_choice_environment(from.position, from.normal) * environment_pdf(direction));
    }
    for (uint i = 0u; i < f.directional_lights; ++i) {
        LET_REF(LightRecord) record = load_light(i);
        DirectionalLight sun = directional_light(record);
        if (!directional_light_contains(sun, direction)) { continue; }
        float w = 1.0f;
        if (from.pdf > 0.0f) {
            w = mis_power(from.pdf, light_choice_pmf(from.position, from.normal, i) *
                                    directional_light_pdf(sun, direction));
        }
        light += directional_light_radiance(sun) * w;
    }
    return light;
}

// The weight of light that a ray found at light `index`, where its shadow rays could have found it too.
float found_light_weight(IN(PathVertex) from, uint index, vec3 direction, float t) {
    if (from.pdf == 0.0f || index == NO_INDEX) { return 1.0f; }
    LET_REF(LightRecord) record = load_light(index);
    return mis_power(from.pdf, light_choice_pmf(from.position, from.normal, index) *
                               light_pdf(record, from.position, direction * t));
}

// The shadow ray of a surface. Returns reflected radiance, without the path's throughput.
vec3 sample_direct(IN(Surface) s, IN(ShadingPoint) p, vec3 wo_local, vec3 wo, vec3 choice_normal,
                   float u_choice, vec2 u_light, bool weigh) {
    LightChoice choice = choose_light(s.position, choice_normal, u_choice);
    if (choice.pmf <= 0.0f) { return vec3(0.0f); }
    LightSample light = sample_light(choice.light, s.position, u_light);
    if (light.pdf <= 0.0f) { return vec3(0.0f); }
    // A shading normal must not let light through the surface, nor transmit it on the same side.
    vec3 wi_local = local_from_world(p.frame, light.wi);
    bool same_side = (wi_local.z > 0.0f) == (wo_local.z > 0.0f);
    float side = dot(s.ng, light.wi);
    if (same_side != ((side > 0.0f) == (dot(s.ng, wo) > 0.0f))) { return vec3(0.0f); }
    BsdfValue value = bsdf_eval(p.bsdf, wo_local, wi_local);
    vec3 radiance = value.f_cos * light.radiance;
    float largest = max(radiance.x, max(radiance.y, radiance.z));
    if (!(largest > 0.0f)) { return vec3(0.0f); }
    float density = choice.pmf * light.pdf;
    float w = light.is_delta != 0u || !weigh ? 1.0f : mis_power(density, value.pdf);
    Ray ray;
    ray.origin = offset_ray_origin(s.position, side > 0.0f ? s.ng : -s.ng);
    ray.direction = light.wi;
    ray.t_min = 0.0f;
    ray.t_max = light.distance * (1.0f - SHADOW_MARGIN);
    return radiance * (w / density) * trace_visible(ray);
}

// What the camera's own surface leaves for guides and layers.
PathSample note_first_surface(PathSample r, IN(ShadingPoint) p, IN(Hit) hit, vec3 wo) {
    r.coverage = 1.0f;
    r.depth = hit.t;
    r.instance = hit.instance + 1u;
    r.normal = p.frame.n;
    r.albedo = (p.flags & MATERIAL_UNLIT) != 0u ? p.bsdf.base_color
                                                : bsdf_albedo(p.bsdf, abs(dot(p.frame.n, wo)));
    r.roughness = sqrt(p.bsdf.alpha_y);
    r.metallic = p.bsdf.metallic;
    return r;
}

// `ray` and `hit`: the camera ray and what it met; `cone`: its cone.
PathSample trace_path(Ray ray, Hit hit, RayCone cone, Sampler draws) {
    LET_REF(FrameConstants) f = load_frame();
    PathSample r;
    r.emission = vec3(0.0f);
    r.coverage = 0.0f;
    r.direct = vec3(0.0f);
    r.depth = 0.0f;
    r.indirect = vec3(0.0f);
    r.roughness = 0.0f;
    r.albedo = vec3(0.0f);
    r.metallic = 0.0f;
    r.normal = vec3(0.0f);
    r.instance = 0u;
    PathVertex from;
    from.position = ray.origin;
    from.normal = vec3(0.0f);
    from.pdf = 0.0f;
    PathState state;
    state.throughput = vec3(1.0f);
    state.eta_scale = 1.0f;
    state.attenuation = vec3(0.0f);
    state.depth = 0u;
    uint first_draw = draws.dimension;

    while (true) {
        if (hit.instance == HIT_NOTHING) {
            r = add_light(r, state.throughput * sky_light(from, ray.direction), state.depth);
            break;
        }
        if (state.attenuation != vec3(0.0f)) {
            state.throughput *= medium_transmittance(state.attenuation, hit.t);
        }
        if (hit.instance == HIT_LIGHT) {
            LET_REF(LightRecord) record = load_light(hit.primitive);
            vec3 light = light_radiance(record, from.position, ray.direction) *
                         found_light_weight(from, hit.primitive, ray.direction, hit.t);
            r = add_light(r, state.throughput * light, state.depth);
            r.coverage = state.depth == 0u ? 1.0f : r.coverage;
            break;
        }
        draws.dimension = first_draw + state.depth * DRAWS_PER_VERTEX + DRAW_DETAIL;
        float u_detail = sampler_next_1d(draws);
        vec3 wo = -ray.direction;
        cone = ray_cone_propagate(cone, hit.t);
        Surface s = load_surface(hit, ray.direction, cone);
        ShadingPoint p = load_shading_point(load_material(s.material), s, wo, u_detail, f.diffuse_shading != 0u);
        if (state.depth == 0u) { r = note_first_surface(r, p, hit, wo); }
        if ((p.flags & MATERIAL_UNLIT) != 0u) {
            r = add_light(r, state.throughput * p.bsdf.base_color, state.depth);
            break;
        }
        if ((p.flags & MATERIAL_EMISSIVE) != 0u) {
            float w = found_light_weight(from, load_light_of_triangle(hit.instance, hit.primitive),
                                         ray.direction, hit.t);
            r = add_light(r, state.throughput * p.emission * w, state.depth);
        }
        if (state.depth > f.max_bounces) { break; }

        // Light that is chosen, and light that the material finds by itself.
        vec3 wo_local = local_from_world(p.frame, wo);
        bool transmissive = (p.flags & MATERIAL_TRANSMISSIVE) != 0u;
        vec3 side = dot(s.ng, wo) > 0.0f ? s.ng : -s.ng;
        vec3 choice_normal = transmissive ? vec3(0.0f) : side;
        bool specular = bsdf_is_specular(p.bsdf);
        // The last surface's own ray would only weigh against the shadow ray: where that finds
        // infinitely far light well by itself, it is left out.
        bool last = state.depth == f.max_bounces && f.tree_nodes == 0u && p.bsdf.model == MODEL_LAMBERT;
        if (!specular) {
            draws.dimension = first_draw + state.depth * DRAWS_PER_VERTEX + DRAW_LIGHT_CHOICE;
            float u_choice = sampler_next_1d(draws);
            vec2 u_light = sampler_next_2d(draws);
            vec3 light = sample_direct(s, p, wo_local, wo, choice_normal, u_choice, u_light, !last);
            r = add_light(r, state.throughput * light, state.depth + 1u);
        }
        if (last && !specular) { break; }
        draws.dimension = first_draw + state.depth * DRAWS_PER_VERTEX + DRAW_LOBE;
        float u_lobe = sampler_next_1d(draws);
        vec2 u_bsdf = sampler_next_2d(draws);
        BsdfSample b = bsdf_sample(p.bsdf, wo_local, u_lobe, u_bsdf);
        float largest = max(b.weight.x, max(b.weight.y, b.weight.z));
        if (!(b.pdf > 0.0f) || !(largest > 0.0f)) { break; }
        vec3 wi = world_from_local(p.frame, b.wi);
        bool same_side = (b.wi.z > 0.0f) == (wo_local.z > 0.0f);
        float wi_side = dot(s.ng, wi);
        if (same_side != ((wi_side > 0.0f) == (dot(s.ng, wo) > 0.0f))) { break; }
        state.throughput *= b.weight;
        if ((b.lobe & LOBE_TRANSMISSION) != 0u && p.bsdf.thin == 0u) {
            bool entering = wo_local.z > 0.0f;
            state.attenuation = entering ? p.attenuation : vec3(0.0f);
            float eta = entering ? p.bsdf.ior : 1.0f / p.bsdf.ior;
            state.eta_scale *= eta * eta;
        }

        // Roulette: paths that carry little end early, the others make up for them.
        // [Arvo and Kirk 1990, "Particle Transport and Image Synthesis"]
        if (f.russian_roulette != 0u && state.depth >= ROULETTE_DEPTH) {
            float carried = max(state.throughput.x, max(state.throughput.y, state.throughput.z)) * state.eta_scale;
            float survival = min(carried, ROULETTE_SURVIVAL);
            draws.dimension = first_draw + state.depth * DRAWS_PER_VERTEX + DRAW_ROULETTE;
            if (sampler_next_1d(draws) >= survival) { break; }
            state.throughput /= survival;
        }

        from.position = s.position;
        from.normal = choice_normal;
        from.pdf = specular ? 0.0f : b.pdf;
        cone = ray_cone_bounce(cone, (b.lobe & LOBE_DIFFUSE) != 0u ? 1.0f : p.bsdf.alpha_x);
        ray.origin = offset_ray_origin(s.position, wi_side > 0.0f ? s.ng : -s.ng);
        ray.direction = wi;
        ray.t_min = 0.0f;
        ray.t_max = FLOAT_MAX;
        state.depth += 1u;
        hit = trace_closest(ray);
    }
    return r;
}

#endif
