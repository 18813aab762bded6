// The slope maps of a material at one point. Normal, height and displacement maps, one over the
// other, are one distribution of slopes within the pixel's footprint (shading/slope/lean.glsl): its
// mean bends the surface, its covariance is roughness. Where the mean comes from is a derivative of
// the map's own texels, not a difference between pixels, and so is the same from any distance.
// Resources: load_material_slopes, and those of pixel_turn.glsl, shading_point.glsl and
// slope_map.glsl.
#ifndef GP_KERNELS_MATERIAL_SLOPES_GLSL
#define GP_KERNELS_MATERIAL_SLOPES_GLSL
#include "kernels/pixel_turn.glsl"
#include "kernels/shading_point.glsl"
#include "kernels/slope_map.glsl"

bool has_slope_maps(IN(MaterialRecord) m) {
    return (m.textures & SLOT_SLOPES) != 0u;
}

// The change of texture coordinates (0 or 1) where the hit moves by these barycentrics.
vec2 coordinate_change(IN(Surface) s, uint tex_coord, vec2 corners) {
    uint geometry = load_instance(s.hit.instance).geometry;
    if (tex_coord == 0u) {
        TriangleCorners c = load_triangle(geometry, s.hit.primitive);
        return (c.uv1 - c.uv0) * corners.x + (c.uv2 - c.uv0) * corners.y;
    }
    vec2 first = load_uv1(geometry, s.hit.primitive, 0.0f, 0.0f);
    return (load_uv1(geometry, s.hit.primitive, 1.0f, 0.0f) - first) * corners.x
         + (load_uv1(geometry, s.hit.primitive, 0.0f, 1.0f) - first) * corners.y;
}

// Slopes whose coordinates are dot(to_x, slope) and dot(to_y, slope) of these.
Slopes slopes_transformed(IN(Slopes) a, vec2 to_x, vec2 to_y) {
    Slopes s;
    s.mean = vec2(dot(to_x, a.mean), dot(to_y, a.mean));
    vec2 x = vec2(a.var_x * to_x.x + a.cov * to_x.y, a.cov * to_x.x + a.var_y * to_x.y);
    vec2 y = vec2(a.var_x * to_y.x + a.cov * to_y.y, a.cov * to_y.x + a.var_y * to_y.y);
    s.var_x = max(dot(x, to_x), 0.0f);
    s.var_y = max(dot(y, to_y), 0.0f);
    s.cov = dot(x, to_y);
    return s;
}

// A map's cliffs have any slope, and a triangle with no area in the texture's coordinates makes all
// slopes infinite: all are made smaller together until they are SLOPE_LIMIT on average.
Slopes slopes_bounded(IN(Slopes) a) {
    float size = sqrt(dot(a.mean, a.mean) + a.var_x + a.var_y);
    if (!(size <= 1.0e15f)) { return slopes_constant(vec2(0.0f)); }
    return size > SLOPE_LIMIT ? slopes_scaled(a, vec2(SLOPE_LIMIT / size)) : a;
}

// What heights over the texture's coordinates are over the surface: the triangle says how far the
// coordinates go, in any direction, stretched or mirrored. rise: of the slope 1, over the whole
// picture, in lengths of the mesh, which an instance scales along the normal as well.
// [Blinn 1978, "Simulation of Wrinkled Surfaces", section 2]
Slopes slopes_on_surface(IN(Slopes) a, IN(TextureSlot) slot, vec2 rise, IN(Surface) s) {
    LET_REF(InstanceRecord) instance = load_instance(s.hit.instance);
    TriangleCorners c = load_triangle(instance.geometry, s.hit.primitive);
    vec3 e1 = transform_vector(instance, c.p1 - c.p0);
    vec3 e2 = transform_vector(instance, c.p2 - c.p0);
    vec2 d1 = slot_change(slot, coordinate_change(s, slot.tex_coord, vec2(1.0f, 0.0f)));
    vec2 d2 = slot_change(slot, coordinate_change(s, slot.tex_coord, vec2(0.0f, 1.0f)));
    vec2 x1 = vec2(dot(e1, s.frame.t), dot(e1, s.frame.b));
    vec2 x2 = vec2(dot(e2, s.frame.t), dot(e2, s.frame.b));
    // The gradient g over the plane with dot(g, x1) and dot(g, x2) what the height changes by.
    float det = x1.x * x2.y - x1.y * x2.x;
    if (det == 0.0f) { return slopes_constant(vec2(0.0f)); }
    vec3 n = s.frame.n;
    vec3 up = vec3(instance.world_from_object[0]) * n.x + vec3(instance.world_from_object[1]) * n.y
            + vec3(instance.world_from_object[2]) * n.z;
    // v grows downwards, slopes upwards.
    float per_u = rise.x * length(up) / det;
    float per_v = -rise.y * length(up) / det;
    vec2 to_x = vec2((x2.y * d1.x - x1.y * d2.x) * per_u, (x2.y * d1.y - x1.y * d2.y) * per_v);
    vec2 to_y = vec2((x1.x * d2.x - x2.x * d1.x) * per_u, (x1.x * d2.y - x2.x * d1.y) * per_v);
    return slopes_transformed(a, to_x, to_y);
}

