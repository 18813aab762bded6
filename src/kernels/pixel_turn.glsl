// What changes within a pixel's footprint on a surface: the position, the interpolated normal, and
// with it the frame of the shading, along the two axes of the ellipse in which the pixel's cone
// meets the triangle; and how wide that makes highlights. Normal maps are not in it: what they
// have below a pixel is their own moments' business.
// Resources: load_instance, load_triangle.
#ifndef GP_KERNELS_PIXEL_TURN_GLSL
#define GP_KERNELS_PIXEL_TURN_GLSL
#include "kernels/surface.glsl"
#include "shading/bsdf/params.glsl"
#include "shading/slope/ndf_filtering.glsl"
#include "shading/slope/ndf_mixture.glsl"

// Along one axis of the footprint, a pixel's diameter long; world space.
struct PixelTurn {
    vec3 move;    // of the position
    vec2 corners; // change of the hit's barycentrics, Hit::u and Hit::v
    vec3 normal;  // change of the unit normal
    vec3 turn;    // of the frame: axis times angle, radians
};

struct PixelTurns {
    PixelTurn a;  // across the view
    PixelTurn b;  // away from the viewer, 1 / cos as long
};

// Beyond it the ellipse is cut: the triangle's plane says nothing so far away.
#define PIXEL_TURN_LEAST_COSINE 0.02f

// The change of the normalised sum of the corners' normals where the position moves in the plane of
// the edges; n: the sum, of any length.
PixelTurn pixel_turn_along(vec3 move, vec3 e1, vec3 e2, vec3 n, vec3 dn_du, vec3 dn_dv) {
    vec3 ng = cross(e1, e2);
    float inv_area2 = 1.0f / max(dot(ng, ng), 1.0e-38f);
    float du = dot(cross(move, e2), ng) * inv_area2;
    float dv = dot(cross(e1, move), ng) * inv_area2;
    float inv_length = inversesqrt(max(dot(n, n), 1.0e-38f));
    vec3 unit = n * inv_length;
    vec3 change = (dn_du * du + dn_dv * dv) * inv_length;
    PixelTurn t;
    t.move = move;
    t.corners = vec2(du, dv);
    t.normal = change - unit * dot(unit, change);
    t.turn = cross(unit, t.normal);
    return t;
}

// `cone` is the ray's cone at the hit; direction: of the ray.
// [Igehy 1999, section 3.1: where the ray's neighbours meet the plane, and the normal there]
PixelTurns pixel_turns(IN(Hit) hit, vec3 direction, IN(RayCone) cone) {
    LET_REF(InstanceRecord) instance = load_instance(hit.instance);
    TriangleCorners c = load_triangle(instance.geometry, hit.primitive);
    vec3 e1 = transform_vector(instance, c.p1 - c.p0);
    vec3 e2 = transform_vector(instance, c.p2 - c.p0);
    vec3 n0 = octahedral_decode(c.normal0);
    vec3 dn_du = octahedral_decode(c.normal1) - n0;
    vec3 dn_dv = octahedral_decode(c.normal2) - n0;
    vec3 n = transform_normal(instance, n0 + dn_du * hit.u + dn_dv * hit.v);
    dn_du = transform_normal(instance, dn_du);
    dn_dv = transform_normal(instance, dn_dv);
    vec3 ng = cross(e1, e2);
    ng = ng * inversesqrt(max(dot(ng, ng), 1.0e-38f));
    float cosine = dot(ng, direction);
    // Where the ray comes along the normal any two axes do.
    vec3 across = abs(cosine) > 0.99999f ? frame_from_normal(ng).t
                                         : normalize(cross(ng, direction));
    float width = abs(cone.width);
    float stretched = width / max(abs(cosine), PIXEL_TURN_LEAST_COSINE);
    PixelTurns t;
    t.a = pixel_turn_along(across * width, e1, e2, n, dn_du, dn_dv);
    t.b = pixel_turn_along(cross(ng, across) * stretched, e1, e2, n, dn_du, dn_dv);
    return t;
}

