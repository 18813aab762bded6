// What each pixel shows: from the camera through mirrors and smooth glass to the first surface
// that scatters light, written into the G-buffer.
// Resources: store_… of the G-buffer, and those of motion.glsl and path.glsl.
#ifndef GP_KERNELS_REALTIME_PRIMARY_GLSL
#define GP_KERNELS_REALTIME_PRIMARY_GLSL
#include "kernels/path.glsl"
#include "kernels/primary.glsl"
#include "kernels/realtime/gbuffer.glsl"
#include "kernels/realtime/motion.glsl"
#include "shading/bsdf/diffuse_part.glsl"

#define LEAST_SPECULAR_ALBEDO 0.04f  // what specular light is divided by, at least

// Where the view of a pixel has got to.
struct PixelView {
    MirrorImage image;
    vec3 emission;     // so far
    uint mirrors;
};

// The ray of a pixel in this frame.
Ray realtime_camera_ray(ivec2 pixel) {
    LET_REF(RealtimeConstants) r = load_realtime();
    vec2 film = vec2((float(pixel.x) + 0.5f + r.jitter.x) / float(r.size.x),
                     (float(pixel.y) + 0.5f + r.jitter.y) / float(r.size.y));
    Ray ray = camera_ray_through_lens(load_camera(), film, vec2(0.0f));
    ray.t_max = load_frame().ray_length;
    return ray;
}

// The draws of a pixel in frame `frame_index`.
Sampler realtime_draws(ivec2 pixel, uint frame_index) {
    return sampler_begin(uvec2(uint(pixel.x), uint(pixel.y)), frame_index, load_frame().seed);
}

void store_no_surface(ivec2 pixel, IN(PixelView) seen, vec3 direction, vec3 throughput,
                      float coverage) {
    PixelMaterial m;
    m.roughness = 1.0f;
    m.metallic = 0.0f;
    m.flags = REALTIME_SKY | REALTIME_UNLIT;
    m.mirrors = seen.mirrors;
    uint towards = octahedral_encode(-direction);
    store_hit(pixel, uvec2(HIT_NOTHING, 0u));
    store_barycentrics(pixel, 0u);
    store_depth(pixel, DEPTH_NONE);
    store_normal(pixel, towards);
    store_unmapped_normal(pixel, towards);
    store_material(pixel, pack_material(m));
    store_view(pixel, towards);
    store_throughput(pixel, vec4(throughput, 0.0f));
    store_albedo(pixel, vec4(0.0f));
    store_specular_albedo(pixel, vec4(0.0f));
    store_emission(pixel, vec4(seen.emission, coverage));
    store_motion(pixel, sky_motion(seen.image, direction));
}

// The diffuse albedo and the rest, seen from wo, as a pixel keeps them.
struct PixelAlbedo {
    vec3 diffuse;
    vec3 specular;
};

PixelAlbedo pixel_albedo(IN(ShadingPoint) p, vec3 wo, vec3 throughput) {
    float cos_o = abs(dot(shown_normal(p), wo));
    PixelAlbedo a;
    a.diffuse = bsdf_diffuse_albedo(p.bsdf, cos_o);
    a.specular = vec3(0.0f);
    if (!bsdf_is_diffuse(p.bsdf)) {
        a.specular = throughput * max(bsdf_albedo(p.bsdf, cos_o) - a.diffuse,
                                      vec3(LEAST_SPECULAR_ALBEDO));
    }
    a.diffuse *= throughput;
    return a;
}

// The width of what is not diffuse, for those who filter it. Models of the library without a width
// of their own leave the smallest; they are no mirrors, or the view would not have ended here.
float pixel_roughness(IN(BsdfParams) m) {
    return bsdf_is_specular(m) ? 0.0f : m.alpha_y <= BSDF_MIN_ALPHA ? 1.0f : sqrt(m.alpha_y);
}

void store_surface(ivec2 pixel, IN(PixelView) seen, IN(Hit) hit, IN(Surface) s,
                   IN(ShadingPoint) p, vec3 wo, vec3 throughput) {
    PreviousPoint previous = previous_point(hit);
    PixelMaterial m;
    m.roughness = pixel_roughness(p.bsdf);
    m.metallic = p.bsdf.metallic;
    m.flags = (p.flags & MATERIAL_UNLIT) != 0u ? REALTIME_UNLIT : 0u;
    m.flags |= previous.known == 0u ? REALTIME_NO_HISTORY : 0u;
    m.mirrors = seen.mirrors;
    vec3 n = shown_normal(p);
    n = dot(n, wo) < 0.0f ? -n : n;
    vec3 smooth_n = dot(s.frame.n, wo) < 0.0f ? -s.frame.n : s.frame.n;
    PixelAlbedo albedo = pixel_albedo(p, wo, throughput);
    bool lit = (m.flags & REALTIME_UNLIT) == 0u;
    vec3 at = mirror_image_of_point(seen.image, s.position);
    store_hit(pixel, uvec2(hit.instance, hit.primitive));
    store_barycentrics(pixel, pack_barycentrics(hit.u, hit.v));
    store_depth(pixel, pixels_from_world(load_camera(), at).z);
    store_normal(pixel, octahedral_encode(n));
    store_unmapped_normal(pixel, octahedral_encode(smooth_n));
    store_material(pixel, pack_material(m));
    store_view(pixel, octahedral_encode(wo));
    store_throughput(pixel, vec4(throughput, 0.0f));
    store_albedo(pixel, vec4(lit ? albedo.diffuse : vec3(0.0f), 1.0f));
    store_specular_albedo(pixel, vec4(lit ? albedo.specular : vec3(0.0f), 1.0f));
    store_emission(pixel, vec4(seen.emission, 1.0f));
    store_motion(pixel, surface_motion(seen.image, s.position, s.ng, previous));
}

