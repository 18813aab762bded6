// Height, displacement and several maps in one material: the kernel's own reading of the tables
// that a scene makes, on triangles of any shape and texture coordinates.
#include "shading/shading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "backend/cpu/material_table.h"
#include "scene/bsdf_registry.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/scene.h"

namespace gp {
namespace {

using namespace gp::shading;
using namespace gp::shared;

// What kernels/material.glsl asks of the world: one triangle, and tables of a scene.
struct SlopeKernels {
    cpu::SceneView view{};
    InstanceRecord theInstance{};
    TriangleCorners theTriangle{};
    vec2 uv1[3] = {};

    const MaterialSlopes& load_material_slopes(uint i) { return view.materialSlopes[i]; }
    const BsdfParams& load_bsdf(uint i) { return static_cast<const BsdfParams*>(view.bsdfs)[i]; }
    const BsdfLayerRecord& load_bsdf_layer(uint i) { return view.bsdfLayers[i]; }
    const TextureLayerRecord& load_texture_layer(uint i) { return view.textureLayers[i]; }
    const InstanceRecord& load_instance(uint) { return theInstance; }
    const TriangleCorners& load_triangle(uint, uint) { return theTriangle; }
    vec2 load_uv1(uint, uint, float u, float v) {
        return interpolate(uv1[0], uv1[1], uv1[2], u, v);
    }
    vec4 load_vertex_color(uint, uint, float, float) { return vec4(1); }
    vec4 sample_texture(uint, vec2, float, float) { return vec4(0.5f, 0.5f, 1, 1); }
    SeaSlopes sample_sea(vec2, vec2, vec2) { return {}; }
    const SlopeMapSize& load_slope_map(uint i) { return view.slopeMaps[i].size; }
    Slopes load_slopes(uint map, int level, int x, int y) {
        const cpu::SlopeMapView& m = view.slopeMaps[map];
        const int w = std::max(int(m.size.width >> level), 1);
        const int h = std::max(int(m.size.height >> level), 1);
        return slope_texel_decode(static_cast<const SlopeTexel*>(
            m.levels[level])[wrapped_texel(y, h, m.wrapV) * w + wrapped_texel(x, w, m.wrapU)]);
    }
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "kernels/material.glsl"
#pragma GCC diagnostic pop
};

constexpr uint32_t size = 64;
constexpr float pi = 3.14159265f;

std::shared_ptr<Texture> image(const std::function<vec3(vec2 uv)>& texel) {
    TextureDesc d;
    d.image.width = d.image.height = size, d.image.format = PixelFormat::rgba32f;
    d.image.pixels.resize(size_t(size) * size * 16);
    d.colorSpace = ColorSpace::linear;
    for (uint32_t i = 0; i < size * size; ++i) {
        const vec3 t = texel((vec2(i % size, i / size) + 0.5f) / float(size));
        float* p = d.image.floats() + 4 * size_t(i);
        p[0] = t.x, p[1] = t.y, p[2] = t.z, p[3] = 1;
    }
    return makeTexture(std::move(d));
}

// Waves of no symmetry that repeat: their height, and its change by u and v.
float height(vec2 uv) {
    return 0.01f * std::sin(2 * pi * (2 * uv.x + uv.y)) + 0.006f * std::cos(2 * pi * 3 * uv.y);
}
vec2 gradient(vec2 uv) {
    const float a = 0.01f * 2 * pi * std::cos(2 * pi * (2 * uv.x + uv.y));
    return {2 * a, a - 0.006f * 2 * pi * 3 * std::sin(2 * pi * 3 * uv.y)};
}
std::shared_ptr<Texture> heightMap() {
    return image([](vec2 uv) { return vec3(height(uv), 0.3f, 0.7f); });
}
std::shared_ptr<Texture> offsetMap() {
    return image([](vec2 uv) { return vec3(0, 0, height(uv)); });
}
// Of the same surface where the picture is 1 m large.
std::shared_ptr<Texture> normalMap() {
    return image([](vec2 uv) {
        const vec2 g = gradient(uv);
        return normalize(vec3(-g.x, g.y, 1)) * 0.5f + 0.5f;
    });
}

SlopeMapUse use(SlopeMapKind kind, std::shared_ptr<Texture> texture) {
    SlopeMapUse u;
    u.kind = kind, u.texture.texture = std::move(texture);
    return u;
}

struct MaterialSlopeMaps : testing::Test {
    SlopeKernels kernels;
    Scene scene;
    cpu::MaterialTable table;
    std::shared_ptr<Material> material = std::make_shared<Material>();

