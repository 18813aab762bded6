// Light of surfaces, by what a pixel and its neighbours found in the last frame: their bounce rays'
// ways of light (indirect_path.glsl), resampled.
// Based on: Ouyang et al. 2021, "ReSTIR GI"; the unbiased variant by Lin, Kettunen et al. 2022,
// "Generalized Resampled Importance Sampling". Time and space in one step, as light_reuse.glsl.
// Resources: load_previous_… and store_… of the indirect_reservoir images, and those of
// indirect_path.glsl.
#ifndef GP_KERNELS_REALTIME_INDIRECT_REUSE_GLSL
#define GP_KERNELS_REALTIME_INDIRECT_REUSE_GLSL
#include "kernels/realtime/indirect_path.glsl"

// What a pixel's own bounce ray found.
struct OwnBounce {
    IndirectReservoir found;  // weight 0: nothing
    IndirectPath path;
    vec3 light;               // path.light over the probability of the light
};

OwnBounce own_bounce_none() {
    OwnBounce own;
    own.found = indirect_reservoir_empty();
    own.path = indirect_path_none();
    own.light = vec3(0.0f);
    return own;
}

// As if the path's clamp had been applied to it: what is left over what was there.
float clamped_share(vec3 light) {
    PathLight sum;
    sum.emission = vec3(0.0f);
    sum.direct = vec3(0.0f);
    sum.indirect = vec3(0.0f);
    float clamped = luminance(add_light(sum, light, 2u).indirect);
    float whole = luminance(light);
    return clamped < whole ? clamped / whole : 1.0f;
}

// Takes out of the path what may be resampled: the light of its second surface's shadow ray, which
// has just been traced. `hit` is where that surface is, `pdf` the density of the bounce ray.
OwnBounce take_bounce(INOUT(PathState) path, IN(PixelSurface) at, IN(Hit) hit, float pdf) {
    LET_REF(FrameConstants) f = load_frame();
    OwnBounce own = own_bounce_none();
    IndirectSegment way = indirect_segment(at, surface_position(hit));
    if (way.exists == 0u) { return own; }
    // The weights of lights that further bounces find, as unshadowed_light weighs them.
    path.from.groups.resampled = 1u;
    if (path.light.indirect == vec3(0.0f)) { return own; }
    vec2 u = draw_at(path.draws, 1u, DRAW_LIGHT);
    PixelSurface there = bounce_surface(hit, way, u);
    bool transmissive = f.diffuse_shading == 0u && (there.p.flags & MATERIAL_LIT_FROM_BELOW) != 0u;
    PathVertex vertex = path_vertex(there.s, there.wo, transmissive);
    LightChoice choice = choose_light(vertex.groups, vertex.position, vertex.normal,
                                      draw_at(path.draws, 1u, DRAW_CHOICES).x);
    // Suns that rays may find have weights with their probability.
    bool sun = choice.light < f.directional_lights && load_light(choice.light).radius > 0.0f;
    if (!(choice.pmf > 0.0f) || (sun && f.max_bounces > 1u)) { return own; }
    own.path = indirect_path_over(at, way, there, choice.light, u);
    vec3 all = own.path.all_light / choice.pmf;
    float share = clamped_share(all);
    own.light = own.path.light * (share / choice.pmf);
    path.light.indirect = max(all * share - own.light, vec3(0.0f));
    if (!(own.path.target > 0.0f)) { return own; }
    own.found.light.light = choice.light;
    own.found.light.u = u;
    own.found.light.weight = share / (pdf * own.path.geometry * choice.pmf);
    own.found.hit = uvec2(hit.instance, hit.primitive);
    own.found.barycentrics = pack_barycentrics(hit.u, hit.v);
    return own;
}

// A reservoir of the last frame in this frame's numbers; count 0: there is none.
IndirectReservoir past_indirect_reservoir(ivec2 past) {
    IndirectReservoir r;
    r.light = reservoir_now(reservoir_unpack(load_previous_indirect_reservoir(past),
                                             load_previous_indirect_reservoir_weight(past)));
    Hit hit = hit_of_past(load_previous_indirect_reservoir_hit(past),
                          load_previous_indirect_reservoir_barycentrics(past));
    r.hit = uvec2(hit.instance, hit.primitive);
    r.barycentrics = pack_barycentrics(hit.u, hit.v);
    if (r.hit.x == NO_INDEX || r.light.light == NO_INDEX) { r.light.weight = 0.0f; }
    return r;
}