// The change of the direction to a point where one's own position moves; inv_distance 0: it is
// infinitely far away.
vec3 direction_change(vec3 w, vec3 move, float inv_distance) {
    return (w * dot(w, move) - move) * inv_distance;
}

// The change of the half vector in the frame of the shading, which turns with the surface.
vec3 half_vector_turn(IN(PixelTurn) t, IN(Frame) f, vec3 wo, vec3 wi, float inv_viewer,
                      float inv_light) {
    vec3 change = half_vector_change(wo, wi, direction_change(wo, t.move, inv_viewer),
                                     direction_change(wi, t.move, inv_light));
    vec3 h = normalize(wo + wi);
    return local_from_world(f, change - cross(t.turn, h));
}

// A local direction where the axes are turned about the normal; axis: of the new x.
vec3 turned_about_normal(vec3 w, vec2 axis) {
    return vec3(w.x * axis.x + w.y * axis.y, w.y * axis.x - w.x * axis.y, w.z);
}

// A model with its widths filtered, and the turn about the normal that its frame needs: (cos, sin)
// of the angle from the tangent to the axis of alpha_x. shape: times all that is not diffuse.
struct FilteredBsdf {
    BsdfParams bsdf;
    vec2 axis;
    float shape;
};

// Models whose highlight is alpha_x and alpha_y wide and that derive nothing from that beforehand.
bool ndf_filter_applies(uint model) {
    return model == MODEL_GLTF || model == MODEL_GGX_CONDUCTOR || model == MODEL_GGX_DIELECTRIC ||
           model == MODEL_BECKMANN_CONDUCTOR;
}

// Models whose highlight is one GGX lobe and nothing else but a diffuse part.
bool ndf_is_ggx_alone(IN(BsdfParams) m) {
    return m.model == MODEL_GGX_CONDUCTOR || m.model == MODEL_GGX_DIELECTRIC ||
           (m.model == MODEL_GLTF && m.coat <= 0.0f && m.sheen_color == vec3(0.0f));
}

// dh0, dh1: changes of the half vector h, local; method: NDF_FILTER_, not NONE. A coat, which has
// one width and a normal of its own, gets the isotropic filter.
FilteredBsdf ndf_filtered_bsdf(IN(BsdfParams) m, IN(PixelTurns) t, vec3 h, vec3 dh0, vec3 dh1,
                               uint method) {
    FilteredBsdf filtered;
    filtered.bsdf = m;
    filtered.axis = vec2(1.0f, 0.0f);
    filtered.shape = 1.0f;
    vec2 alpha2 = vec2(m.alpha_x * m.alpha_x, m.alpha_y * m.alpha_y);
    if (method == NDF_FILTER_TOKUYOSHI) {
        PrincipalWidths w = principal_widths(ndf_tokuyoshi(vec3(alpha2, 0.0f), dh0, dh1));
        if (ndf_is_ggx_alone(m)) { filtered.shape = ndf_mixture_shape(alpha2, h, dh0, dh1); }
        filtered.axis = w.axis;
        alpha2 = vec2(w.alpha_x * w.alpha_x, w.alpha_y * w.alpha_y);
    } else if (method == NDF_FILTER_KAPLANYAN) {
        alpha2 = ndf_kaplanyan(alpha2, h, dh0, dh1);
    } else {
        alpha2 = vec2(ndf_deferred(alpha2.x, t.a.normal, t.b.normal),
                      ndf_deferred(alpha2.y, t.a.normal, t.b.normal));
    }
    filtered.bsdf.alpha_x = max(sqrt(alpha2.x), BSDF_MIN_ALPHA);
    filtered.bsdf.alpha_y = max(sqrt(alpha2.y), BSDF_MIN_ALPHA);
    float coat2 = ndf_deferred(m.coat_alpha * m.coat_alpha, t.a.normal, t.b.normal);
    filtered.bsdf.coat_alpha = max(sqrt(coat2), BSDF_MIN_ALPHA);
    filtered.bsdf.coat_normal = turned_about_normal(m.coat_normal, filtered.axis);
    return filtered;
}

#endif
