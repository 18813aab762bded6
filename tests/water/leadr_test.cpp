// Normal maps under the glint model: the kernels' own point of a material, whose far view is the
// mean of its near views, and the tables that a scene makes of it.
#include "shading/shading.h"

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "backend/cpu/material_table.h"
#include "backend/cpu/texture_view.h"
#include "scene/bsdf_registry.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "statistics/random.h"

namespace gp {
namespace {

using namespace gp::shading;
using namespace gp::shared;

// What kernels/library_material.glsl asks of the world.
struct PointKernels {
    std::vector<BsdfParams> bsdfs;
    cpu::SlopeMapView slopeMap{};
    BsdfLayerRecord noLayer{};
    TextureLayerRecord noTextureLayer{};
    InstanceRecord noInstance{};
    MaterialSlopes slopes{};

    const MaterialSlopes& load_material_slopes(uint) { return slopes; }
    const BsdfParams& load_bsdf(uint i) { return bsdfs[i]; }
    const BsdfLayerRecord& load_bsdf_layer(uint) { return noLayer; }
    const TextureLayerRecord& load_texture_layer(uint) { return noTextureLayer; }
    const InstanceRecord& load_instance(uint) { return noInstance; }
    // Texture coordinates are x and y.
    TriangleCorners load_triangle(uint, uint) {
        TriangleCorners c{};
        c.p1 = vec3(1, 0, 0), c.p2 = vec3(0, 1, 0);
        c.uv1 = vec2(1, 0), c.uv2 = vec2(0, 1);
        c.normal0 = c.normal1 = c.normal2 = octahedral_encode(vec3(0, 0, 1));
        return c;
    }
    vec2 load_uv1(uint, uint, float, float) { return vec2(0); }
    vec4 load_vertex_color(uint, uint, float, float) { return vec4(1); }
    vec4 sample_texture(uint, vec2, float, float) { return vec4(0.5f, 0.5f, 1, 1); }
    const SlopeMapSize& load_slope_map(uint) { return slopeMap.size; }
    Slopes load_slopes(uint, int level, int x, int y) {
        const int w = std::max(int(slopeMap.size.width >> level), 1);
        const int h = std::max(int(slopeMap.size.height >> level), 1);
        const auto* texels = static_cast<const SlopeTexel*>(slopeMap.levels[level]);
        return slope_texel_decode(
            texels[wrapped_texel(y, h, slopeMap.wrapV) * w + wrapped_texel(x, w, slopeMap.wrapU)]);
    }
#include "kernels/library_material.glsl"
};

std::shared_ptr<Texture> normalTexture(uint32_t n, uint64_t seed, float sigma) {
    TextureDesc d;
    d.image.width = d.image.height = n, d.image.format = PixelFormat::rgba32f;
    d.image.pixels.resize(size_t(n) * n * 16);
    d.colorSpace = ColorSpace::linear;
    test::Random random(seed);
    for (uint32_t i = 0; i < n * n; ++i) {
        // Gaussian slopes, twice as wide along x, correlated, about (0.1, 0).
        const vec2 z = gaussian_pair(vec2(random.uniform(), random.uniform()));
        const vec2 s(0.1f + sigma * z.x, 0.5f * sigma * (0.5f * z.x + 0.87f * z.y));
        const vec3 normal = normalize(vec3(-s.x, -s.y, 1)) * 0.5f + 0.5f;
        float* p = d.image.floats() + 4 * size_t(i);
        p[0] = normal.x, p[1] = normal.y, p[2] = normal.z, p[3] = 1;
    }
    return makeTexture(std::move(d));
}

struct Bumpy : testing::Test {
    SlopeMap slopes = slopeMapFromNormals(*normalTexture(64, 5, 0.12f));
    PointKernels kernels;
    MaterialRecord material{};
    PointKernels::Surface surface{};

