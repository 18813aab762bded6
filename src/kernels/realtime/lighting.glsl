// The light of the surface that a pixel shows, with about one path: a shadow ray to a directional
// light, one to any other light, and one ray by the material, whose path goes on as the
// reference's does. What they bring is kept in three channels: diffuse light of lamps and sky,
// diffuse light of surfaces, and all else.
// Resources: load_… of the G-buffer and gradient_sample, store_… of the channels and luma, and
// those of primary.glsl.
#ifndef GP_KERNELS_REALTIME_LIGHTING_GLSL
#define GP_KERNELS_REALTIME_LIGHTING_GLSL
#include "kernels/realtime/primary.glsl"
#include "shading/ycocg.glsl"

// Draws of lighting start here, behind those of the longest way through mirrors.
#define LIGHTING_DRAWS 128u
#define DRAW_SUN_CHOICE 0u  // before those of the path's vertices
#define DRAW_SUN 1u
#define LIGHTING_OWN_DRAWS 2u

#define SKY_DISTANCE 65504.0f  // of what a specular ray shows, where that is the sky

// A surface read back from the G-buffer.
struct PixelSurface {
    Surface s;
    ShadingPoint p;
    vec3 wo;
    vec3 wo_local;
    vec3 throughput;
    vec3 inv_albedo;           // 0 where there is no albedo
    vec3 inv_specular_albedo;
};

// Radiance over albedo.
struct PixelLight {
    vec3 direct;
    vec3 indirect;
    vec3 indirect_from;   // direction of the latter
    vec3 specular;
    float specular_distance;
};

vec3 inverse_or_zero(vec3 v) {
    return vec3(v.x > 0.0f ? 1.0f / v.x : 0.0f, v.y > 0.0f ? 1.0f / v.y : 0.0f,
                v.z > 0.0f ? 1.0f / v.z : 0.0f);
}

PixelSurface load_pixel_surface(ivec2 pixel, IN(Sampler) primary_draws, uint mirrors) {
    LET_REF(RealtimeConstants) r = load_realtime();
    PixelSurface at;
    uvec2 shown = load_hit(pixel);
    vec2 bary = unpack_barycentrics(load_barycentrics(pixel));
    Hit hit;
    hit.t = 0.0f;
    hit.u = bary.x;
    hit.v = bary.y;
    hit.instance = shown.x;
    hit.primitive = shown.y;
    at.wo = octahedral_decode(load_view(pixel));
    bool diffuse = load_frame().diffuse_shading != 0u;
    LET_REF(MaterialRecord) material = load_material(load_instance(hit.instance).material);
    RayCone cone = ray_cone_propagate(camera_ray_cone(load_camera(), float(r.size.y)),
                                      load_depth(pixel));
    at.s = load_surface(hit, -at.wo, cone, surface_needs(material, diffuse));
    float u_lod = draw_at(primary_draws, mirrors, DRAW_OTHERS).x;
    at.p = load_shading_point(material, at.s, at.wo, u_lod, diffuse);
    at.wo_local = local_from_world(at.p.frame, at.wo);
    at.throughput = vec3(load_throughput(pixel));
    at.inv_albedo = inverse_or_zero(vec3(load_albedo(pixel)));
    at.inv_specular_albedo = inverse_or_zero(vec3(load_specular_albedo(pixel)));
    return at;
}

// Adds light that arrives from wi: `f` is what the surface reflects of it, over any density.
PixelLight add_direct(PixelLight sum, IN(PixelSurface) at, vec3 wi_local, vec3 f, float inv_pdf,
                      vec3 light) {
    vec3 diffuse = bsdf_is_diffuse(at.p.bsdf)
                       ? f : bsdf_diffuse_part(at.p.bsdf, at.wo_local, wi_local) * inv_pdf;
    vec3 seen = at.throughput * light;
    sum.direct += diffuse * seen * at.inv_albedo;
    sum.specular += (f - diffuse) * seen * at.inv_specular_albedo;
    return sum;
}

// One shadow ray, to a light of `groups`.
PixelLight add_shadow_ray(PixelLight sum, IN(PixelSurface) at, IN(PathVertex) vertex,
                          IN(LightGroups) groups, float u_choice, vec2 u) {
    ChosenLight choice =
        choose_light_point(groups, vertex.position, vertex.normal, u_choice, u);
    ShadowedLight arrived =
        shadowed_light(at.s, at.p, choice, at.wo_local, at.wo, vec3(0.0f), true);
    if (arrived.light == vec3(0.0f)) { return sum; }
    return add_direct(sum, at, arrived.wi_local, arrived.f_cos, 1.0f, arrived.light);
}

