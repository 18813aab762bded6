// The surface that a pixel shows, read back from the G-buffer.
// Resources: load_… of the G-buffer, load_previous_hit, load_previous_barycentrics,
// load_previous_depth, load_current_instance, and those of primary.glsl.
#ifndef GP_KERNELS_REALTIME_PIXEL_SURFACE_GLSL
#define GP_KERNELS_REALTIME_PIXEL_SURFACE_GLSL
#include "kernels/realtime/primary.glsl"
#include "shading/ocean/sea_rings.glsl"

struct PixelSurface {
    Surface s;
    ShadingPoint p;
    vec3 wo;
    vec3 wo_local;
    vec3 throughput;
    vec3 inv_albedo;           // 0 where there is no albedo
    vec3 inv_specular_albedo;
    uint water;                // PATH_ bits of the view
    Around around;             // on the view's side
    uint exists;               // 0: nothing of the rest is set
};

vec3 inverse_or_zero(vec3 v) {
    return vec3(v.x > 0.0f ? 1.0f / v.x : 0.0f, v.y > 0.0f ? 1.0f / v.y : 0.0f,
                v.z > 0.0f ? 1.0f / v.z : 0.0f);
}

Hit hit_of_pixel(uvec2 shown, uint barycentrics) {
    vec2 bary = unpack_barycentrics(barycentrics);
    Hit hit;
    hit.t = 0.0f;
    hit.u = bary.x;
    hit.v = bary.y;
    hit.instance = shown.x;
    hit.primitive = shown.y;
    return hit;
}

// The same for what a pixel of the last frame showed or kept, in the numbers of this frame;
// instance NO_INDEX: it is not there any more. What is known of the sea belongs to a place of the
// water, which lies on other triangles once the camera has moved.
Hit hit_of_past(uvec2 shown, uint barycentrics) {
    Hit hit = hit_of_pixel(shown, barycentrics);
    hit.instance = hit.instance < HIT_LIGHT ? load_current_instance(hit.instance) : NO_INDEX;
    LET_REF(SeaMotion) sea = load_realtime().sea;
    bool moved = sea.centre != sea.previous_centre || sea.height != sea.previous_height;
    if (hit.instance == NO_INDEX || hit.instance != sea.instance || !moved) { return hit; }
    SeaRings rings;
    rings.sectors = sea.sectors;
    rings.rings = sea.rings;
    rings.growth = sea_rings_growth(sea.sectors);
    rings.height = sea.previous_height;
    vec2 place = sea_place_of_triangle(rings, hit.primitive, hit.u, hit.v);
    rings.height = sea.height;
    SeaTriangle now = sea_triangle_at(rings, place + (sea.previous_centre - sea.centre));
    hit.primitive = now.number;
    hit.u = now.u;
    hit.v = now.v;
    hit.instance = now.exists != 0u ? hit.instance : NO_INDEX;
    return hit;
}

// Seen from wo, with the cone that arrives from there; u_lod as in load_shading_point.
PixelSurface surface_in_cone(IN(Hit) hit, vec3 wo, IN(RayCone) cone, float u_lod) {
    PixelSurface at;
    bool diffuse = load_frame().diffuse_shading != 0u;
    LET_REF(MaterialRecord) material = load_material(load_instance(hit.instance).material);
    at.s = load_surface(hit, -wo, cone, surface_needs(material, diffuse));
    at.p = load_shading_point(material, at.s, wo, u_lod, diffuse);
    at.wo = wo;
    at.wo_local = local_from_world(at.p.frame, wo);
    at.throughput = vec3(1.0f);
    at.inv_albedo = vec3(0.0f);
    at.inv_specular_albedo = vec3(0.0f);
    at.water = 0u;
    at.around = around_of(vec3(0.0f));
    at.exists = 1u;
    return at;
}