    Bumpy() {
        kernels.slopeMap = cpu::slopeMapView(slopes);
        BsdfParams metal = bsdf_params_of(MODEL_GLINT);
        metal.metallic = 1, metal.base_color = vec3(1);
        metal.alpha_x = metal.alpha_y = 0.12f;
        metal.slot_b.x = float(GLINT_SMOOTH);
        for (int i = 0; i < 3; ++i)
            kernels.noInstance.world_from_object[i][i] = 1,
            kernels.noInstance.normal_from_object[i][i] = 1;
        kernels.bsdfs.push_back(bsdf_prepared(metal));
        material.flags = MATERIAL_LIBRARY | MATERIAL_GLINT, material.model = MODEL_GLINT;
        material.textures = SLOT_SLOPES;
        kernels.slopes.slot.row_u = {1, 0, 0, 0}, kernels.slopes.slot.row_v = {0, 1, 0, 0};
        kernels.slopes.is_last = 1;
        scaleNormals(1);
        surface.ng = vec3(0, 0, 1), surface.front = 1, surface.color = vec4(1);
        surface.frame = frame_from_normal_tangent(vec3(0, 0, 1), vec3(1, 0, 0), 1);
    }

    void scaleNormals(float scale) {
        kernels.slopes.to_x = vec2(scale, 0), kernels.slopes.to_y = vec2(0, scale);
    }
    // width: of the pixel, metres, in parallel light.
    PointKernels::ShadingPoint point(vec2 uv, float width, vec3 wo) {
        surface.uv0 = uv, surface.cone.width = width;
        return kernels.library_point(material, surface, wo, vec3(1), vec3(0), 0.5f);
    }
    float reflected(vec2 uv, float width, vec3 wo, vec3 wi) {
        const PointKernels::ShadingPoint p = point(uv, width, wo);
        return bsdf_eval(p.bsdf, local_from_world(p.frame, wo), local_from_world(p.frame, wi))
            .f_cos.x;
    }
    // The normal of the mesosurface in the world.
    vec3 normal(const PointKernels::ShadingPoint& p) {
        return world_from_local(p.frame, facet_of(glint_mean(p.bsdf)));
    }
};

// Below a texel the map bends, at a distance it is rough: the same light.
TEST_F(Bumpy, TheFarViewIsTheMeanOfTheNearOnes) {
    const struct { vec3 wo; float tolerance; } views[] = {
        // From above, the areas that facets show are all the same: only the noise of 4,096 texels
        // against a Gaussian is left.
        {vec3(0, 0, 1), 0.03f},
        // At a slant a flat geometry shows all texels alike, a rough one those more that face it.
        {normalize(vec3(0.5f, 0.2f, 1)), 0.1f}};
    for (const auto& view : views)
        for (const vec2 s : {vec2(0.1f, 0), vec2(0.25f, 0.05f), vec2(-0.1f, -0.08f)}) {
            const vec3 wi = reflect(-view.wo, facet_of(s));
            double near = 0;
            // At the texels' centres: between them linear reads mix slopes, whose distribution is
            // not Gaussian any more.
            const int n = 64;
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    near += double(reflected((vec2(x, y) + 0.5f) / float(n), 1e-4f, view.wo, wi));
            near /= n * n;
            const float far = reflected(vec2(0.3f, 0.6f), 1, view.wo, wi);
            // What no map would show, or one whose normals are averaged.
            const float plain = reflected(vec2(0.3f, 0.6f), 1e-4f, view.wo, wi);
            EXPECT_NEAR(far / near, 1, view.tolerance) << s.x << ' ' << s.y;
            EXPECT_GT(std::abs(plain / near - 1), 0.1) << s.x << ' ' << s.y;
        }
}

TEST_F(Bumpy, ATransformOfCoordinatesAndAScaleOfNormalsReachTheSlopes) {
    // Four repeats a unit: a quarter of the footprint sees all of the map.
    const Slopes whole = glint_material_slopes(point(vec2(0.3f), 1, vec3(0, 0, 1)).bsdf);
    kernels.slopes.slot.row_u.x = kernels.slopes.slot.row_v.y = 4;
    const Slopes quarter = glint_material_slopes(point(vec2(0.3f), 0.25f, vec3(0, 0, 1)).bsdf);
    EXPECT_NEAR(quarter.mean.x, whole.mean.x, 1e-4f);
    EXPECT_NEAR(quarter.var_x, whole.var_x, 1e-3f * whole.var_x);
    scaleNormals(0.5f);
    const Slopes half = glint_material_slopes(point(vec2(0.3f), 0.25f, vec3(0, 0, 1)).bsdf);
    const float own = 0.5f * 0.12f * 0.12f;
    EXPECT_NEAR(half.mean.x, 0.5f * whole.mean.x, 1e-4f);
    EXPECT_NEAR(half.var_x - own, 0.25f * (whole.var_x - own), 1e-5f);
    EXPECT_NEAR(half.cov, 0.25f * whole.cov, 1e-5f);
}

TEST_F(Bumpy, NeitherATurnedTangentNorTheBackMovesTheSurface) {
    const vec3 wo = normalize(vec3(0.2f, -0.3f, 1)), wi = normalize(vec3(-0.1f, 0.5f, 1));
    const vec2 uv(0.37f, 0.81f);
    for (const float width : {1e-4f, 0.125f, 1.0f}) {
        const float straight = reflected(uv, width, wo, wi);
        const vec3 n = normal(point(uv, width, wo));
        material.anisotropy_rotation = 0.7f;
        EXPECT_NEAR(reflected(uv, width, wo, wi), straight, 2e-3f * straight) << width;
        // Seen from below: the same surface, hence the other side's normal.
        surface.front = 0, surface.ng = vec3(0, 0, 1);
        const vec3 down = normal(point(uv, width, -wo));
        EXPECT_NEAR(dot(down, n), -1, 1e-4f) << width;
        EXPECT_NEAR(reflected(uv, width, -wo, -wi), straight, 2e-3f * straight) << width;
        surface.front = 1, material.anisotropy_rotation = 0;
    }
}

TEST_F(Bumpy, ASurfaceThatTurnsAwayStaysInSight) {
    scaleNormals(8);
    test::Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const vec3 wo = normalize(
            vec3(random.uniform() * 8 - 4, random.uniform() * 8 - 4, random.uniform() + 1e-3f));
        const auto p = point(vec2(random.uniform(), random.uniform()), 1e-4f, wo);
        EXPECT_GT(slope_facing(glint_mean(p.bsdf), local_from_world(p.frame, wo)), 0.0f);
    }
}

// ------------------------------------------------------------------------ what a scene makes

std::shared_ptr<Material> materialWith(const std::shared_ptr<Texture>& normals, const char* model) {
    auto m = std::make_shared<Material>();
    m->normalTexture.texture = normals;
    if (model) {
        m->layers.push_back({std::make_shared<BsdfSettings>(findBsdfModel(model)), 1, {}, 0});
    }
    return m;
}

TEST(SlopeTables, AreMadeForGlintsOnceAndAgainWhenTheTextureChanges) {
    const auto normals = normalTexture(8, 1, 0.1f);
    Scene scene;
    for (const char* model : {"glint", "glint", "ward", static_cast<const char*>(nullptr)}) {
        auto instance = std::make_shared<Instance>();
        instance->mesh = std::make_shared<Mesh>();
        instance->material = materialWith(normals, model);
        scene.instances.push_back(instance);
    }
    cpu::MaterialTable table;
    cpu::SceneView view{};
    const auto record = [&](size_t i) -> const MaterialRecord& {
        return view.materials[table.indexOf(*scene.instances[i])];
    };
    const auto slopes = [&](size_t i) { return view.materialSlopes[record(i).first_slopes]; };
    table.fill(scene), table.show(view);
    for (const size_t glint : {0, 1}) {
        EXPECT_EQ(record(glint).textures, SLOT_SLOPES);
        EXPECT_EQ(slopes(glint).slope_map, 0u);
        EXPECT_EQ(slopes(glint).is_last, 1u);
    }
    EXPECT_EQ(record(2).textures, SLOT_NORMAL);
    EXPECT_EQ(record(3).textures, SLOT_NORMAL);
    EXPECT_EQ(view.slopeMaps[0].size.width, 8u);
    const void* first = view.slopeMaps[0].levels[0];
    const auto mean = [&] {
        return static_cast<const PackedSlopes*>(view.slopeMaps[0].levels[0])->meanX;
    };
    const float before = mean();
    table.fill(scene), table.show(view);
    EXPECT_EQ(view.slopeMaps[0].levels[0], first);

    const float texel[4] = {0.2f, 0.5f, 0.9f, 1};
    updateTexture(*normals, {0, 0, 1, 1}, reinterpret_cast<const std::byte*>(texel), sizeof texel);
    table.fill(scene), table.show(view);
    EXPECT_NE(mean(), before);
    EXPECT_NEAR(mean(), 0.75f, 1e-5f);  // -(2 * 0.2 - 1) / (2 * 0.9 - 1)
}

}  // namespace
}  // namespace gp