// The ray by the material, and the path behind it.
PixelLight add_bounce(PixelLight sum, IN(PixelSurface) at, IN(PathVertex) vertex,
                      IN(PathState) start, IN(BsdfSample) b) {
    PathState path = start;
    path_leave(path, at.s, at.p, vertex, at.wo_local, b, -1.0f);
    if (path.ended != 0u) { return sum; }
    path.throughput = vec3(1.0f);
    path.hit = trace_closest(path.ray);
    vec3 wi = path.ray.direction;
    sum.specular_distance =
        path.hit.instance == HIT_NOTHING ? SKY_DISTANCE : min(path.hit.t, SKY_DISTANCE);
    while (path.ended == 0u) {
        path_continue(path);
        if (path.ended == 0u) { path.hit = trace_closest(path.ray); }
    }
    float inv_pdf = 1.0f / b.pdf;
    vec3 diffuse = bsdf_is_diffuse(at.p.bsdf)
                       ? b.weight : bsdf_diffuse_part(at.p.bsdf, at.wo_local, b.wi) * inv_pdf;
    sum = add_direct(sum, at, b.wi, b.weight, inv_pdf, path.light.direct);
    vec3 seen = at.throughput * path.light.indirect;
    sum.indirect = diffuse * seen * at.inv_albedo;
    sum.indirect_from = wi;
    sum.specular += max(b.weight - diffuse, vec3(0.0f)) * seen * at.inv_specular_albedo;
    return sum;
}

PixelLight pixel_light(IN(PixelSurface) at, Sampler draws) {
    PixelLight sum;
    sum.direct = vec3(0.0f);
    sum.indirect = vec3(0.0f);
    sum.indirect_from = vec3(0.0f);
    sum.specular = vec3(0.0f);
    sum.specular_distance = 0.0f;
    bool transmissive = (at.p.flags & MATERIAL_TRANSMISSIVE) != 0u;
    PathVertex vertex = path_vertex(at.s, at.wo, transmissive);
    vertex.groups = light_groups_apart(vertex.groups);
    Sampler own = draws;
    own.dimension = LIGHTING_DRAWS;
    draws.dimension = LIGHTING_DRAWS + LIGHTING_OWN_DRAWS;
    vec2 u_choices = draw_at(draws, 0u, DRAW_CHOICES);
    if (!bsdf_is_specular(at.p.bsdf)) {
        if (vertex.groups.directional > 0.0f) {
            sum = add_shadow_ray(sum, at, vertex, light_groups_directional(vertex.groups),
                                 draw_at(own, 0u, DRAW_SUN_CHOICE).x, draw_at(own, 0u, DRAW_SUN));
        }
        sum = add_shadow_ray(sum, at, vertex, light_groups_others(vertex.groups), u_choices.x,
                             draw_at(draws, 0u, DRAW_LIGHT));
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
    return add_bounce(sum, at, vertex, path_begin(arriving, cone, draws), b);
}

vec3 finite_or_black(vec3 v) {
    return v.x + v.y + v.z < FLOAT_MAX ? v : vec3(0.0f);
}

void store_pixel_light(ivec2 pixel, IN(PixelLight) light) {
    vec3 direct = finite_or_black(light.direct);
    vec3 indirect = ycocg_from_rgb(finite_or_black(light.indirect));
    vec3 specular = finite_or_black(light.specular);
    store_direct(pixel, vec4(direct, 1.0f));
    store_indirect(pixel, vec4(indirect.x, light.indirect_from * indirect.x));
    store_indirect_chroma(pixel, vec2(indirect.y, indirect.z));
    store_specular(pixel, vec4(specular, light.specular_distance));
    store_luma(pixel, vec4(luminance(direct), indirect.x, luminance(specular), 0.0f));
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
        return;
    }
    ivec2 drawing = pixel;
    uint frame_index = r.frame_index;
    if (r.repeats_draws != 0u) {
        ivec2 block = pixel / 3;
        uint code = load_gradient_sample(block);
        ivec2 inside = pixel - block * 3;
        if ((code & 15u) == uint(1 + inside.x + 3 * inside.y)) {
            drawing = ivec2(int((code >> 4u) & 16383u), int(code >> 18u));
            frame_index -= 1u;
        }
    }
    Sampler draws = realtime_draws(drawing, frame_index);
    draws.dimension = CAMERA_DRAWS;
    note_draws(draws);
    store_pixel_light(pixel, pixel_light(load_pixel_surface(pixel, draws, m.mirrors), draws));
}

#endif