    MaterialSlopeMaps() {
        corners({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        coordinates({0, 0}, {1, 0}, {0, -1});  // v grows downwards
        for (int i = 0; i < 3; ++i)
            kernels.theInstance.world_from_object[i][i] = 1,
            kernels.theInstance.normal_from_object[i][i] = 1;
        auto instance = std::make_shared<Instance>();
        instance->mesh = std::make_shared<Mesh>();
        scene.instances.push_back(instance);
        material->metallic = 1, material->roughness = 0.2f;
    }
    void corners(vec3 a, vec3 b, vec3 c) {
        TriangleCorners& t = kernels.theTriangle;
        t.p0 = a, t.p1 = b, t.p2 = c;
        t.normal0 = t.normal1 = t.normal2 = octahedral_encode(normalize(cross(b - a, c - a)));
    }
    void coordinates(vec2 a, vec2 b, vec2 c) {
        kernels.theTriangle.uv0 = a, kernels.theTriangle.uv1 = b, kernels.theTriangle.uv2 = c;
    }
    void maps(std::vector<SlopeMapUse> uses) {
        material->slopeMaps = std::move(uses);
        prepare();
    }
    void prepare() {
        scene.instances[0]->material = material;
        table.fill(scene), table.show(kernels.view);
    }
    SlopeKernels::Surface surface(vec2 barycentrics, float width, vec3 wo) {
        Hit hit{};
        hit.t = 1, hit.u = barycentrics.x, hit.v = barycentrics.y;
        RayCone cone{};
        cone.width = width;
        return kernels.load_surface(hit, -wo, cone,
                                    kernels.surface_needs(kernels.view.materials[0], false));
    }
    // Over x and y, where the triangle lies; which frame its coordinates give it does not matter.
    Slopes slopes(vec2 barycentrics, float width) {
        const vec3 wo = surface(barycentrics, width, vec3(0, 0, 1)).ng;
        const SlopeKernels::Surface s = surface(barycentrics, width, wo);
        const Slopes d = kernels.material_slopes(kernels.view.materials[0], s,
                                                 kernels.pixel_turns(s.hit, -wo, s.cone));
        return kernels.slopes_transformed(d, vec2(s.frame.t.x, s.frame.b.x),
                                          vec2(s.frame.t.y, s.frame.b.y));
    }
    SlopeKernels::ShadingPoint point(vec2 barycentrics, float width, vec3 wo) {
        return kernels.load_shading_point(kernels.view.materials[0],
                                          surface(barycentrics, width, wo), wo, 0.5f, false);
    }
};

void expectSame(const Slopes& a, const Slopes& b, float tolerance) {
    const float size2 = b.var_x + b.var_y + dot(b.mean, b.mean);
    EXPECT_NEAR(a.mean.x, b.mean.x, tolerance * std::sqrt(size2));
    EXPECT_NEAR(a.mean.y, b.mean.y, tolerance * std::sqrt(size2));
    EXPECT_NEAR(a.var_x, b.var_x, tolerance * size2);
    EXPECT_NEAR(a.var_y, b.var_y, tolerance * size2);
    EXPECT_NEAR(a.cov, b.cov, tolerance * size2);
}

// A picture of the same surface in three forms. A texel's slopes of heights are those of its whole
// area, of normals those of its centre: (2 pi 3 / 64)^2 / 24 = 0.4 % for the shortest wave.
TEST_F(MaterialSlopeMaps, HeightsDisplacementsAndNormalsOfOneSurfaceAreTheSame) {
    for (const float width : {1e-4f, 0.05f, 0.3f, 2.0f})
        for (const vec2 at : {vec2(0.21f, 0.4f), vec2(0.6f, 0.13f)}) {
            maps({use(SlopeMapKind::normal, normalMap())});
            const Slopes normals = slopes(at, width);
            maps({use(SlopeMapKind::height, heightMap())});
            const Slopes heights = slopes(at, width);
            expectSame(heights, normals, 0.02f);
            maps({use(SlopeMapKind::displacement, offsetMap())});
            expectSame(slopes(at, width), heights, 1e-3f);
            if (width < 0.01f) {
                const vec2 g = gradient(vec2(at.x, -at.y));
                EXPECT_NEAR(heights.mean.x, g.x, 0.01f);
                EXPECT_NEAR(heights.mean.y, -g.y, 0.01f);
            }
        }
}

// The same field of heights, in the world, whatever coordinates and transforms lead to it.
TEST_F(MaterialSlopeMaps, HeightsFollowTheTriangle) {
    maps({use(SlopeMapKind::height, heightMap())});
    const vec2 at(0.21f, 0.4f);
    const Slopes plain = slopes(at, 0.03f);
    // The picture turned by a quarter on the surface, by its coordinates: x' = -y, y' = x.
    coordinates({0, 0}, {0, 1}, {1, 0});
    const Slopes turned = slopes(vec2(-at.y, at.x), 0.03f);
    EXPECT_NEAR(turned.mean.x, -plain.mean.y, 1e-3f);
    EXPECT_NEAR(turned.mean.y, plain.mean.x, 1e-3f);
    EXPECT_NEAR(turned.var_x, plain.var_y, 1e-3f * plain.var_y);
    coordinates({0, 0}, {1, 0}, {0, -1});
    // The same by the use's transform.
    material->slopeMaps[0].texture.uvTransform = {0, 1, -1, 0, 0, 0};
    prepare();
    const Slopes transformed = slopes(vec2(-at.y, at.x), 0.03f);
    EXPECT_NEAR(transformed.mean.x, turned.mean.x, 1e-3f);
    EXPECT_NEAR(transformed.mean.y, turned.mean.y, 1e-3f);
    // Repeats make heights steeper; a stretched triangle makes them flatter along the stretch; a
    // scale of the instance leaves their form.
    material->slopeMaps[0].texture.uvTransform = {4, 0, 0, 4, 0, 0};
    prepare();
    const Slopes repeated = slopes(at * 0.25f, 0.03f * 0.25f);
    expectSame(repeated, slopes_scaled(plain, vec2(4)), 1e-3f);
    material->slopeMaps[0].texture.uvTransform = {1, 0, 0, 1, 0, 0};
    prepare();
    corners({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
    EXPECT_NEAR(slopes(at, 1e-4f).mean.x, 0.5f * gradient(vec2(at.x, -at.y)).x, 0.01f);
    corners({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (int i = 0; i < 3; ++i)
        kernels.theInstance.world_from_object[i][i] = 10,
        kernels.theInstance.normal_from_object[i][i] = 100;
    expectSame(slopes(at, 0.3f), plain, 1e-3f);
}

TEST_F(MaterialSlopeMaps, TheSecondSetOfCoordinatesIsRead) {
    SlopeMapUse heights = use(SlopeMapKind::height, heightMap());
    maps({heights});
    const Slopes first = slopes({0.21f, 0.4f}, 0.03f);
    for (int i = 0; i < 3; ++i)
        kernels.uv1[i] = i == 0 ? kernels.theTriangle.uv0
                         : i == 1 ? kernels.theTriangle.uv1 : kernels.theTriangle.uv2;
    coordinates({0, 0}, {3, 1}, {1, -2});
    heights.texture.texCoord = 1;
    maps({heights});
    expectSame(slopes({0.21f, 0.4f}, 0.03f), first, 1e-5f);
}

TEST_F(MaterialSlopeMaps, MapsAddUp) {
    SlopeMapUse detail = use(SlopeMapKind::height, heightMap());
    detail.texture.uvTransform = {7, 0, 0, 7, 0.3f, 0.1f}, detail.scale = -0.2f;
    const SlopeMapUse coarse = use(SlopeMapKind::normal, normalMap());
    for (const float width : {1e-3f, 0.1f, 1.0f}) {
        const vec2 at(0.37f, 0.22f);
        maps({coarse});
        const Slopes a = slopes(at, width);
        maps({detail});
        const Slopes b = slopes(at, width);
        maps({coarse, detail});
        expectSame(slopes(at, width), slopes_added(a, b), 1e-5f);
        EXPECT_GT(b.var_x + b.var_y + dot(b.mean, b.mean), 1e-5f);
    }
}

TEST_F(MaterialSlopeMaps, ASurfaceIsBentWhichWayAndByAsMuchAsItsHeightsSay) {
    maps({use(SlopeMapKind::height, heightMap())});
    const vec2 at(0.21f, 0.4f);
    const vec2 g = gradient(vec2(at.x, -at.y));
    const vec3 expected = normalize(vec3(-g.x, g.y, 1));
    const vec3 wo = normalize(vec3(0.2f, -0.1f, 1));
    EXPECT_NEAR(dot(point(at, 1e-4f, wo).frame.n, expected), 1, 1e-5f);
    EXPECT_NEAR(dot(point(at, 1e-4f, -wo).frame.n, -expected), 1, 1e-5f);  // seen from its back
    // Over a normal map the slopes add up: sample_texture gives the flat one.
    material->normalTexture.texture = normalMap();
    prepare();
    EXPECT_NEAR(dot(point(at, 1e-4f, wo).frame.n, expected), 1, 1e-5f);
    // A model without a width of the common kind.
    material->layers.push_back(
        {std::make_shared<BsdfSettings>(findBsdfModel("oren_nayar")), 1, {}, 0});
    prepare();
    EXPECT_NEAR(dot(point(at, 1e-4f, wo).frame.n, expected), 1, 1e-5f);
}

TEST_F(MaterialSlopeMaps, FacetsTakeHeightsAsTheyTakeANormalMap) {
    material->layers.push_back({std::make_shared<BsdfSettings>(findBsdfModel("glint")), 1, {}, 0});
    const vec3 wo = normalize(vec3(0.2f, -0.1f, 1));
    const vec2 at(0.21f, 0.4f);
    for (const float width : {1e-3f, 0.1f, 2.0f}) {
        const auto facets = [&] { return glint_material_slopes(point(at, width, wo).bsdf); };
        material->normalTexture.texture = nullptr;
        maps({});
        const Slopes own = facets();
        maps({use(SlopeMapKind::height, heightMap())});
        const Slopes heights = facets();
        material->normalTexture.texture = normalMap();
        maps({});
        const Slopes normals = facets();
        expectSame(heights, normals, 0.02f);
        maps({use(SlopeMapKind::height, heightMap())});
        expectSame(slopes_added(facets(), own), slopes_added(heights, normals), 1e-3f);
        EXPECT_GT(normals.var_x - own.var_x + length(normals.mean), 0.005f);
    }
}

// From afar the surface is flat and rough: as Beckmann facets of the sum of both covariances.
TEST_F(MaterialSlopeMaps, WhatIsBelowThePixelWidensHighlights) {
    BsdfSettings beckmann(findBsdfModel("beckmann_conductor"));
    beckmann.set("alpha_x", "0.05"), beckmann.set("alpha_y", "0.05");
    material->layers.push_back({std::make_shared<const BsdfSettings>(beckmann), 1, {}, 0});
    maps({use(SlopeMapKind::height, heightMap())});
    const vec3 wo(0, 0, 1);
    const Slopes all = slopes({0.3f, 0.3f}, 4);
    const auto p = point({0.3f, 0.3f}, 4, wo);
    EXPECT_GT(p.bsdf.alpha_x, 1.2f * p.bsdf.alpha_y);
    // The covariance in the surface's frame again, whatever way the frame is turned.
    const float x2 = p.bsdf.alpha_x * p.bsdf.alpha_x, y2 = p.bsdf.alpha_y * p.bsdf.alpha_y;
    EXPECT_NEAR(x2 + y2, 2 * (all.var_x + all.var_y) + 2 * 0.05f * 0.05f, 1e-4f);
    const vec3 t = p.frame.t, b = p.frame.b;
    EXPECT_NEAR(x2 * t.x * t.x + y2 * b.x * b.x, 2 * all.var_x + 0.05f * 0.05f, 1e-4f);
    EXPECT_NEAR(x2 * t.x * t.y + y2 * b.x * b.y, 2 * all.cov, 1e-4f);
    // Near by only what is within a texel is left: two patches of slopes that differ by the
    // curvature, at most 4.1 a metre, over 1/64 m. Of two equal halves that is half as deviation.
    const float within = 0.5f * 4.1f / 64;
    EXPECT_LT(point({0.3f, 0.3f}, 1e-5f, wo).bsdf.alpha_x,
              std::sqrt(0.05f * 0.05f + 2 * within * within));
    EXPECT_GT(p.bsdf.alpha_x, 0.15f);
}

// Far away the light is that of all places near by, on average; of a plane of metal seen from
// above, where all of its texels show the same area.
TEST_F(MaterialSlopeMaps, TheFarViewIsTheMeanOfTheNearOnes) {
    BsdfSettings beckmann(findBsdfModel("beckmann_conductor"));
    beckmann.set("alpha_x", "0.2"), beckmann.set("alpha_y", "0.2");
    material->layers.push_back({std::make_shared<const BsdfSettings>(beckmann), 1, {}, 0});
    maps({use(SlopeMapKind::height, heightMap())});
    const vec3 wo(0, 0, 1);
    const auto reflected = [&](vec2 at, float width, vec3 wi) {
        const auto p = point(at, width, wo);
        return bsdf_eval(p.bsdf, local_from_world(p.frame, wo), local_from_world(p.frame, wi))
            .f_cos.x;
    };
    for (const vec2 s : {vec2(0, 0), vec2(0.1f, 0.05f), vec2(-0.05f, 0.15f)}) {
        const vec3 wi = reflect(-wo, facet_of(s));
        double near = 0;
        for (uint32_t i = 0; i < size * size; ++i)
            near += double(reflected((vec2(i % size, i / size) + 0.5f) / float(size), 1e-4f, wi));
        near /= size * size;
        // Sums of sines are no Gaussian: the facets' own, wider ones smooth that to a few percent.
        EXPECT_NEAR(reflected({0.3f, 0.3f}, 4, wi) / near, 1, 0.06) << s.x << ' ' << s.y;
    }
}

TEST_F(MaterialSlopeMaps, ImagesAreMadeOnceAndAgainWhereTheirPixelsOrLengthsDiffer) {
    const auto heights = heightMap();
    SlopeMapUse low = use(SlopeMapKind::height, heights), high = low;
    high.scale = 3;
    maps({low, high});
    EXPECT_EQ(kernels.view.materialSlopes[0].slope_map, kernels.view.materialSlopes[1].slope_map);
    const Slopes sum = slopes({0.2f, 0.3f}, 0.05f);
    maps({low});
    expectSame(slopes_added(slopes({0.2f, 0.3f}, 0.05f),
                            slopes_scaled(slopes({0.2f, 0.3f}, 0.05f), vec2(3))), sum, 1e-5f);
    SlopeMapUse moved = use(SlopeMapKind::displacement, offsetMap()), larger = moved;
    larger.extent = vec2(2);
    maps({moved, larger});
    EXPECT_NE(kernels.view.materialSlopes[0].slope_map, kernels.view.materialSlopes[1].slope_map);

    maps({low});
    EXPECT_GT(length(slopes({0.2f, 0.3f}, 1e-4f).mean), 0.01f);
    const std::vector<float> flat(size_t(size) * size * 4, 0.5f);
    updateTexture(*heights, {0, 0, size, size}, reinterpret_cast<const std::byte*>(flat.data()),
                  size * 16);
    prepare();
    EXPECT_EQ(length(slopes({0.2f, 0.3f}, 1e-4f).mean), 0);
}

// Heights of any size and pixels that are no number make no slope that is none.
TEST_F(MaterialSlopeMaps, NothingIsEverNotFinite) {
    const float worst[] = {0, 1e30f, -1e30f, INFINITY, NAN, 1e-30f};
    const auto wild = image([&](vec2 uv) {
        return vec3(worst[int(uv.x * 64) % 6], worst[int(uv.y * 64) % 6],
                    worst[int(uv.x * 99) % 6]);
    });
    for (const auto kind :
         {SlopeMapKind::normal, SlopeMapKind::height, SlopeMapKind::displacement})
        for (const float width : {0.0f, 0.01f, 1e20f})
            for (const float scale : {1e-20f, 1.0f, -1e30f}) {
                SlopeMapUse u = use(kind, wild);
                u.scale = scale;
                maps({u});
                const auto p = point({0.3f, 0.3f}, width, vec3(0, 0, 1));
                EXPECT_TRUE(std::isfinite(p.frame.n.x + p.frame.t.y + p.bsdf.alpha_x));
                EXPECT_NEAR(length(p.frame.n), 1, 1e-4f);
            }
    // A triangle that is a line in the texture's coordinates, and one that is a point.
    maps({use(SlopeMapKind::height, heightMap())});
    coordinates({0, 0}, {1, 1}, {2, 2});
    EXPECT_TRUE(std::isfinite(slopes({0.3f, 0.3f}, 0.1f).var_x));
    coordinates({0, 0}, {0, 0}, {0, 0});
    EXPECT_EQ(slopes({0.3f, 0.3f}, 0.1f).var_x, 0);
}

}  // namespace
}  // namespace gp
