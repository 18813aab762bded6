// The real files beside the checkout. Where they are missing, these tests skip and say so.
#include "shading/shading.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "io/image_file.h"
#include "io/load_helpers.h"
#include "scene/tangents.h"

using namespace gp;
using namespace gp::test;

namespace {

const std::string assets = std::string(GP_SOURCE_DIR) + "/../shared/assets/";

#define GP_REQUIRE_ASSETS() \
    if (!std::filesystem::exists(assets)) GTEST_SKIP() << assets << " is missing"

Scene loadAsset(const std::string& file, double time = 0, int animation = -1) {
    io::GltfOptions options;
    options.time = time;
    options.animation = animation;
    Scene scene;
    io::loadGltf(assets + file, options, scene);
    return scene;
}

size_t trianglesOf(const Scene& scene) {
    size_t n = 0;
    for (const auto& i : scene.instances) n += i->mesh->triangles.size();
    return n;
}

std::vector<std::string> filesWith(std::initializer_list<const char*> extensions) {
    std::vector<std::string> out;
    for (const auto& e : std::filesystem::recursive_directory_iterator(assets))
        for (const char* x : extensions)
            if (e.path().extension() == x)
                out.push_back(std::filesystem::relative(e.path(), assets).string());
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST(Assets, EveryModelLoads) {
    GP_REQUIRE_ASSETS();
    const std::map<std::string, std::pair<size_t, size_t>> known = {  // instances, triangles
        {"SimpleInstancing/SimpleInstancing.gltf", {125, 1500}},
        {"FlightHelmet/FlightHelmet.gltf", {6, 94722}},
        {"MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.gltf", {123, 1040409}},
        {"Zdm2/zdm2.glb", {1, 58772}},
        {"MeshPrimitiveModes/MeshPrimitiveModes.gltf", {3, 16}},
        {"Fox/Fox.gltf", {1, 576}},
        {"TriangleWithoutIndices/TriangleWithoutIndices.gltf", {1, 1}},
        {"DamagedHelmet/DamagedHelmet.glb", {1, 15452}}};
    const std::vector<std::string> files = filesWith({".gltf", ".glb"});
    EXPECT_GE(files.size(), 40u);
    for (const std::string& file : files) {
        SCOPED_TRACE(file);
        const Scene s = loadAsset(file);
        EXPECT_GT(trianglesOf(s), 0u);
        const Bounds b = worldBounds(s);
        EXPECT_TRUE(std::isfinite(glm::length(b.lo)) && std::isfinite(glm::length(b.hi)));
        EXPECT_FALSE(b.empty());
        if (const auto it = known.find(file); it != known.end()) {
            EXPECT_EQ(s.instances.size(), it->second.first);
            EXPECT_EQ(trianglesOf(s), it->second.second);
        }
        for (const auto& i : s.instances)
            for (const glm::uvec3 t : i->mesh->triangles)
                ASSERT_LT(std::max({t.x, t.y, t.z}), i->mesh->vertexCount());
    }
}

TEST(Assets, EveryImageLoads) {
    GP_REQUIRE_ASSETS();
    for (const std::string& file : filesWith({".png", ".jpg", ".jpeg", ".hdr", ".exr"})) {
        SCOPED_TRACE(file);
        const Image image = io::loadImage(assets + file);
        EXPECT_GT(image.width, 0u);
        if (!file.starts_with("env_")) continue;
        EXPECT_EQ(image.format, PixelFormat::rgba32f);
        EXPECT_EQ(image.width, 1024u);
        EXPECT_EQ(image.height, 512u);
        double sum = 0;
        for (size_t i = 0; i < size_t(1024) * 512 * 4; ++i) {
            // The .exr files are lossily compressed, which leaves a few small negative values.
            ASSERT_TRUE(std::isfinite(image.floats()[i]) && image.floats()[i] > -0.01f);
            sum += image.floats()[i];
        }
        EXPECT_GT(sum, 1e4);
    }
}

TEST(Assets, SparsePositionsAreExact) {
    GP_REQUIRE_ASSETS();
    const Scene s = loadAsset("SimpleSparseAccessor/SimpleSparseAccessor.gltf");
    // Two rows of seven points; the sparse part lifts points 8, 10 and 12. (The file's own text.)
    const auto& p = s.instances[0]->mesh->positions;
    const auto has = [&](glm::vec3 v) {
        return std::find(p.begin(), p.end() - 1, v) != p.end() - 1;
    };
    for (const glm::vec3 v : {glm::vec3(1, 2, 0), {3, 3, 0}, {5, 4, 0}, {0, 1, 0}, {6, 0, 0}})
        EXPECT_TRUE(has(v)) << v.x << " " << v.y;
    for (const glm::vec3 v : {glm::vec3(1, 1, 0), {3, 1, 0}, {5, 1, 0}}) EXPECT_FALSE(has(v));
}

TEST(Assets, SimpleMorphByHand) {
    GP_REQUIRE_ASSETS();
    // Weights go (0,0) (0,1) (1,1) (1,0) (0,0) at 0..4 s; target 0 lifts the tip by (-1,1,0),
    // target 1 by (1,1,0), from (0.5,0.5,0).
    const auto tip = [](double t) {
        const Scene s = loadAsset("SimpleMorph/SimpleMorph.gltf", t);
        return worldVertex(*s.instances[0], 2);
    };
    expectNear(tip(0), {0.5f, 0.5f, 0});
    expectNear(tip(1), {1.5f, 1.5f, 0});
    expectNear(tip(1.5), {1.0f, 2.0f, 0});
    expectNear(tip(3), {-0.5f, 1.5f, 0});
}

TEST(Assets, SimpleSkinByHand) {
    GP_REQUIRE_ASSETS();
    // The second joint stands at (0,1,0) and turns about Z: 0 degrees at 0 s, 90 at 1 s.
    const auto highest = [](double t) {
        const Scene s = loadAsset("SimpleSkin/SimpleSkin.gltf", t);
        EXPECT_EQ(s.instances[0]->mesh->kind, MeshKind::dynamic);
        return worldBounds(s);
    };
    expectNear(highest(0).lo, {-0.5f, 0, 0});
    expectNear(highest(0).hi, {0.5f, 2, 0});
    // At 90 degrees the top edge (+-0.5, 2) has gone to (-1, 1 +- 0.5).
    const Bounds turned = highest(1);
    expectNear({turned.lo.x, 0, 0}, {-1, 0, 0}, 1e-4f);
    expectNear({0, turned.hi.y, 0}, {0, 1.5f, 0}, 1e-4f);
}

TEST(Assets, FoxAndFigureMove) {
    GP_REQUIRE_ASSETS();
    for (const char* file : {"Fox/Fox.gltf", "RiggedFigure/RiggedFigure.gltf"}) {
        const Scene a = loadAsset(file, 0), b = loadAsset(file, 0.4), again = loadAsset(file, 0.4);
        EXPECT_EQ(b.instances[0]->mesh->positions, again.instances[0]->mesh->positions);
        EXPECT_EQ(a.instances[0]->id, b.instances[0]->id);
        float most = 0;
        for (size_t v = 0; v < a.instances[0]->mesh->vertexCount(); ++v)
            most = std::max(most, glm::length(a.instances[0]->mesh->positions[v] -
                                              b.instances[0]->mesh->positions[v]));
        EXPECT_GT(most, 0.01f * glm::length(worldBounds(a).hi - worldBounds(a).lo)) << file;
    }
    EXPECT_EQ(loadAsset("Fox/Fox.gltf").animations,
              (std::vector<std::string>{"Survey", "Walk", "Run"}));
}

TEST(Assets, InterpolationTestModes) {
    GP_REQUIRE_ASSETS();
    const char* file = "InterpolationTest/InterpolationTest.gltf";
    ASSERT_EQ(loadAsset(file).animations.size(), 9u);
    for (int animation = 0; animation < 9; ++animation) {
        const auto poses = [&](double t) {
            const Scene s = loadAsset(file, t, animation);
            std::vector<glm::mat4x3> m;
            for (const auto& i : s.instances) m.push_back(i->worldFromObject);
            return m;
        };
        // Each animation moves exactly one of the cubes; a step holds between its keys.
        const auto a = poses(0.5), b = poses(0.55);
        size_t moved = 0;
        for (size_t i = 0; i < a.size(); ++i) moved += a[i] != b[i];
        const bool step = loadAsset(file).animations[size_t(animation)].find("Step") == 0;
        EXPECT_EQ(moved, step ? 0u : 1u) << animation;
        size_t different = 0;
        for (const double t : {1.0, 1.5, 2.0, 2.5, 3.0}) different += poses(t) != a;
        EXPECT_GT(different, 0u) << animation;
    }
}

TEST(Assets, TextureTransforms) {
    GP_REQUIRE_ASSETS();
    const Scene s = loadAsset("TextureTransformTest/TextureTransformTest.gltf");
    std::map<std::string, glm::mat3x2> m;
    for (const auto& i : s.instances)
        m[i->surface().name] = i->surface().baseColorTexture.uvTransform;
    EXPECT_EQ(m.at("Offset UV"), glm::mat3x2(1, 0, 0, 1, 0.5f, 0.5f));
    EXPECT_EQ(m.at("Scale"), glm::mat3x2(1.5f, 0, 0, 1.5f, 0, 0));
    const float c = std::cos(0.39269908f), n = std::sin(0.39269908f);
    EXPECT_LT(glm::length(m.at("Rotation")[0] - glm::vec2(c, -n)), 1e-6f);
    EXPECT_LT(glm::length(m.at("Rotation")[1] - glm::vec2(n, c)), 1e-6f);
    const float c3 = 1.5f * std::cos(0.3f), s3 = 1.5f * std::sin(0.3f);
    EXPECT_LT(glm::length(m.at("All")[0] - glm::vec2(c3, -s3)), 1e-6f);
    EXPECT_LT(glm::length(m.at("All")[2] - glm::vec2(-0.2f, -0.1f)), 1e-6f);
}

TEST(Assets, ScenesLightsCameras) {
    GP_REQUIRE_ASSETS();
    io::GltfOptions first;
    first.scene = 0;
    Scene s;
    io::loadGltf(assets + "MultipleScenes/MultipleScenes.gltf", first, s);
    EXPECT_EQ(trianglesOf(s), 1u);  // the triangle; scene 1, the default, has the square
    EXPECT_EQ(trianglesOf(loadAsset("MultipleScenes/MultipleScenes.gltf")), 2u);
    EXPECT_EQ(loadAsset("Cameras/Cameras.gltf").cameras.size(), 2u);
    EXPECT_EQ(loadAsset("LightsPunctualLamp/LightsPunctualLamp.gltf").lights.size(), 5u);
}

// Tangents that tools stored (MikkTSpace) against ours for the same meshes. Avocado and BoomBox
// are left out because theirs do not follow their own texture coordinates (half of them are more
// than 45 degrees off), Suzanne because its signs are those of v growing upwards.
TEST(Assets, GeneratedTangentsAgreeWithStoredOnes) {
    GP_REQUIRE_ASSETS();
    for (const char* file : {"FlightHelmet/FlightHelmet.gltf", "SheenCloth/SheenCloth.gltf",
                             "AnisotropyStrengthTest/AnisotropyStrengthTest.gltf",
                             "LightsPunctualLamp/LightsPunctualLamp.gltf",
                             "AlphaBlendModeTest/AlphaBlendModeTest.glb"}) {
        SCOPED_TRACE(file);
        const Scene s = loadAsset(file);
        size_t corners = 0, signs = 0, close = 0;
        for (const auto& instance : s.instances) {
            const Mesh& m = *instance->mesh;
            std::vector<glm::vec3> normals;
            std::vector<glm::vec2> uv;
            for (const ShadingVertex& v : m.vertices) {
                normals.push_back(shading::octahedral_decode(v.normalOct));
                uv.push_back(v.uv);
            }
            const std::vector<glm::vec4> ours = generateTangents(
                {std::span(m.positions).first(m.vertexCount()), normals, uv, m.triangles});
            for (size_t i = 0; i < ours.size(); ++i, ++corners) {
                const ShadingVertex& v = m.vertices[m.triangles[i / 3][int(i % 3)]];
                signs += shading::tangent_decode_handedness(v.tangentOct) == ours[i].w;
                close +=
                    glm::dot(shading::tangent_decode(v.tangentOct), glm::vec3(ours[i])) > 0.985f;
            }
        }
        EXPECT_GT(double(signs) / double(corners), 0.999);
        EXPECT_GT(double(close) / double(corners), 0.985);
    }
}

// Ships none: the generated ones must have bitangents where v falls, which is up in the picture.
TEST(Assets, NormalTangentTestHasUpwardBitangents) {
    GP_REQUIRE_ASSETS();
    const Scene s = loadAsset("NormalTangentTest/NormalTangentTest.glb");
    const Mesh& m = *s.instances[0]->mesh;
    size_t right = 0, wrong = 0;
    for (const glm::uvec3 t : m.triangles) {
        const glm::vec2 a = m.vertices[t.y].uv - m.vertices[t.x].uv;
        const glm::vec2 b = m.vertices[t.z].uv - m.vertices[t.x].uv;
        const float area = a.x * b.y - a.y * b.x;
        const glm::vec3 e1 = m.positions[t.y] - m.positions[t.x];
        const glm::vec3 e2 = m.positions[t.z] - m.positions[t.x];
        if (std::abs(area) < 1e-9f || glm::length(glm::cross(e1, e2)) < 1e-9f) continue;
        const glm::vec3 up = glm::normalize(-(e2 * a.x - e1 * b.x) / area);
        for (int c = 0; c < 3; ++c) {
            const ShadingVertex& v = m.vertices[t[c]];
            const float sign = shading::tangent_decode_handedness(v.tangentOct);
            const glm::vec3 bitangent = sign * glm::cross(shading::octahedral_decode(v.normalOct),
                                                          shading::tangent_decode(v.tangentOct));
            (glm::dot(bitangent, up) > 0 ? right : wrong)++;
        }
    }
    EXPECT_GT(right, 20000u);
    EXPECT_EQ(wrong, 0u);
}