// All of the material's maps within the footprint, in the surface's own frame; there is one.
Slopes material_slopes(IN(MaterialRecord) m, IN(Surface) s, IN(PixelTurns) t) {
    Slopes all = slopes_constant(vec2(0.0f));
    for (uint i = m.first_slopes;; ++i) {
        LET_REF(MaterialSlopes) map = load_material_slopes(i);
        vec2 d0 = coordinate_change(s, map.slot.tex_coord, t.a.corners);
        vec2 d1 = coordinate_change(s, map.slot.tex_coord, t.b.corners);
        Slopes d = read_slope_map(map.slope_map, slot_position(map.slot, s),
                                  slot_change(map.slot, d0), slot_change(map.slot, d1));
        bool by_triangle = map.rise.x != 0.0f || map.rise.y != 0.0f;
        d = by_triangle ? slopes_on_surface(d, map.slot, map.rise, s)
                        : slopes_transformed(d, map.to_x, map.to_y);
        all = slopes_added(all, slopes_bounded(d));
        if (map.is_last != 0u) { return all; }
    }
    return all;
}

// The frame of a surface that slope maps bend, and the widths of a highlight on it.
struct SlopedShape {
    Frame frame;
    float alpha_x;
    float alpha_y;
};

// For models that stand in the frame of the bent surface. `frame` is what the normal map and the
// anisotropy make of the surface's own; what is rough below the pixel goes into the widths of
// models that have two (alpha^2 is twice a variance), whose frame turns to its principal axes.
// [Olano and Baker 2010, section 4.4: the covariance of a map and of Beckmann facets add up]
OUT_OF_LINE SlopedShape sloped_shape(IN(MaterialRecord) m, IN(Surface) s, vec3 wo, IN(Frame) frame,
                                     float alpha_x, float alpha_y) {
    Slopes d = material_slopes(m, s, pixel_turns(s.hit, -wo, s.cone));
    vec3 n = facet_of(slope_of(local_from_world(s.frame, frame.n)) + d.mean);
    SlopedShape shape;
    shape.frame = frame_from_normal_tangent(world_from_local(s.frame, n), frame.t,
                                            frame_handedness(frame));
    shape.alpha_x = alpha_x;
    shape.alpha_y = alpha_y;
    if (!ndf_filter_applies(m.model) || (m.flags & MATERIAL_ONLY_BENT) != 0u) { return shape; }
    // Slopes about the mean as the frame that is tilted to it sees them: the first order of
    // -(dot(v, t), dot(v, b)) / dot(v, n) for v = (-slope, 1).
    vec3 t = local_from_world(s.frame, shape.frame.t);
    vec3 b = local_from_world(s.frame, shape.frame.b);
    Slopes about = slopes_transformed(d, vec2(t.x, t.y) * n.z, vec2(b.x, b.y) * n.z);
    PrincipalWidths w = principal_widths(vec3(alpha_x * alpha_x + 2.0f * about.var_x,
                                              alpha_y * alpha_y + 2.0f * about.var_y,
                                              2.0f * about.cov));
    shape.frame = turned_frame(shape.frame, w.axis);
    shape.alpha_x = clamp(w.alpha_x, BSDF_MIN_ALPHA, 1.0f);
    shape.alpha_y = clamp(w.alpha_y, BSDF_MIN_ALPHA, 1.0f);
    return shape;
}

#endif
