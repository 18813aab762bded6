// The light of the surface that a pixel shows, with about one path: a shadow ray to a directional
// light, one to any other light, and one ray by the material, whose path goes on as the
// reference's does. What they bring is kept in three channels: diffuse light of lamps and sky,
// diffuse light of surfaces, and all else; and beside them the suns that facets of slopes reflect.
// Resources: load_gradient_sample, store_… of the channels, sun and luma, note_draws, and those of
// light_reuse.glsl, indirect_reuse.glsl and sun_reflection.glsl.
#ifndef GP_KERNELS_REALTIME_LIGHTING_GLSL
#define GP_KERNELS_REALTIME_LIGHTING_GLSL
#include "kernels/realtime/indirect_reuse.glsl"
#include "kernels/realtime/light_reuse.glsl"
#include "kernels/realtime/pixel_surface.glsl"
#include "kernels/realtime/sun_reflection.glsl"
#include "shading/ycocg.glsl"

// Draws of lighting start here, behind those of the longest way through mirrors.
#define LIGHTING_DRAWS 128u
#define DRAW_SUN_CHOICE 0u  // before those of the path's vertices
#define DRAW_SUN 1u
#define LIGHTING_OWN_DRAWS 2u
#define REUSE_DRAWS 192u    // of light reuse, behind those of any path
#define INDIRECT_REUSE_DRAWS 384u  // behind those of light reuse

#define SKY_DISTANCE 65504.0f  // of what a specular ray shows, where that is the sky

// Radiance over albedo.
struct PixelLight {
    vec3 direct;
    vec3 indirect;
    vec3 indirect_from;   // mean direction of the latter, by its luma
    vec3 specular;
    float specular_distance;
};

// Adds light that arrives from wi: `f` is what the surface reflects of it, over any density.
PixelLight add_direct(PixelLight sum, IN(PixelSurface) at, vec3 wi_local, vec3 f, float inv_pdf,
                      vec3 light) {
    vec3 diffuse = diffuse_share(at, wi_local, f, inv_pdf);
    vec3 seen = at.throughput * light;
    sum.direct += diffuse * seen * at.inv_albedo;
    sum.specular += (f - diffuse) * seen * at.inv_specular_albedo;
    return sum;
}

// Adds light of surfaces that arrives from wi, which the diffuse lobe has `diffuse` of and all
// others `other`.
PixelLight add_indirect(PixelLight sum, IN(PixelSurface) at, vec3 wi, vec3 diffuse, vec3 other,
                        vec3 light) {
    vec3 seen = at.throughput * light;
    vec3 more = diffuse * seen * at.inv_albedo;
    float luma = ycocg_from_rgb(sum.indirect).x;
    float more_luma = ycocg_from_rgb(more).x;
    float share = luma > 0.0f ? more_luma / (luma + more_luma) : 1.0f;
    sum.indirect_from = sum.indirect_from * (1.0f - share) + wi * share;
    sum.indirect += more;
    sum.specular += other * seen * at.inv_specular_albedo;
    return sum;
}

PixelLight add_shadow_ray(PixelLight sum, IN(PixelSurface) at, IN(ChosenLight) choice,
                          float resampled) {
    ShadowedLight arrived =
        shadowed_light(at.s, at.p, choice, at.wo_local, at.wo, at.around, true, resampled);
    if (arrived.light == vec3(0.0f)) { return sum; }
    return add_direct(sum, at, arrived.wi_local, arrived.f_cos, 1.0f, arrived.light);
}

