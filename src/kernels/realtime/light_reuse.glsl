// Which light a pixel's shadow ray goes to, by what it and its neighbours found in the last frame.
// Based on: Bitterli et al. 2020 (reservoir.glsl), with what Wyman and Panteleev 2021,
// "Rearchitecting Spatiotemporal Resampling for Production", made of it: time and space in one
// step, from the reservoirs of the last frame.
// Resources: load_previous_reservoir, load_previous_reservoir_weight, store_reservoir,
// store_reservoir_weight, load_current_light, and those of pixel_surface.glsl.
#ifndef GP_KERNELS_REALTIME_LIGHT_REUSE_GLSL
#define GP_KERNELS_REALTIME_LIGHT_REUSE_GLSL
#include "kernels/realtime/gradient_reproject.glsl"
#include "kernels/realtime/pixel_surface.glsl"
#include "kernels/realtime/reservoir.glsl"

#define REUSE_MOST_NEIGHBOURS 9   // the pixel's own past included

// What a point of a light would bring to a surface, were it not hidden.
struct UnshadowedLight {
    LightSample point;
    vec3 wi_local;
    vec3 f_cos;
    vec3 light;    // radiance over the density of the point on its light; zero: none
};

// `weigh`: weighted against rays by the material.
UnshadowedLight unshadowed_light(IN(PixelSurface) at, uint light, vec2 u, bool weigh) {
    LightChoice choice;
    choice.light = light;
    choice.pmf = 1.0f;
    ChosenLight c = chosen_light_point(choice, at.s.position, u);
    UnshadowedLight there;
    there.point = c.point;
    there.wi_local = vec3(0.0f);
    there.f_cos = vec3(0.0f);
    there.light = vec3(0.0f);
    if (!(c.point.pdf > 0.0f)) { return there; }
    there.wi_local = local_from_world(at.p.frame, c.point.wi);
    if (!sides_agree(at.s, at.p, at.wo, c.point.wi, at.wo_local, there.wi_local)) { return there; }
    BsdfValue value = bsdf_eval(at.p.bsdf, at.wo_local, there.wi_local);
    float w = c.point.is_delta != 0u || !weigh ? 1.0f : mis_power(c.point.pdf, value.pdf);
    there.f_cos = value.f_cos;
    there.light = chosen_light_radiance(c) * (w / c.point.pdf);
    return there;
}

float reuse_target(IN(PixelSurface) at, uint light, vec2 u) {
    UnshadowedLight there = unshadowed_light(at, light, u, true);
    return luminance(there.f_cos * there.light);
}

// A reservoir of the last frame, its light under its present number.
Reservoir reservoir_now(IN(Reservoir) kept) {
    LET_REF(RealtimeConstants) r = load_realtime();
    Reservoir reservoir = kept;
    if (reservoir.light != NO_INDEX && reservoir.light != LIGHT_ENVIRONMENT) {
        reservoir.light =
            reservoir.light < r.previous_lights ? load_current_light(reservoir.light) : NO_INDEX;
    }
    return reservoir;
}

Reservoir past_reservoir(ivec2 past) {
    return reservoir_now(
        reservoir_unpack(load_previous_reservoir(past), load_previous_reservoir_weight(past)));
}

// Where in the last frame the `number`th neighbour is; 0 is the pixel's own past.
ivec2 past_neighbour(ivec2 own, uint number, float most, vec2 u) {
    if (number == 0u) { return own; }
    float radius = most * sqrt(u.x);
    float angle = TWO_PI * u.y;
    return own + ivec2(int(round(radius * cos(angle))), int(round(radius * sin(angle))));
}

// Whether the surface of a past pixel is enough like this one that its light may matter here.
bool past_is_like(ivec2 pixel, ivec2 past, vec4 motion) {
    LET_REF(RealtimeConstants) r = load_realtime();
    if (past.x < 0 || past.y < 0 || past.x >= r.size.x || past.y >= r.size.y) { return false; }
    uint unfit = REALTIME_SKY | REALTIME_UNLIT;
    if ((unpack_material(load_previous_material(past)).flags & unfit) != 0u) { return false; }
    float depth = load_depth(pixel);
    vec3 n = octahedral_decode(load_unmapped_normal(pixel));
    return abs(load_previous_depth(past) - (depth + motion.z)) < GRADIENT_DEPTH_ERROR * depth &&
           dot(n, octahedral_decode(load_previous_unmapped_normal(past))) > GRADIENT_NORMAL_COSINE;
}