// As at camera_distance `depth` from the camera.
PixelSurface pixel_surface(IN(Hit) hit, vec3 wo, float depth, float u_lod) {
    RayCone cone = camera_ray_cone(load_camera(), float(load_realtime().size.y));
    return surface_in_cone(hit, wo, ray_cone_propagate(cone, depth), u_lod);
}

// What the diffuse lobe has of f |cos_i|, as bsdf_eval gave it, or of a sample's weight, where
// inv_pdf is one over its density.
vec3 diffuse_share(IN(PixelSurface) at, vec3 wi_local, vec3 f, float inv_pdf) {
    return bsdf_is_diffuse(at.p.bsdf)
               ? f : bsdf_diffuse_part(at.p.bsdf, at.wo_local, wi_local) * inv_pdf;
}

// The surface with what its view comes through. Straight from the camera that is what the camera is
// in. Behind mirrors and panes, of which calm water is one, it is by the level that a surface is
// below the sea or not.
PixelSurface in_its_medium(IN(PixelSurface) surface, uint mirrors) {
    LET_REF(FrameConstants) f = load_frame();
    PixelSurface at = surface;
    bool below = (f.water & WATER_CAMERA) != 0u;
    if (mirrors > 0u) {
        below = (at.p.flags & MATERIAL_SEA) != 0u ? at.s.front == 0u
                                                  : at.s.position.y < f.water_level;
    }
    if (!below) { return at; }
    at.water = PATH_IN_WATER;
    at.around = path_around(at.water, f.water_attenuation, at.p);
    return at;
}

PixelSurface load_pixel_surface(ivec2 pixel, IN(Sampler) primary_draws, uint mirrors) {
    Hit hit = hit_of_pixel(load_hit(pixel), load_barycentrics(pixel));
    PixelSurface at = pixel_surface(hit, octahedral_decode(load_view(pixel)), load_depth(pixel),
                                    draw_at(primary_draws, mirrors, DRAW_OTHERS).x);
    at = in_its_medium(at, mirrors);
    at.throughput = vec3(load_throughput(pixel));
    at.inv_albedo = inverse_or_zero(vec3(load_albedo(pixel)));
    at.inv_specular_albedo = inverse_or_zero(vec3(load_specular_albedo(pixel)));
    return at;
}

// The surface that a pixel of the last frame showed, where it is now, straight from the camera.
// `depth`, `u_lod` as in pixel_surface.
PixelSurface past_surface_at(ivec2 past, float depth, float u_lod) {
    LET_REF(CameraParams) camera = load_camera();
    Hit hit = hit_of_past(load_previous_hit(past), load_previous_barycentrics(past));
    PixelSurface at;
    at.exists = 0u;
    if (hit.instance == NO_INDEX) { return at; }
    vec3 position = surface_position(hit);
    vec3 wo = camera.kind == CAMERA_ORTHOGRAPHIC ? -camera.forward
                                                 : normalize(camera.position - position);
    return pixel_surface(hit, wo, depth, u_lod);
}

PixelSurface load_past_surface(ivec2 past) {
    return past_surface_at(past, load_previous_depth(past), 0.5f);
}

// The same for a pixel that repeats it: with its draws, and over its own albedo as that pixel
// kept it. What the G-buffer says of `pixel` stays its own, so that repeating changes no picture.
PixelSurface load_repeated_surface(ivec2 pixel, ivec2 past, IN(Sampler) past_draws) {
    PixelSurface at =
        past_surface_at(past, load_depth(pixel), draw_at(past_draws, 0u, DRAW_OTHERS).x);
    if (at.exists == 0u) { return at; }
    at = in_its_medium(at, 0u);
    PixelAlbedo albedo = pixel_albedo(at.p, at.wo, vec3(1.0f));
    at.inv_albedo = inverse_or_zero(unorm8_rounded(albedo.diffuse));
    at.inv_specular_albedo = inverse_or_zero(unorm8_rounded(albedo.specular));
    return at;
}

#endif
