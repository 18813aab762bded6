// What the renderer tells the model of glints of a pixel: its ellipse in texture coordinates and
// the change of the half vector's slope, against differences between neighbouring rays.
#include "shading/shading.h"
#include "shared/scene_structs.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/glint_dictionary.h"
#include "statistics/random.h"

namespace gp::shading {
namespace {

using namespace gp::shared;

// One triangle in place of a scene.
InstanceRecord theInstance;
TriangleCorners theTriangle;
BsdfParams theBsdf;
BsdfLayerRecord noLayer;
TextureLayerRecord noTextureLayer;
MaterialSlopes noSlopes;

const InstanceRecord& load_instance(uint) { return theInstance; }
TriangleCorners load_triangle(uint, uint) { return theTriangle; }
vec2 load_uv1(uint, uint, float, float) { return vec2(0.0f); }
vec4 load_vertex_color(uint, uint, float, float) { return vec4(1.0f); }
vec4 sample_texture(uint, vec2, float, float) { return vec4(1.0f); }
// No material here has a normal map, and none is the sea's.
SlopeMapSize load_slope_map(uint) { return {1, 1, 1, 1}; }
Slopes load_slopes(uint, int, int, int) { return slopes_constant(vec2(0.0f)); }
SeaSlopes sample_sea(vec2, vec2, vec2) { return {}; }
const BsdfParams& load_bsdf(uint) { return theBsdf; }
const BsdfLayerRecord& load_bsdf_layer(uint) { return noLayer; }
const TextureLayerRecord& load_texture_layer(uint) { return noTextureLayer; }

const MaterialSlopes& load_material_slopes(uint) { return noSlopes; }

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "kernels/material.glsl"
#pragma GCC diagnostic pop

struct View {
    vec3 eye;
    float spread;
};

// Where the ray meets the triangle's plane.
Hit hitOf(vec3 eye, vec3 direction) {
    const vec3 e1 = theTriangle.p1 - theTriangle.p0, e2 = theTriangle.p2 - theTriangle.p0;
    const vec3 ng = cross(e1, e2);
    Hit hit;
    hit.t = dot(theTriangle.p0 - eye, ng) / dot(direction, ng);
    const vec3 d = eye + direction * hit.t - theTriangle.p0;
    hit.u = dot(cross(d, e2), ng) / dot(ng, ng);
    hit.v = dot(cross(e1, d), ng) / dot(ng, ng);
    hit.instance = 0;
    hit.primitive = 0;
    return hit;
}

RayCone coneAt(const View& view, float t) {
    RayCone cone;
    cone.width = view.spread * t;
    cone.spread = view.spread;
    return cone;
}

MaterialRecord glintMaterial() {
    MaterialRecord m{};
    m.base_color = vec4(1.0f);
    m.flags = MATERIAL_LIBRARY | MATERIAL_GLINT;
    m.model = MODEL_GLINT;
    m.anisotropy = 1.0f;
    return m;
}

struct Seen {
    BsdfParams bsdf;
    Surface surface;
    Frame frame;
};

Seen seenAlong(const View& view, vec3 direction) {
    const MaterialRecord m = glintMaterial();
    const Hit hit = hitOf(view.eye, direction);
    Seen seen;
    seen.surface =
        load_surface(hit, direction, coneAt(view, hit.t), surface_needs(m, false));
    const ShadingPoint p = load_shading_point(m, seen.surface, -direction, 0.5f, false);
    seen.bsdf = p.bsdf;
    seen.frame = p.frame;
    return seen;
}

void makeScene(bool curved) {
    theInstance = InstanceRecord{};
    for (int i = 0; i < 3; ++i) theInstance.world_from_object[i][i] = 1.0f;
    for (int i = 0; i < 3; ++i) theInstance.normal_from_object[i][i] = 1.0f;
    theTriangle = TriangleCorners{};
    theTriangle.p0 = vec3(-1.0f, -1.0f, 0.0f);
    theTriangle.p1 = vec3(2.0f, -0.8f, 0.0f);
    theTriangle.p2 = vec3(-0.5f, 1.5f, 0.0f);
    const auto normal = [&](vec3 p) {
        return octahedral_encode(normalize(curved ? vec3(0.2f * p.x, 0.4f * p.y, 1.0f)
                                                  : vec3(0.0f, 0.0f, 1.0f)));
    };
    theTriangle.normal0 = normal(theTriangle.p0);
    theTriangle.normal1 = normal(theTriangle.p1);
    theTriangle.normal2 = normal(theTriangle.p2);
    theTriangle.uv0 = vec2(0.1f, 0.2f);
    theTriangle.uv1 = vec2(1.3f, 0.5f);
    theTriangle.uv2 = vec2(-0.2f, 1.7f);
    theBsdf = bsdf_params_of(MODEL_GLINT);
    theBsdf.metallic = 1.0f;
    theBsdf.table = glintDictionary();
    theBsdf = bsdf_prepared(theBsdf);
}

// a a^T + b b^T: the same for every pair of axes of one ellipse.
vec3 ellipse(vec2 a, vec2 b) {
    return vec3(a.x * a.x + b.x * b.x, a.y * a.y + b.y * b.y, a.x * a.y + b.x * b.y);
}

void expectNear(vec3 a, vec3 b, float share) {
    const float scale = std::max(b.x, b.y);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], share * scale) << i;
}

