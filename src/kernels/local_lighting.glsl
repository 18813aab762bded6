// The picture that a rasteriser gives: what the camera sees is lit by every lamp as by a point,
// without shadows and without bounces, by its own material or by one lighting model for all.
// Light is computed for each pixel [Phong 1975], for the corners of triangles with the pixels in
// between interpolated [Gouraud 1971], or once for each triangle.
// Resources: load_local_lighting, load_lighting_model (where that replaces the materials), and
// those of path.glsl and slope_lighting.glsl.
#ifndef GP_KERNELS_LOCAL_LIGHTING_GLSL
#define GP_KERNELS_LOCAL_LIGHTING_GLSL
#include "kernels/path.glsl"
#include "kernels/pixel_turn.glsl"
#include "kernels/slope_lighting.glsl"
#include "shading/bsdf/glint_sun.glsl"
#include "shading/bsdf/diffuse_part.glsl"
#include "shading/light/lamp_point.glsl"

// What a point of a surface sends to the viewer.
struct LocalLight {
    vec3 direct;
    vec3 ambient;
};

// How a point of a surface is seen.
struct LocalView {
    vec3 position;
    vec3 wo;
    PixelTurns turns;   // only where highlights are filtered, as the next
    float inv_viewer;   // 1 / metres to the viewer, 0: a parallel view
};

LightSample lamp_sample(IN(LightRecord) record, vec3 p, uint falloff) {
    if (record.kind == LIGHT_DIRECTIONAL) {
        DirectionalLight sun = directional_light(record);
        sun.one_minus_cos_max = 0.0f;
        return directional_light_sample(sun, vec2(0.0f));
    }
    SphereLight lamp = sphere_light(record);
    if (record.kind == LIGHT_RECTANGLE) {
        lamp = rectangle_light_as_point(rectangle_light(record), p);
    } else if (record.kind == LIGHT_TRIANGLE) {
        lamp = triangle_light_as_point(triangle_light(record), p);
    }
    return light_sample_with_falloff(
        sphere_light_sample(sphere_light_as_point(lamp), p, vec2(0.0f)), falloff);
}

// Whether light on this side of the surface makes a highlight that is filtered.
bool highlight_is_filtered(IN(ShadingPoint) p, vec3 wo_local, vec3 wi_local) {
    return load_local_lighting().ndf_filter != NDF_FILTER_NONE &&
           ndf_filter_applies(p.bsdf.model) && wo_local.z * wi_local.z > 0.0f;
}

// f cos of a lamp with the highlight as wide as the pixel sees it.
vec3 filtered_f_cos(IN(ShadingPoint) p, IN(LocalView) at, IN(LightSample) lamp, vec3 wo_local,
                    vec3 wi_local) {
    LET_REF(Frame) f = p.frame;
    float inv_light = lamp.distance < FLOAT_MAX ? 1.0f / max(lamp.distance, 1.0e-6f) : 0.0f;
    vec3 dh0 = half_vector_turn(at.turns.a, f, at.wo, lamp.wi, at.inv_viewer, inv_light);
    vec3 dh1 = half_vector_turn(at.turns.b, f, at.wo, lamp.wi, at.inv_viewer, inv_light);
    vec3 h = normalize(wo_local + wi_local);
    FilteredBsdf filtered = ndf_filtered_bsdf(p.bsdf, at.turns, h, dh0, dh1,
                                              load_local_lighting().ndf_filter);
    vec3 wo = turned_about_normal(wo_local, filtered.axis);
    vec3 wi = turned_about_normal(wi_local, filtered.axis);
    vec3 f_cos = bsdf_eval(filtered.bsdf, wo, wi).f_cos;
    if (filtered.shape == 1.0f) { return f_cos; }
    vec3 diffuse = bsdf_diffuse_part(filtered.bsdf, wo, wi);
    return diffuse + (f_cos - diffuse) * filtered.shape;
}

// f cos of a lamp. A sun is a direction, but surfaces of slopes reflect all of its disc.
vec3 lamp_f_cos(IN(BsdfParams) m, IN(LightRecord) record, vec3 wo_local, vec3 wi_local) {
    return record.kind == LIGHT_DIRECTIONAL
               ? sun_f_cos(m, wo_local, wi_local, directional_light(record))
               : bsdf_eval(m, wo_local, wi_local).f_cos;
}

