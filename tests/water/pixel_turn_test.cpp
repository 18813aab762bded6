// How a surface turns within a pixel (kernels/pixel_turn.glsl), against differences along the
// triangle, and what it makes of a material's widths.
#include <gtest/gtest.h>

#include "shared/scene_structs.h"
#include "statistics/random.h"
#include "water/slope_quadrature.h"

GP_SHADING_BEGIN
#include "shading/bsdf/params.glsl"
#include "shading/frame.glsl"
#include "shading/ray_cone.glsl"
#include "shading/slope/ndf_filtering.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;
using namespace gp::shared;

// The kernel with a world of one triangle.
struct OneTriangle {
    InstanceRecord object{};
    TriangleCorners triangle{};

    const InstanceRecord& load_instance(uint) { return object; }
    const TriangleCorners& load_triangle(uint, uint) { return triangle; }
    vec2 load_uv1(uint, uint, float, float) { return vec2(0.0f); }
    vec4 load_vertex_color(uint, uint, float, float) { return vec4(1.0f); }

#include "kernels/pixel_turn.glsl"
};

// A triangle of a sphere of the radius 2 about the origin, in an object that is moved or stretched.
OneTriangle patch(bool stretched) {
    OneTriangle world;
    const double s = stretched ? 3.0 : 1.0;
    world.object.world_from_object[0] = vec4(dvec4(s, 0, 0, 0.5));
    world.object.world_from_object[1] = vec4(0, 1, 0, -1);
    world.object.world_from_object[2] = vec4(0, 0, 1, 2);
    world.object.normal_from_object[0] = vec4(1, 0, 0, 0);
    world.object.normal_from_object[1] = vec4(dvec4(0, s, 0, 0));
    world.object.normal_from_object[2] = vec4(dvec4(0, 0, s, 0));
    const vec3 n[3] = {normalize(vec3(0.1f, 0.2f, 1)), normalize(vec3(0.2f, 0.2f, 1)),
                       normalize(vec3(0.13f, 0.31f, 1))};
    world.triangle.p0 = n[0] * 2.0f, world.triangle.normal0 = octahedral_encode(n[0]);
    world.triangle.p1 = n[1] * 2.0f, world.triangle.normal1 = octahedral_encode(n[1]);
    world.triangle.p2 = n[2] * 2.0f, world.triangle.normal2 = octahedral_encode(n[2]);
    return world;
}

// The unit normal at a place of the triangle's plane, from barycentrics found in double.
dvec3 normalAt(OneTriangle& w, dvec3 place) {
    const auto point = [&](vec3 p) { return dvec3(w.transform_point(w.object, p)); };
    const dvec3 p0 = point(w.triangle.p0);
    const dvec3 e1 = point(w.triangle.p1) - p0, e2 = point(w.triangle.p2) - p0, d = place - p0;
    const dvec3 ng = cross(e1, e2);
    const double u = dot(cross(d, e2), ng) / dot(ng, ng), v = dot(cross(e1, d), ng) / dot(ng, ng);
    const dvec3 n = dvec3(octahedral_decode(w.triangle.normal0)) * (1 - u - v)
        + dvec3(octahedral_decode(w.triangle.normal1)) * u
        + dvec3(octahedral_decode(w.triangle.normal2)) * v;
    const vec4* m = w.object.normal_from_object;
    return normalize(dvec3(dot(dvec3(vec3(m[0])), n), dot(dvec3(vec3(m[1])), n),
                           dot(dvec3(vec3(m[2])), n)));
}

struct Seen {
    dvec3 place, ng, direction;
    double distance;
    OneTriangle::PixelTurns turns;
};

constexpr float pixelWidth = 0.01f;

Seen look(OneTriangle& w, dvec3 eye) {
    Hit hit{};
    hit.u = 0.3f, hit.v = 0.35f;
    const auto point = [&](vec3 p) { return dvec3(w.transform_point(w.object, p)); };
    const dvec3 p0 = point(w.triangle.p0), p1 = point(w.triangle.p1), p2 = point(w.triangle.p2);
    Seen seen;
    seen.place = p0 + (p1 - p0) * double(hit.u) + (p2 - p0) * double(hit.v);
    seen.ng = normalize(cross(p1 - p0, p2 - p0));
    seen.distance = length(seen.place - eye);
    seen.direction = (seen.place - eye) / seen.distance;
    RayCone cone{};
    cone.width = pixelWidth;
    seen.turns = w.pixel_turns(hit, vec3(seen.direction), cone);
    return seen;
}

const dvec3 eyes[] = {{0, 0, 9}, {3, 1, 6}, {-5, 4, 5.2}, {0.9, -0.7, 40}};

TEST(PixelTurn, FootprintIsTheConesEllipse) {
    for (const bool stretched : {false, true}) {
        OneTriangle w = patch(stretched);
        for (const dvec3 eye : eyes) {
            const Seen s = look(w, eye);
            const dvec3 a(s.turns.a.move), b(s.turns.b.move);
            EXPECT_NEAR(length(a), double(pixelWidth), 1e-6);
            EXPECT_NEAR(length(b) * std::abs(dot(s.ng, s.direction)), double(pixelWidth), 1e-6);
            EXPECT_NEAR(dot(a, s.direction), 0.0, 1e-7);
            EXPECT_NEAR(dot(a, s.ng), 0.0, 1e-7);
            EXPECT_NEAR(dot(b, s.ng), 0.0, 1e-7);
            EXPECT_NEAR(dot(a, b), 0.0, 1e-8);
        }
    }
}