void keep_indirect_reservoir(ivec2 pixel, IN(IndirectReservoir) r) {
    store_indirect_reservoir(pixel, reservoir_pack_sample(r.light));
    store_indirect_reservoir_weight(pixel, reservoir_pack_weight(r.light));
    store_indirect_reservoir_hit(pixel, r.hit);
    store_indirect_reservoir_barycentrics(pixel, r.barycentrics);
}

// What is chosen of the ways of light that a pixel knows.
struct IndirectChoice {
    IndirectReservoir kept;
    IndirectPath path;
    uint source;      // 0: its own; else 1 + the number of the neighbour that handed it on
};

// Where the past neighbours of a pixel are, as often as it asks.
struct IndirectNeighbours {
    ivec2 own_past;
    uint count;       // beside the pixel's own past
    uint used;        // a bit for each that took part
    float most;       // count that each may stand for
    Sampler placing;
};

// The surface of a past pixel is far nearer to the find, or far farther from it, than this one: few
// finds would have to stand for many. `there`: where the find is.
bool too_unlike(IN(IndirectPath) path, vec3 there, ivec2 past) {
    float limit = load_realtime().indirect_reuse_ratio;
    Hit hit = hit_of_past(load_previous_hit(past), load_previous_barycentrics(past));
    if (hit.instance == NO_INDEX) { return true; }
    vec3 to = there - surface_position(hit);
    float distance = max(length(to), 1.0e-30f);
    float before = bounce_geometry(path.normal, to / distance, distance);
    return !(path.geometry < limit * before) || !(before < limit * path.geometry);
}

// The sum that the balance heuristic divides by: what the sample brings to each of those who could
// have found it, by how many finds each stands for; over what it brings to the one who did.
// [Bitterli et al. 2020, algorithm 6, with the balance heuristic in place of 1 / Z]
float balance_count(IN(IndirectChoice) choice, float own_count,
                    IN(IndirectNeighbours) neighbours) {
    Sampler draws = neighbours.placing;
    float sum = own_count * choice.path.target;
    float source_target = choice.path.target;
    for (uint i = 0u; i <= neighbours.count; ++i) {
        ivec2 past = past_neighbour(neighbours.own_past, i, load_realtime().indirect_reuse_radius,
                                    sampler_next_2d(draws));
        if ((neighbours.used & (1u << i)) == 0u) { continue; }
        float target = 0.0f;
        PixelSurface there = load_past_surface(past);
        if (there.exists != 0u) {
            IndirectPath path = indirect_path(there, choice.kept);
            bool is_source = choice.source == i + 1u;
            if (path.target > 0.0f && (is_source || bounce_visible(there, path.way) > 0.0f)) {
                target = path.target;
            }
        }
        if (choice.source == i + 1u) { source_target = target; }
        sum += target * min(past_indirect_reservoir(past).light.count, neighbours.most);
    }
    return source_target > 0.0f ? sum / source_target : 0.0f;
}