vec3 lamp_light(IN(ShadingPoint) p, IN(LocalView) at, uint lamp_index) {
    LET_REF(LightRecord) record = load_light(lamp_index);
    LightSample lamp = lamp_sample(record, at.position, load_local_lighting().falloff);
    if (!(lamp.pdf > 0.0f)) { return vec3(0.0f); }
    vec3 wo_local = local_from_world(p.frame, at.wo);
    vec3 wi_local = local_from_world(p.frame, lamp.wi);
    vec3 f_cos = highlight_is_filtered(p, wo_local, wi_local)
                     ? filtered_f_cos(p, at, lamp, wo_local, wi_local)
                     : lamp_f_cos(p.bsdf, record, wo_local, wi_local);
    return f_cos * lamp.radiance;
}

vec3 ambient_light(IN(ShadingPoint) p, IN(LocalView) at) {
    LET_REF(LocalLightingConstants) local = load_local_lighting();
    if (local.ambient == vec3(0.0f) && local.sky_nodes == 0u) { return vec3(0.0f); }
    vec3 albedo = bsdf_albedo(p.bsdf, abs(dot(shown_normal(p), at.wo)));
    vec3 light = albedo * local.ambient;
    if (local.sky_nodes != 0u) {
        light += lit_by_sky(p, local_from_world(p.frame, at.wo), albedo);
    }
    return light;
}

LocalLight light_of(IN(ShadingPoint) p, IN(LocalView) at) {
    LocalLight sum;
    sum.direct = vec3(0.0f);
    for (uint i = 0u; i < load_local_lighting().lamps; ++i) { sum.direct += lamp_light(p, at, i); }
    sum.ambient = ambient_light(p, at);
    return sum;
}

// Whether materials are shown as what they are not (local_material).
bool local_materials_differ() {
    LET_REF(LocalLightingConstants) local = load_local_lighting();
    return local.frequency != FREQUENCY_PIXEL || local.replaces_materials != 0u;
}

// A material as this mode shows it. Bumps of a map are between the corners of triangles, and
// whatever model replaces a solid body's is lit on the side that the viewer sees, along tangents
// that no roughness of the material turns.
MaterialRecord local_material(MaterialRecord shown) {
    LET_REF(LocalLightingConstants) local = load_local_lighting();
    if (local.frequency != FREQUENCY_PIXEL) {
        shown.textures &= ~(SLOT_NORMAL | SLOT_COAT_NORMAL | SLOT_SLOPES);
    }
    if (local.replaces_materials != 0u) {
        shown.flags &= ~(MATERIAL_SOLID | MATERIAL_TRANSMISSIVE | MATERIAL_SEA);
        shown.flags |= MATERIAL_ONLY_BENT;
    }
    return shown;
}

// Where pixels do not count, textures are read at their finest level, which is the same for all
// pixels.
Surface local_surface(IN(PathState) path, IN(MaterialRecord) m, IN(Hit) hit) {
    LET_REF(LocalLightingConstants) local = load_local_lighting();
    bool replaced = local.replaces_materials != 0u;
    // The model that replaces a material may have a direction.
    uint needs = surface_needs(m, load_frame().diffuse_shading != 0u) |
                 (replaced ? SURFACE_UV | SURFACE_TANGENT : 0u);
    Surface s = load_surface(hit, path.ray.direction, path.cone, needs);
    if (local.frequency != FREQUENCY_PIXEL) { s.lod = FINEST_LEVEL; }
    if (local.frequency == FREQUENCY_TRIANGLE) {
        s.frame = frame_from_normal_tangent(s.ng, s.frame.t, frame_handedness(s.frame));
    }
    return s;
}

LocalView local_view(IN(PathState) path, IN(Hit) hit, vec3 position) {
    LET_REF(LocalLightingConstants) local = load_local_lighting();
    LocalView at;
    at.position = position;
    at.wo = local.parallel_view != 0u ? -path.ray.direction
                                      : normalize(path.ray.origin - position);
    if (local.ndf_filter != NDF_FILTER_NONE) {
        at.turns = pixel_turns(hit, path.ray.direction, path.cone);
        at.inv_viewer = local.parallel_view != 0u ? 0.0f : 1.0f / max(path.hit.t, 1.0e-6f);
    }
    return at;
}