// Candidates of this frame, as shadow rays choose without reuse. Returns how many there are.
float offer_candidates(INOUT(ReservoirStream) stream, IN(PixelSurface) at, IN(PathVertex) vertex,
                       INOUT(Sampler) draws) {
    LET_REF(RealtimeConstants) r = load_realtime();
    LightGroups others = light_groups_others(vertex.groups);
    uint count = uint(r.reuse_candidates);
    for (uint i = 0u; i < count; ++i) {
        vec2 u_choice = sampler_next_2d(draws);
        vec2 u = sampler_next_2d(draws);
        LightChoice choice = choose_light(others, vertex.position, vertex.normal, u_choice.x);
        float target = 0.0f;
        float weight = 0.0f;
        if (choice.pmf > 0.0f) {
            target = reuse_target(at, choice.light, u);
            weight = 1.0f / choice.pmf;
        }
        reservoir_offer(stream, choice.light, u, target, weight, 1.0f, u_choice.y);
    }
    return float(count);
}

// How many of the samples that went in could have been the one that came out: those of pixels to
// which it would bring no light could not. [Bitterli et al. 2020, algorithm 6]
float count_possible(IN(ReservoirStream) stream, float own_count, ivec2 own_past, uint neighbours,
                     uint used, IN(Sampler) placing, float most) {
    Sampler draws = placing;
    float possible = own_count;
    for (uint i = 0u; i <= neighbours; ++i) {
        ivec2 past = past_neighbour(own_past, i, load_realtime().reuse_radius,
                                    sampler_next_2d(draws));
        if ((used & (1u << i)) == 0u) { continue; }
        PixelSurface there = load_past_surface(past);
        if (there.exists != 0u && reuse_target(there, stream.kept.light, stream.kept.u) > 0.0f) {
            possible += min(past_reservoir(past).count, most);
        }
    }
    return possible;
}

// The reservoir of a pixel: candidates of its own, and what is kept of the last frame.
Reservoir resampled_light(ivec2 pixel, IN(PixelSurface) at, IN(PathVertex) vertex,
                          Sampler draws) {
    LET_REF(RealtimeConstants) r = load_realtime();
    ReservoirStream stream = reservoir_stream_empty();
    float own_count = offer_candidates(stream, at, vertex, draws);
    PixelMaterial m = unpack_material(load_material(pixel));
    if (r.has_previous == 0u || (m.flags & REALTIME_NO_HISTORY) != 0u) {
        return reservoir_finished(stream, own_count);
    }
    vec4 motion = load_motion(pixel);
    ivec2 own_past = past_place(pixel, motion);
    float most = own_count * r.reuse_history;
    uint neighbours = min(uint(r.reuse_neighbours), uint(REUSE_MOST_NEIGHBOURS - 1));
    uint used = 0u;
    Sampler deciding = draws;
    deciding.dimension += uint(REUSE_MOST_NEIGHBOURS);
    Sampler placing = draws;
    for (uint i = 0u; i <= neighbours; ++i) {
        ivec2 past = past_neighbour(own_past, i, r.reuse_radius, sampler_next_2d(placing));
        float u = sampler_next_1d(deciding);
        if (!past_is_like(pixel, past, motion)) { continue; }
        Reservoir found = past_reservoir(past);
        if (!(found.count > 0.0f)) { continue; }
        used |= 1u << i;
        float target =
            found.light != NO_INDEX && found.weight > 0.0f ? reuse_target(at, found.light, found.u)
                                                           : 0.0f;
        reservoir_offer(stream, found.light, found.u, target, found.weight,
                        min(found.count, most), u);
    }
    float count = stream.kept.count;
    if (r.light_reuse == LIGHT_REUSE_UNBIASED && stream.target > 0.0f) {
        count = count_possible(stream, own_count, own_past, neighbours, used, draws, most);
    }
    return reservoir_finished(stream, count);
}

// What the next frame will ask for. Where reuse may be biased, light that turned out to be hidden
// is not handed on.
void keep_reservoir(ivec2 pixel, IN(Reservoir) reservoir, bool visible) {
    LET_REF(RealtimeConstants) r = load_realtime();
    Reservoir kept = reservoir;
    if (!visible && r.light_reuse == LIGHT_REUSE_BIASED) { kept.weight = 0.0f; }
    store_reservoir(pixel, reservoir_pack_sample(kept));
    store_reservoir_weight(pixel, reservoir_pack_weight(kept));
}

#endif