// The shadow ray to a light that is not directional, by what pixels have found so far. `past`
// repeats a pixel of the last frame where that is not negative.
PixelLight add_resampled_ray(PixelLight sum, ivec2 pixel, ivec2 past, IN(PixelSurface) at,
                             IN(PathVertex) vertex, Sampler draws) {
    draws.dimension = REUSE_DRAWS;
    Reservoir reservoir;
    if (past.x >= 0) {
        reservoir = past_reservoir(past);
    } else {
        reservoir = resampled_light(pixel, at, vertex, draws);
    }
    if (reservoir.light == NO_INDEX || !(reservoir.weight > 0.0f)) {
        keep_reservoir(pixel, reservoir, true);
        return sum;
    }
    LightChoice choice;
    choice.light = reservoir.light;
    choice.pmf = 1.0f;
    ChosenLight chosen = chosen_light_point(choice, vertex.position, reservoir.u);
    PixelLight next = add_shadow_ray(sum, at, chosen, reservoir.weight);
    bool visible = next.direct != sum.direct || next.specular != sum.specular;
    keep_reservoir(pixel, reservoir, visible);
    return next;
}

// What the ray by the material brings, but for what is left to others to find.
struct BouncedLight {
    PixelLight sum;
    OwnBounce own;
};

// The ray by the material, and the path behind it. `reuse`: the light that its first surface's
// shadow ray finds is not added where it can be resampled. `suns_apart`: nor are the suns that it
// meets on the side of the surface from which it comes.
BouncedLight add_bounce(PixelLight sum, IN(PixelSurface) at, IN(PathVertex) vertex,
                        IN(PathState) start, IN(BsdfSample) b, bool reuse, bool suns_apart) {
    PathState path = start;
    BouncedLight bounced;
    bounced.sum = sum;
    bounced.own = own_bounce_none();
    path_leave(path, at.s, at.p, vertex, at.wo_local, b, -1.0f);
    if (path.ended != 0u) { return bounced; }
    path.throughput = vec3(1.0f);
    bool reflected = suns_apart && same_side(at.p.bsdf, at.wo_local, b.wi);
    path.from.groups.suns_elsewhere = reflected ? 1u : 0u;
    path.hit = trace_closest(path.ray);
    vec3 wi = path.ray.direction;
    sum.specular_distance =
        path.hit.instance == HIT_NOTHING ? SKY_DISTANCE : min(path.hit.t, SKY_DISTANCE);
    Hit first = path.hit;
    // Ways of light that pixels hand on lead through one medium and are not bent.
    bool handed_on = reuse && path.water == 0u;
    path_continue(path);
    if (handed_on && first.instance < HIT_LIGHT) {
        bounced.own = take_bounce(path, at, first, b.pdf);
    }
    while (path.ended == 0u) {
        path.hit = trace_closest(path.ray);
        path_continue(path);
    }
    float inv_pdf = 1.0f / b.pdf;
    vec3 diffuse = diffuse_share(at, b.wi, b.weight, inv_pdf);
    vec3 other = max(b.weight - diffuse, vec3(0.0f));
    sum = add_direct(sum, at, b.wi, b.weight, inv_pdf, path.light.direct);
    sum = add_indirect(sum, at, wi, diffuse, other, path.light.indirect);
    if (reuse && !takes_part(at)) {
        sum = add_indirect(sum, at, wi, vec3(0.0f), other, bounced.own.light);
    }
    bounced.sum = sum;
    return bounced;
}

// The light that add_bounce left out, by what pixels have found so far.
PixelLight add_resampled_bounce(PixelLight sum, ivec2 pixel, ivec2 past, IN(PixelSurface) at,
                                IN(OwnBounce) own, Sampler draws) {
    draws.dimension = INDIRECT_REUSE_DRAWS;
    IndirectChoice choice = chosen_bounce(pixel, past, at, own, draws);
    float weight = choice.kept.light.weight;
    if (!(weight > 0.0f)) { return sum; }
    LET_REF(IndirectPath) path = choice.path;
    return add_indirect(sum, at, path.way.wi, path.diffuse, path.f - path.diffuse,
                        path.light * (weight * path.geometry));
}