// Offers what the last frame's pixels keep. `placing` are the draws that place them.
IndirectNeighbours offer_past(INOUT(ReservoirStream) stream, INOUT(IndirectChoice) choice,
                              ivec2 pixel, IN(PixelSurface) at, IN(Sampler) placing) {
    LET_REF(RealtimeConstants) r = load_realtime();
    vec4 motion = load_motion(pixel);
    IndirectNeighbours n;
    n.own_past = past_place(pixel, motion);
    n.count = min(uint(r.indirect_reuse_neighbours), uint(REUSE_MOST_NEIGHBOURS - 1));
    n.used = 0u;
    n.most = r.indirect_reuse_history;
    n.placing = placing;
    Sampler draws = placing;
    Sampler deciding = placing;
    deciding.dimension += uint(REUSE_MOST_NEIGHBOURS);
    for (uint i = 0u; i <= n.count; ++i) {
        ivec2 past =
            past_neighbour(n.own_past, i, r.indirect_reuse_radius, sampler_next_2d(draws));
        float u = sampler_next_1d(deciding);
        if (!past_is_like(pixel, past, motion)) { continue; }
        IndirectReservoir found = past_indirect_reservoir(past);
        if (!(found.light.count > 0.0f)) { continue; }
        IndirectPath path = indirect_path_none();
        if (found.light.weight > 0.0f) { path = indirect_path(at, found); }
        if (r.indirect_reuse == LIGHT_REUSE_BIASED && path.target > 0.0f &&
            too_unlike(path, at.s.position + path.way.wi * path.way.distance, past)) {
            continue;
        }
        n.used |= 1u << i;
        if (reservoir_offer(stream, found.light.light, found.light.u, path.target,
                            found.light.weight, min(found.light.count, n.most), u)) {
            choice.kept.hit = found.hit;
            choice.kept.barycentrics = found.barycentrics;
            choice.path = path;
            choice.source = i + 1u;
        }
    }
    return n;
}

// The pixel's own find against those of the last frame.
IndirectChoice resampled_bounce(ivec2 pixel, IN(PixelSurface) at, IN(OwnBounce) own,
                                IN(Sampler) draws) {
    LET_REF(RealtimeConstants) r = load_realtime();
    const float own_count = 1.0f;
    IndirectChoice choice;
    choice.kept = own.found;
    choice.path = own.path;
    choice.source = 0u;
    ReservoirStream stream = reservoir_stream_empty();
    reservoir_offer(stream, own.found.light.light, own.found.light.u, own.path.target,
                    own.found.light.weight, own_count, 0.0f);
    float count = own_count;
    uint flags = unpack_material(load_material(pixel)).flags;
    if (r.has_previous != 0u && (flags & REALTIME_NO_HISTORY) == 0u) {
        IndirectNeighbours neighbours = offer_past(stream, choice, pixel, at, draws);
        count = stream.kept.count;
        // Hidden ones bring nothing, whatever their weight.
        if (choice.source != 0u && !(bounce_visible(at, choice.path.way) > 0.0f)) {
            choice.path.target = 0.0f;
        }
        choice.kept.light = stream.kept;
        if (r.indirect_reuse == LIGHT_REUSE_UNBIASED && choice.path.target > 0.0f) {
            count = balance_count(choice, own_count, neighbours);
        }
    }
    stream.target = choice.path.target;
    choice.kept.light = reservoir_finished(stream, count);
    return choice;
}

// What `past` chose in the last frame, looked at anew.
IndirectChoice repeated_bounce(ivec2 past, IN(PixelSurface) at) {
    IndirectChoice choice;
    choice.kept = past_indirect_reservoir(past);
    choice.path = indirect_path_none();
    choice.source = 1u;
    if (!(choice.kept.light.weight > 0.0f)) { return choice; }
    choice.path = indirect_path(at, choice.kept);
    if (choice.path.target > 0.0f && !(bounce_visible(at, choice.path.way) > 0.0f)) {
        choice.kept.light.weight = 0.0f;
    }
    return choice;
}

// The way that a pixel's light of surfaces comes by, and its weight; `past` repeats a pixel of the
// last frame where that is not negative.
IndirectChoice chosen_bounce(ivec2 pixel, ivec2 past, IN(PixelSurface) at, IN(OwnBounce) own,
                             IN(Sampler) draws) {
    IndirectChoice choice;
    if (past.x >= 0) {
        choice = repeated_bounce(past, at);
    } else {
        choice = resampled_bounce(pixel, at, own, draws);
    }
    // Where things have moved, what lit the find may be hidden from it by now.
    if (choice.source != 0u && load_realtime().scene_changed != 0u &&
        choice.kept.light.weight > 0.0f && choice.path.target > 0.0f &&
        !(trace_visible(choice.path.beyond) > 0.0f)) {
        choice.kept.light.weight = 0.0f;
    }
    if (!(choice.path.target > 0.0f)) { choice.kept.light.weight = 0.0f; }
    keep_indirect_reservoir(pixel, choice.kept);
    return choice;
}

#endif
