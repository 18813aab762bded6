// What each scene promises about its content.
#include "glb_reader.h"
#include "make_scene/make_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace gp::make_scene {
namespace {

using testing::ReadScene;

bool has(const std::vector<std::string>& list, const std::string& value)
{
    return std::find(list.begin(), list.end(), value) != list.end();
}

double strengthOf(const ReadScene& scene, const std::string& material)
{
    const auto it = std::find(scene.materials.begin(), scene.materials.end(), material);
    return it == scene.materials.end()
               ? -1.0
               : scene.emissionStrengths[static_cast<std::size_t>(it - scene.materials.begin())];
}

TEST(MakeSceneContent, StillLifeHasItsMaterialsAndNoLight)
{
    const ReadScene scene = testing::generate("still-life");
    EXPECT_EQ(scene.cameras, (std::vector<std::string>{"painter", "close"}));
    for (const char* material : {"glass", "water", "painted glaze", "brushed silver", "gold",
                                 "rough copper", "velvet", "car paint", "soap film", "oak"})
        EXPECT_TRUE(has(scene.materials, material)) << material;
    for (const double strength : scene.emissionStrengths)
        EXPECT_EQ(strength, 0.0);
    EXPECT_GE(scene.images, 12u);
}

TEST(MakeSceneContent, RoomIsLitByItsLamps)
{
    const ReadScene scene = testing::generate("room");
    for (const char* lamp : {"bulb", "lit shade", "opal globe"})
        EXPECT_GT(strengthOf(scene, lamp), 1.0) << lamp;
    EXPECT_EQ(std::count_if(scene.emissionStrengths.begin(), scene.emissionStrengths.end(),
                            [](double strength) { return strength > 0.0; }),
              3);
}

TEST(MakeSceneContent, CorridorHasAsManyFlamesAsAskedFor)
{
    const ReadScene twelve = testing::generate("corridor");
    const ReadScene twenty = testing::generate("corridor", {{"torches", 20}});
    EXPECT_EQ(twenty.nodes - twelve.nodes, 8u * 4u);  // rib, iron, shaft, flame
    EXPECT_GT(strengthOf(twelve, "fire"), 100.0);
}

TEST(MakeSceneContent, FurnaceSharesOneSphere)
{
    const ReadScene scene = testing::generate("furnace", {{"rows", 3}, {"columns", 4}});
    EXPECT_EQ(scene.meshes.size(), 12u);
    EXPECT_EQ(scene.materials.size(), 12u);
    EXPECT_TRUE(has(scene.materials, "roughness 0.000 metallic 0.000"));
    EXPECT_TRUE(has(scene.materials, "roughness 1.000 metallic 1.000"));
    const std::string path = testing::outputPath("furnace.glb");
    makeScene({"furnace", path, {{"rows", 100}, {"columns", 100}}});
    // Ten thousand spheres of 4,753 vertices would be 1.5 GB if each had its own.
    EXPECT_LT(testing::readBytes(path).size(), 8u << 20);
}

TEST(MakeSceneContent, CornellBoxHasItsSize)
{
    const ReadScene scene = testing::generate("cornell", {{"radiance", 40}});
    EXPECT_NEAR(strengthOf(scene, "lamp"), 40.0, 1e-4);
    EXPECT_EQ(scene.instancedTriangles, 5u * 2u + 2u * 12u + 2u);
    glm::vec3 low(1e9f), high(-1e9f);
    for (const testing::ReadMesh& mesh : scene.meshes) {
        low = glm::min(low, mesh.low);
        high = glm::max(high, mesh.high);
    }
    EXPECT_EQ(low, glm::vec3(-1, 0, -1));
    EXPECT_EQ(high, glm::vec3(1, 2, 1));
}

TEST(MakeSceneContent, ClosedSphereEmitsWhatWasAsked)
{
    EXPECT_NEAR(strengthOf(testing::generate("closed-sphere"), "wall"), 0.5, 1e-6);
    EXPECT_NEAR(strengthOf(testing::generate("closed-sphere", {{"emission", 7.5}}), "wall"), 7.5,
                1e-5);
}

TEST(MakeSceneContent, TheShoreGoesUnderTheSea)
{
    const ReadScene scene = testing::generate("shore");
    EXPECT_EQ(scene.cameras, std::vector<std::string>{"on the beach"});
    EXPECT_TRUE(scene.lights.empty());
    const auto named = [&](const std::string& name) {
        const auto it = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                     [&](const auto& mesh) { return mesh.name == name; });
        EXPECT_NE(it, scene.meshes.end()) << name;
        return it;
    };
    const auto sand = named("sand"), post = named("post");
    ASSERT_TRUE(sand != scene.meshes.end() && post != scene.meshes.end());
    // Dry behind, under water in front; the post stands in the water and out of it.
    for (const glm::vec3& p : sand->positions) {
        EXPECT_TRUE(p.z < 7.5f || p.y > 0.0f) << p.x << ' ' << p.z;
        EXPECT_TRUE(p.z > 1.0f || p.y < 0.0f) << p.x << ' ' << p.z;
    }
    EXPECT_LT(post->low.y, 0.0f);
    EXPECT_GT(post->high.y, 0.5f);
}

TEST(MakeSceneContent, ThreeObjectsHaveOneMaterialAndTwoPointLights)
{
    const ReadScene scene = testing::generate("three-objects");
    EXPECT_EQ(scene.lights, (std::vector<std::string>{"violet point", "red point"}));
    EXPECT_EQ(scene.materials, std::vector<std::string>{"white"});
    EXPECT_EQ(scene.cameras, std::vector<std::string>{"front"});
    ASSERT_EQ(scene.meshes.size(), 3u);
    const auto triangles = [&](std::size_t i) { return scene.meshes[i].indices.size() / 3; };
    EXPECT_LT(triangles(1), 120u);   // the low sphere: its facets show
    EXPECT_GT(triangles(2), 15000u);
    // Folds that face each other: seen from the axis of a pleat, surfaces of both senses.
    const testing::ReadMesh& bulb = scene.meshes[0];
    std::size_t inwards = 0;
    for (std::size_t i = 0; i < bulb.normals.size(); ++i) {
        const glm::vec3 outwards(bulb.positions[i].x, 0, bulb.positions[i].z);
        inwards += glm::dot(outwards, bulb.normals[i]) < 0.0f ? 1 : 0;
    }
    EXPECT_GT(inwards, bulb.normals.size() / 200);
}

TEST(MakeSceneContent, StressReachesItsCount)
{
    const std::pair<double, double> cases[] = {{1e5, 100}, {1e6, 1000}, {1e7, 5000}};
    for (const auto& [triangles, instances] : cases) {
        const ReadScene scene =
            testing::generate("stress", {{"triangles", triangles}, {"instances", instances}});
        EXPECT_TRUE(has(scene.required, "EXT_mesh_gpu_instancing"));
        EXPECT_NEAR(static_cast<double>(scene.instancedTriangles), triangles, 0.1 * triangles)
            << instances;
    }
}

}  // namespace
}  // namespace gp::make_scene