// What the surface shines by itself towards a viewer who comes straight from the camera.
vec3 shown_emission(IN(ShadingPoint) p) {
    if ((p.flags & MATERIAL_UNLIT) != 0u) { return p.bsdf.base_color; }
    return (p.flags & MATERIAL_EMISSIVE) != 0u ? p.emission : vec3(0.0f);
}

// The next mirror or pane: true if the view goes on with another ray.
bool view_goes_on(INOUT(PathState) path, INOUT(PixelView) seen, IN(Surface) s, IN(ShadingPoint) p) {
    LET_REF(RealtimeConstants) r = load_realtime();
    if (seen.mirrors >= r.mirror_limit || (p.flags & MATERIAL_UNLIT) != 0u ||
        !bsdf_is_specular(p.bsdf)) {
        return false;
    }
    vec3 wo = -path.ray.direction;
    vec3 wo_local = local_from_world(p.frame, wo);
    vec2 u_choices = draw_at(path.draws, path.depth, DRAW_CHOICES);
    BsdfSample b = bsdf_sample(p.bsdf, wo_local, u_choices.y,
                               draw_at(path.draws, path.depth, DRAW_BSDF));
    PathVertex at = path_vertex(s, wo, true);
    path_leave(path, s, p, at, wo_local, b, -1.0f);
    if (path.ended != 0u) { return false; }
    if ((b.lobe & LOBE_TRANSMISSION) == 0u) {
        seen.image = mirror_image_behind(seen.image, s.position, shown_normal(p));
    }
    seen.mirrors += 1u;
    return true;
}

// `ray` is the pixel's camera ray, `hit` what it met.
void realtime_primary(ivec2 pixel, Ray ray, Hit hit) {
    LET_REF(RealtimeConstants) r = load_realtime();
    LET_REF(FrameConstants) f = load_frame();
    Sampler draws = realtime_draws(pixel, r.frame_index);
    draws.dimension = CAMERA_DRAWS;
    PathState path = path_begin(ray, camera_ray_cone(load_camera(), float(r.size.y)), draws);
    path.hit = hit;
    PixelView seen;
    seen.image = mirror_image_identity();
    seen.emission = vec3(0.0f);
    seen.mirrors = 0u;
    while (path.hit.instance < HIT_LIGHT) {
        if (path.water != 0u) { seen.emission += path.throughput * path_water_light(path); }
        path.throughput *= medium_transmittance(path.attenuation, path.hit.t);
        path.cone = ray_cone_propagate(path.cone, path.hit.t);
        LET_REF(MaterialRecord) material =
            load_material(load_instance(path.hit.instance).material);
        bool diffuse = f.diffuse_shading != 0u;
        vec3 wo = -path.ray.direction;
        Surface s = load_surface(path.hit, path.ray.direction, path.cone,
                                 surface_needs(material, diffuse));
        float u_lod = draw_at(path.draws, path.depth, DRAW_OTHERS).x;
        ShadingPoint p = load_shading_point(material, s, wo, u_lod, diffuse);
        seen.emission += path.throughput * shown_emission(p);
        Hit here = path.hit;
        vec3 throughput = unorm8_rounded(path.throughput);
        if (!view_goes_on(path, seen, s, p)) {
            store_surface(pixel, seen, here, s, p, wo, throughput);
            return;
        }
        path.hit = trace_closest(path.ray);
    }
    if (path.water != 0u) { seen.emission += path.throughput * path_water_light(path); }
    float coverage = seen.mirrors > 0u ? 1.0f : 0.0f;
    if (path.hit.instance == HIT_NOTHING) {
        vec3 left = medium_transmittance(path.attenuation, FLOAT_MAX);
        seen.emission += path.throughput * left * sky_light(path.from, path.ray.direction,
                                                     path.cone.spread, seen.mirrors == 0u);
    } else {
        LET_REF(LightRecord) record = load_light(path.hit.primitive);
        seen.emission += path.throughput * medium_transmittance(path.attenuation, path.hit.t) *
                         light_radiance(record, path.from.position, path.ray.direction);
        coverage = 1.0f;
    }
    store_no_surface(pixel, seen, path.ray.direction, unorm8_rounded(path.throughput), coverage);
}

#endif