// The model in a material's place. What the material says of its colour, textures included, tints
// the model's; what bsdf_prepared derives does not depend on colours.
BsdfParams lighting_model(vec3 base_color) {
    BsdfParams model = load_lighting_model();
    model.base_color *= base_color;
    return model;
}

// At the barycentrics u and v of the triangle that path.hit names.
LocalLight local_light_at(IN(PathState) path, IN(MaterialRecord) m, float u, float v) {
    Hit hit = path.hit;
    hit.u = u;
    hit.v = v;
    Surface s = local_surface(path, m, hit);
    LocalView at = local_view(path, hit, s.position);
    bool diffuse = load_frame().diffuse_shading != 0u;
    ShadingPoint p = load_shading_point(m, s, at.wo, 0.0f, diffuse);
    if (load_local_lighting().replaces_materials != 0u) {
        p.bsdf = lighting_model(p.bsdf.base_color);
    }
    return light_of(p, at);
}

// The light of the triangle's corners, in proportion to how near they are.
LocalLight interpolated_light(IN(PathState) path, IN(MaterialRecord) m) {
    LocalLight a = local_light_at(path, m, 0.0f, 0.0f);
    LocalLight b = local_light_at(path, m, 1.0f, 0.0f);
    LocalLight c = local_light_at(path, m, 0.0f, 1.0f);
    LocalLight light;
    light.direct = interpolate(a.direct, b.direct, c.direct, path.hit.u, path.hit.v);
    light.ambient = interpolate(a.ambient, b.ambient, c.ambient, path.hit.u, path.hit.v);
    return light;
}

// The picture's steps, each of them for many pixels at a time where a backend can: while one
// waits for memory the next has begun. First what the camera sees, if it is a surface ...
bool path_sees_surface(INOUT(PathState) path) {
    if (path.hit.instance == HIT_NOTHING) {
        path_end(path, sky_light(path.from, path.ray.direction, path.cone.spread, true));
        return false;
    }
    if (path.hit.instance == HIT_LIGHT) {
        path_end_at_light(path);
        return false;
    }
    path.cone = ray_cone_propagate(path.cone, path.hit.t);
    return true;
}

// By `material`, as local_material has it.
ShadingPoint path_local_point(IN(PathState) path, IN(MaterialRecord) material, IN(Surface) s,
                              IN(LocalView) at) {
    float u_lod = material.textures != 0u ? draw_at(path.draws, 0u, DRAW_OTHERS).x : 0.0f;
    return load_shading_point(material, s, at.wo, u_lod, load_frame().diffuse_shading != 0u);
}

// ... then what is seen of it whatever light there is. Whether there is light to be added; the
// albedo then still has to be: it is guide_albedo.
bool path_begin_light(INOUT(PathState) path, INOUT(ShadingPoint) seen, IN(LocalView) at) {
    path.guides = guides_but_albedo(seen, path.hit);
    path_end(path, own_light(path, seen));
    if ((seen.flags & MATERIAL_UNLIT) != 0u) {
        path.guides.albedo = guide_albedo(seen, at.wo);
        return false;
    }
    if (load_local_lighting().replaces_materials != 0u) {
        seen.bsdf = lighting_model(seen.bsdf.base_color);
    }
    return true;
}

// ... then all of the light that comes from there: what lamps send as direct light, what comes from
// all sides as indirect light. Of pixels by themselves these are the sum of lamp_light over lamps,
// and ambient_light; else it is this.
void path_light_locally(INOUT(PathState) path) {
    MaterialRecord m = local_material(load_material(load_instance(path.hit.instance).material));
    LocalLight light = load_local_lighting().frequency == FREQUENCY_VERTEX
                           ? interpolated_light(path, m)
                           : local_light_at(path, m, 1.0f / 3.0f, 1.0f / 3.0f);
    path.light.direct = light.direct;
    path.light.indirect = light.ambient;
}

#endif
