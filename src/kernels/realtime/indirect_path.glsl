// The ways of light that pixels hand on: from a light over a point of some surface, where a bounce
// ray once arrived, to the surface that a pixel shows.
// Based on: Ouyang, Liu, Kettunen, Pharr, Pantaleoni 2021, "ReSTIR GI: Path Resampling for
// Real-Time Path Tracing". Otherwise than there: what is kept of the point is where it is and
// which point of which light its shadow ray went to, not its radiance. All of it is weighed anew
// for each pixel and frame, so that no surface need be Lambertian, and lamps that move or go out
// and things that move take their light with them.
// Resources: those of light_reuse.glsl.
#ifndef GP_KERNELS_REALTIME_INDIRECT_PATH_GLSL
#define GP_KERNELS_REALTIME_INDIRECT_PATH_GLSL
#include "kernels/realtime/light_reuse.glsl"

// Where a bounce ray arrived, and the light its shadow ray went to; `light` has the weight, over
// area there: points have the same density for every pixel, and the Jacobian that Ouyang et al.
// weigh by is the ratio of two `geometry` below.
struct IndirectReservoir {
    Reservoir light;
    uvec2 hit;           // instance and triangle
    uint barycentrics;
};

IndirectReservoir indirect_reservoir_empty() {
    IndirectReservoir r;
    r.light = reservoir_empty();
    r.hit = uvec2(NO_INDEX, 0u);
    r.barycentrics = 0u;
    return r;
}

// From a pixel's surface to a point of another one.
struct IndirectSegment {
    vec3 wi;
    vec3 wi_local;
    float distance;
    uint exists;      // 0: too far for a bounce ray, or the surface does not reflect what comes
};

IndirectSegment indirect_segment(IN(PixelSurface) at, vec3 there) {
    IndirectSegment way;
    vec3 to = there - at.s.position;
    way.distance = length(to);
    way.wi = to / max(way.distance, 1.0e-30f);
    way.wi_local = local_from_world(at.p.frame, way.wi);
    // Not through the surface: what lies behind it may absorb.
    bool reflected = same_side(at.p.bsdf, at.wo_local, way.wi_local);
    bool reached = way.distance > 0.0f && way.distance < load_frame().ray_length;
    way.exists = reached && reflected &&
                 sides_agree(at.s, at.p, at.wo, way.wi, at.wo_local, way.wi_local) ? 1u : 0u;
    return way;
}

// Lobes narrower than this are missed by all other pixels' finds.
bool takes_part(IN(PixelSurface) at) {
    return pixel_roughness(at.p.bsdf) >= load_realtime().indirect_reuse_roughness;
}

// What of f |cos_i| takes part in reuse: all of a rough surface, of others the diffuse lobe. It is
// the same rule at both ends; what it leaves out stays with the pixel's own bounce ray.
vec3 reused_share(IN(PixelSurface) at, vec3 f_cos, vec3 diffuse) {
    return takes_part(at) ? f_cos : diffuse;
}

// The whole way. `target` is what it brings to the pixel, as luminance, over the densities of its
// points, were nothing in between.
struct IndirectPath {
    IndirectSegment way;
    vec3 diffuse;     // f |cos_i| of the pixel's surface: of its diffuse lobe
    vec3 f;           // as far as it takes part
    vec3 light;       // radiance that leaves the other surface, as far as it takes part
    vec3 all_light;   // and all of it
    float geometry;   // solid angle seen from here over area there
    vec3 normal;      // there
    Ray beyond;       // from there to the light
    float target;
};

IndirectPath indirect_path_none() {
    IndirectPath path;
    path.diffuse = vec3(0.0f);
    path.f = vec3(0.0f);
    path.light = vec3(0.0f);
    path.all_light = vec3(0.0f);
    path.geometry = 0.0f;
    path.target = 0.0f;
    return path;
}

// The level of detail is chosen with what is left of a number that chose the point of a light:
// kept with the sample, and as good as a new one.
PixelSurface bounce_surface(IN(Hit) hit, IN(IndirectSegment) way, vec2 light_u) {
    RayCone cone;
    cone.width = 0.0f;
    cone.spread = camera_pixel_spread(load_camera(), float(load_realtime().size.y));
    cone = ray_cone_propagate(ray_cone_bounce(cone, 1.0f), way.distance);
    float scaled = light_u.y * 4096.0f;
    return surface_in_cone(hit, -way.wi, cone, scaled - floor(scaled));
}

// Cosine over squared distance.
float bounce_geometry(vec3 normal, vec3 wi, float distance) {
    return abs(dot(normal, wi)) / (distance * distance);
}

IndirectPath indirect_path_over(IN(PixelSurface) at, IN(IndirectSegment) way,
                                IN(PixelSurface) there, uint light, vec2 u) {
    IndirectPath path = indirect_path_none();
    path.way = way;
    path.normal = there.s.ng;
    path.geometry = bounce_geometry(there.s.ng, way.wi, way.distance);
    // Behind the last surface there is no ray that could find the light too.
    bool weigh = load_frame().max_bounces > 1u;
    UnshadowedLight beyond = unshadowed_light(there, light, u, weigh);
    if ((there.p.flags & MATERIAL_UNLIT) != 0u || beyond.light == vec3(0.0f)) { return path; }
    path.beyond = shadow_ray(there.s, there.p, there.wo, beyond.point);
    path.all_light = beyond.f_cos * beyond.light;
    path.light = reused_share(there, beyond.f_cos,
                              diffuse_share(there, beyond.wi_local, beyond.f_cos, 1.0f)) *
                 beyond.light;
    BsdfValue value = bsdf_eval(at.p.bsdf, at.wo_local, way.wi_local);
    path.diffuse = diffuse_share(at, way.wi_local, value.f_cos, 1.0f);
    path.f = reused_share(at, value.f_cos, path.diffuse);
    path.target = luminance(path.f * path.light) * path.geometry;
    return path;
}

IndirectPath indirect_path(IN(PixelSurface) at, IN(IndirectReservoir) r) {
    Hit hit = hit_of_pixel(r.hit, r.barycentrics);
    IndirectSegment way = indirect_segment(at, surface_position(hit));
    if (way.exists == 0u) { return indirect_path_none(); }
    return indirect_path_over(at, way, bounce_surface(hit, way, r.light.u), r.light.light,
                              r.light.u);
}

// Whether nothing is between a surface and the other end of the segment.
float bounce_visible(IN(PixelSurface) at, IN(IndirectSegment) way) {
    LightSample end = light_sample_none();
    end.wi = way.wi;
    end.distance = way.distance;
    return trace_visible(shadow_ray(at.s, at.p, at.wo, end));
}

#endif