// Unless the sun is apart, or behind the surface.
PixelLight add_sun_ray(PixelLight sum, IN(PixelSurface) at, IN(PathVertex) vertex,
                       IN(SunLight) suns, Sampler own) {
    if (!(vertex.groups.directional > 0.0f)) { return sum; }
    ChosenLight sun = choose_light_point(light_groups_directional(vertex.groups), vertex.position,
                                         vertex.normal, draw_at(own, 0u, DRAW_SUN_CHOICE).x,
                                         draw_at(own, 0u, DRAW_SUN));
    bool known = suns.apart != 0u && same_side(at.p.bsdf, at.wo_local,
                                               local_from_world(at.p.frame, sun.point.wi));
    return known ? sum : add_shadow_ray(sum, at, sun, 0.0f);
}

PixelLight pixel_light(ivec2 pixel, ivec2 past, IN(PixelSurface) at, IN(SunLight) suns,
                       Sampler draws) {
    PixelLight sum;
    sum.direct = vec3(0.0f);
    sum.indirect = vec3(0.0f);
    sum.indirect_from = vec3(0.0f);
    sum.specular = suns.matte * at.throughput * at.inv_specular_albedo;
    sum.specular_distance = 0.0f;
    bool transmissive = (at.p.flags & MATERIAL_LIT_FROM_BELOW) != 0u;
    PathVertex vertex = path_vertex(at.s, at.wo, transmissive);
    vertex.groups = light_groups_apart(vertex.groups);
    bool reuse = load_realtime().light_reuse != LIGHT_REUSE_NONE;
    vertex.groups.resampled = reuse ? 1u : 0u;
    Sampler own = draws;
    own.dimension = LIGHTING_DRAWS;
    draws.dimension = LIGHTING_DRAWS + LIGHTING_OWN_DRAWS;
    vec2 u_choices = draw_at(draws, 0u, DRAW_CHOICES);
    if (!bsdf_is_specular(at.p.bsdf)) {
        sum = add_sun_ray(sum, at, vertex, suns, own);
        if (reuse) {
            sum = add_resampled_ray(sum, pixel, past, at, vertex, draws);
        } else {
            ChosenLight other = choose_light_point(
                light_groups_others(vertex.groups), vertex.position, vertex.normal, u_choices.x,
                draw_at(draws, 0u, DRAW_LIGHT));
            sum = add_shadow_ray(sum, at, other, 0.0f);
        }
    } else if (reuse) {
        keep_reservoir(pixel, reservoir_empty(), true);
    }
    BsdfSample b =
        bsdf_sample(at.p.bsdf, at.wo_local, u_choices.y, draw_at(draws, 0u, DRAW_BSDF));
    Ray arriving;
    arriving.origin = at.s.position;
    arriving.direction = -at.wo;
    arriving.t_min = 0.0f;
    arriving.t_max = 0.0f;
    RayCone cone;
    cone.width = 0.0f;
    cone.spread = camera_pixel_spread(load_camera(), float(load_realtime().size.y));
    bool indirect_reuse = load_realtime().indirect_reuse != LIGHT_REUSE_NONE;
    PathState start = path_begin(arriving, cone, draws);
    path_set_water(start, path_water_behind(at.water, at.p, at.around));
    BouncedLight bounced =
        add_bounce(sum, at, vertex, start, b, indirect_reuse, suns.apart != 0u);
    return indirect_reuse
               ? add_resampled_bounce(bounced.sum, pixel, past, at, bounced.own, draws)
               : bounced.sum;
}

vec3 finite_or_black(vec3 v) {
    return v.x + v.y + v.z < FLOAT_MAX ? v : vec3(0.0f);
}

void store_pixel_light(ivec2 pixel, IN(PixelLight) light) {
    vec3 direct = finite_or_black(light.direct);
    vec3 indirect = finite_or_black(light.indirect);
    vec3 specular = finite_or_black(light.specular);
    store_direct(pixel, vec4(direct, 1.0f));
    store_indirect_raw(pixel, indirect);
    store_indirect_from(pixel, octahedral_encode(light.indirect_from));
    store_specular(pixel, vec4(specular, light.specular_distance));
    store_luma(pixel, vec4(luminance(direct), ycocg_from_rgb(indirect).x, luminance(specular),
                           0.0f));
}