// Half a pixel to both sides along two directions across the ray.
template <class Of>
vec3 ellipseOfDifferences(const View& view, vec3 direction, const Of& of) {
    const Frame f = frame_from_normal(direction);
    vec2 change[2];
    for (int k = 0; k < 2; ++k) {
        const vec3 across = (k == 0 ? f.t : f.b) * (0.5f * view.spread);
        change[k] = of(normalize(direction + across)) - of(normalize(direction - across));
    }
    return ellipse(change[0], change[1]);
}

TEST(GlintFootprint, IsThatOfNeighbouringRays) {
    makeScene(true);
    const View view{vec3(0.5f, -2.0f, 1.5f), 2e-3f};
    for (const vec3 target : {vec3(0, 0, 0), vec3(0.3f, -0.5f, 0), vec3(-0.4f, 0.5f, 0)}) {
        const vec3 direction = normalize(target - view.eye);
        const BsdfParams m = seenAlong(view, direction).bsdf;
        const vec3 uv = ellipse(vec2(m.slot_d.x, m.slot_d.y), vec2(m.slot_d.z, m.slot_d.w));
        expectNear(uv, ellipseOfDifferences(view, direction, [&](vec3 d) {
                       return seenAlong(view, d).surface.uv0;
                   }), 0.02f);
        EXPECT_GT(uv.x, 0.0f);
    }
}

// A distant light in the mirror direction; the frame of a neighbour is the interpolated one.
TEST(GlintFootprint, KernelIsTheChangeOfTheHalfVectorsSlope) {
    for (const bool curved : {false, true}) {
        makeScene(curved);
        const View view{vec3(0.4f, -1.0f, 1.5f), 2e-3f};
        const vec3 direction = normalize(vec3(0.1f, -0.2f, 0.0f) - view.eye);
        const Seen seen = seenAlong(view, direction);
        const vec3 wi = reflect(direction, seen.frame.n);
        const vec3 expected = ellipseOfDifferences(view, direction, [&](vec3 d) {
            const Seen near = seenAlong(view, d);
            const Frame f = frame_from_normal_tangent(near.frame.n, seen.frame.t, 1.0f);
            return slope_of(normalize(local_from_world(f, wi - d)));
        });
        const BsdfParams& m = seen.bsdf;
        const Frame own = frame_from_normal_tangent(seen.frame.n, seen.frame.t, 1.0f);
        const float mirrored = dot(own.b, seen.frame.b) < 0.0f ? -1.0f : 1.0f;
        vec3 kernel = ellipse(vec2(m.slot_e.x, m.slot_e.y), vec2(m.slot_e.z, m.slot_e.w));
        kernel.z *= mirrored;
        expectNear(kernel, expected, 0.05f);
        EXPECT_GT(kernel.x, 1e-8f);
    }
}

TEST(GlintFootprint, WithoutTextureCoordinatesTheSurfaceIsSmooth) {
    makeScene(false);
    theTriangle.uv0 = theTriangle.uv1 = theTriangle.uv2 = vec2(0.0f);
    const View view{vec3(0.0f, 0.0f, 1.0f), 1e-3f};
    const BsdfParams m = seenAlong(view, vec3(0.0f, 0.0f, -1.0f)).bsdf;
    EXPECT_EQ(glint_method(m), GLINT_SMOOTH);
    EXPECT_TRUE(std::isfinite(bsdf_eval(m, vec3(0, 0, 1), vec3(0, 0, 1)).f_cos.x));
}

// Whichever way the facets' mean is bent, a coat without a normal map lies on the surface.
TEST(GlintFootprint, TheCoatStaysOnTheSurface) {
    makeScene(true);
    theBsdf.coat = 1.0f;
    theBsdf.slot_a.x = 0.3f, theBsdf.slot_a.y = -0.2f;
    for (const float y : {-0.4f, 0.0f, 0.5f}) {
        const Seen seen = seenAlong({vec3(0.5f, y, 2.0f), 1e-3f}, vec3(0.0f, 0.0f, -1.0f));
        const vec2 mean = glint_mean(seen.bsdf);
        EXPECT_NEAR(mean.x, 0.3f, 1e-6f);
        const vec3 n = world_from_local(mesosurface_frame(mean), seen.bsdf.coat_normal);
        EXPECT_NEAR(n.z, 1.0f, 1e-6f);
        EXPECT_LT(seen.bsdf.coat_normal.z, 0.95f);
    }
}

}  // namespace
}  // namespace gp::shading