TEST(PixelTurn, NormalsTurnAsInterpolationTurnsThem) {
    for (const bool stretched : {false, true}) {
        OneTriangle w = patch(stretched);
        for (const dvec3 eye : eyes) {
            const Seen s = look(w, eye);
            for (const OneTriangle::PixelTurn& t : {s.turns.a, s.turns.b}) {
                const dvec3 move(t.move);
                const dvec3 change =
                    (normalAt(w, s.place + move * 0.5) - normalAt(w, s.place - move * 0.5));
                EXPECT_LT(length(dvec3(t.normal) - change), 2e-4 * length(change));
                const dvec3 n = normalAt(w, s.place);
                EXPECT_LT(length(cross(dvec3(t.turn), n) - change), 1e-3 * length(change));
            }
            // On the sphere itself a step of w turns by w / R, but for the triangle being flat.
            if (!stretched) {
                EXPECT_NEAR(length(dvec3(s.turns.a.normal)), double(pixelWidth) / 2.0, 1e-4);
            }
        }
    }
}

// Rodrigues' turn of a vector by an axis times its angle.
dvec3 turned(dvec3 v, dvec3 turn) {
    const double angle = length(turn);
    if (angle < 1e-12) return v;
    const dvec3 k = turn / angle;
    return v * std::cos(angle) + cross(k, v) * std::sin(angle)
         + k * (dot(k, v) * (1.0 - std::cos(angle)));
}

TEST(PixelTurn, HalfVectorsTurnAsDifferencesSay) {
    OneTriangle w = patch(true);
    for (const dvec3 eye : eyes) {
        for (const double lamp : {0.0, 1.0}) {  // far away, or near
            const Seen s = look(w, eye);
            const dvec3 light(2, 3, 7), sun = normalize(dvec3(1, 2, 3));
            const Frame f = frame_from_normal(vec3(normalAt(w, s.place)));
            const auto half = [&](dvec3 place) {
                const dvec3 wi = lamp > 0.0 ? normalize(light - place) : sun;
                return normalize(normalize(eye - place) + wi);
            };
            const dvec3 wi = lamp > 0.0 ? normalize(light - s.place) : sun;
            const float inv_light = lamp > 0.0 ? float(1.0 / length(light - s.place)) : 0.0f;
            for (const OneTriangle::PixelTurn& t : {s.turns.a, s.turns.b}) {
                const auto local = [&](double e) {
                    const dvec3 h = half(s.place + dvec3(t.move) * e), turn = dvec3(t.turn) * e;
                    return dvec3(dot(h, turned(dvec3(f.t), turn)), dot(h, turned(dvec3(f.b), turn)),
                                 dot(h, turned(dvec3(f.n), turn)));
                };
                const dvec3 difference = local(0.5) - local(-0.5);
                const vec3 change = w.half_vector_turn(t, f, vec3(-s.direction), vec3(wi),
                                                       float(1.0 / s.distance), inv_light);
                EXPECT_LT(length(dvec3(change) - difference), 2e-3 * length(difference) + 1e-7);
            }
        }
    }
}

TEST(PixelTurn, WidensOnlyWhatTurns) {
    OneTriangle w = patch(false);
    const Seen s = look(w, eyes[1]);
    BsdfParams m = bsdf_fields_of(MODEL_GLTF);
    m.alpha_x = 0.003f, m.alpha_y = 0.004f, m.coat_alpha = 0.002f;
    m.coat_normal = normalize(vec3(0.2f, 0.1f, 1.0f));
    const vec3 h(0, 0, 1), dh0(0.02f, 0.01f, 0), dh1(-0.01f, 0.005f, 0);
    for (const uint method : {NDF_FILTER_KAPLANYAN, NDF_FILTER_TOKUYOSHI, NDF_FILTER_DEFERRED}) {
        const auto wide = w.ndf_filtered_bsdf(m, s.turns, h, dh0, dh1, method);
        EXPECT_GT(wide.bsdf.alpha_x, m.alpha_x);
        EXPECT_GT(wide.bsdf.alpha_y, m.alpha_y);
        EXPECT_GT(wide.bsdf.coat_alpha, m.coat_alpha);
        // The coat's normal stays where it is when the frame is turned.
        EXPECT_NEAR(dot(w.turned_about_normal(m.coat_normal, wide.axis), wide.bsdf.coat_normal),
                    1.0f, 1e-6f);
        const OneTriangle::PixelTurns still{};
        const auto same = w.ndf_filtered_bsdf(m, still, h, vec3(0.0f), vec3(0.0f), method);
        const float least = std::min(same.bsdf.alpha_x, same.bsdf.alpha_y);
        EXPECT_NEAR(least, 0.003f, 1e-6f);
        EXPECT_NEAR(std::max(same.bsdf.alpha_x, same.bsdf.alpha_y), 0.004f, 1e-6f);
        EXPECT_FLOAT_EQ(same.bsdf.coat_alpha, m.coat_alpha);
    }
    EXPECT_TRUE(w.ndf_filter_applies(MODEL_BECKMANN_CONDUCTOR));
    EXPECT_FALSE(w.ndf_filter_applies(MODEL_LAMBERT));
}

}  // namespace
}  // namespace gp::test