// Light of a surface, of the draws with which it was loaded.
SunLight suns_on(IN(PixelSurface) at, Sampler draws) {
    if (!suns_are_apart(at)) { return sun_light_none(); }
    draws.dimension = LIGHTING_DRAWS;
    return light_of_suns(at, draw_at(draws, 0u, DRAW_SUN));
}

// A pixel that repeats another one lights a point of that one: as no filter follows that would hide
// it, the suns of its own point are computed too.
void store_own_suns(ivec2 pixel, ivec2 past, uint mirrors, IN(PixelSurface) at,
                    IN(SunLight) suns) {
    vec3 shown = suns.facets * at.throughput;
    if (past.x >= 0 && suns.apart != 0u) {
        Sampler draws = realtime_draws(pixel, load_realtime().frame_index);
        draws.dimension = CAMERA_DRAWS;
        note_draws(draws);
        PixelSurface own = load_pixel_surface(pixel, draws, mirrors);
        draws.dimension = LIGHTING_DRAWS;
        shown = own.p.bsdf.model == MODEL_GLINT
                    ? light_of_suns(own, draw_at(draws, 0u, DRAW_SUN)).facets * own.throughput
                    : vec3(0.0f);
    }
    store_sun(pixel, finite_or_black(shown));
}

void realtime_light(ivec2 pixel) {
    LET_REF(RealtimeConstants) r = load_realtime();
    PixelMaterial m = unpack_material(load_material(pixel));
    PixelLight none;
    none.direct = vec3(0.0f);
    none.indirect = vec3(0.0f);
    none.indirect_from = vec3(0.0f);
    none.specular = vec3(0.0f);
    none.specular_distance = SKY_DISTANCE;
    if ((m.flags & (REALTIME_SKY | REALTIME_UNLIT)) != 0u) {
        store_pixel_light(pixel, none);
        if (r.suns_apart != 0u) { store_sun(pixel, vec3(0.0f)); }
        if (r.light_reuse != LIGHT_REUSE_NONE) { keep_reservoir(pixel, reservoir_empty(), true); }
        if (r.indirect_reuse != LIGHT_REUSE_NONE) {
            keep_indirect_reservoir(pixel, indirect_reservoir_empty());
        }
        return;
    }
    ivec2 drawing = pixel;
    ivec2 past = ivec2(-1);
    uint frame_index = r.frame_index;
    if (r.repeats_draws != 0u) {
        ivec2 block = pixel / 3;
        uint code = load_gradient_sample(block);
        ivec2 inside = pixel - block * 3;
        if ((code & 15u) == uint(1 + inside.x + 3 * inside.y)) {
            past = ivec2(int((code >> 4u) & 16383u), int(code >> 18u));
            drawing = past;
            frame_index -= 1u;
        }
    }
    Sampler draws = realtime_draws(drawing, frame_index);
    draws.dimension = CAMERA_DRAWS;
    note_draws(draws);
    PixelSurface at;
    if (past.x >= 0) {
        at = load_repeated_surface(pixel, past, draws);
    } else {
        at = load_pixel_surface(pixel, draws, m.mirrors);
    }
    SunLight suns = suns_on(at, draws);
    PixelLight light = pixel_light(pixel, past, at, suns, draws);
    // Waves turn the mirror from pixel to pixel: what tells their reflections apart is on the water
    // and goes with it, as the image in a mirror so strongly curved lies close behind it.
    if ((at.p.flags & MATERIAL_SEA) != 0u) { light.specular_distance = 0.0f; }
    store_pixel_light(pixel, light);
    if (r.suns_apart != 0u) { store_own_suns(pixel, past, m.mirrors, at, suns); }
}

#endif
