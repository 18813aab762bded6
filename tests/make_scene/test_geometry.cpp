// What must hold for every mesh of every scene, and closedness where a thing is solid.
#include "glb_reader.h"
#include "make_scene/make_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace gp::make_scene {
namespace {

using testing::ReadMesh;
using testing::ReadScene;

// Vertices at one place become one: seams of UVs and normals do not open a surface.
std::vector<std::uint32_t> weld(const ReadMesh& mesh)
{
    std::map<std::array<long, 3>, std::uint32_t> seen;
    std::vector<std::uint32_t> welded;
    for (const glm::vec3& p : mesh.positions) {
        const std::array<long, 3> key{std::lround(p.x * 1e7), std::lround(p.y * 1e7),
                                      std::lround(p.z * 1e7)};
        const auto next = static_cast<std::uint32_t>(seen.size());
        welded.push_back(seen.try_emplace(key, next).first->second);
    }
    return welded;
}

// Edges of a closed, consistently wound surface appear as often one way as the other.
std::size_t openEdges(const ReadMesh& mesh)
{
    const std::vector<std::uint32_t> welded = weld(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = welded[mesh.indices[i + k]];
            const std::uint32_t b = welded[mesh.indices[i + (k + 1) % 3]];
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    std::size_t open = 0;
    for (const auto& [edge, count] : balance)
        open += count != 0 ? 1 : 0;
    return open;
}

// [Zhang and Chen 2001, "Efficient feature extraction for 2D/3D objects in mesh
// representation"]: the signed volume; positive where triangles face out
double volume(const ReadMesh& mesh)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

void checkMesh(const ReadMesh& mesh)
{
    SCOPED_TRACE(mesh.name);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    glm::vec3 low(1e30f), high(-1e30f);
    std::size_t badNormals = 0, badUvs = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        low = glm::min(low, mesh.positions[i]);
        high = glm::max(high, mesh.positions[i]);
        badNormals += std::abs(glm::length(mesh.normals[i]) - 1.0f) < 1e-4f ? 0 : 1;
        badUvs += std::isfinite(mesh.uvs[i].x) && std::isfinite(mesh.uvs[i].y) ? 0 : 1;
    }
    EXPECT_EQ(badNormals, 0u);
    EXPECT_EQ(badUvs, 0u);
    EXPECT_EQ(low, mesh.low);
    EXPECT_EQ(high, mesh.high);

    std::size_t degenerate = 0, against = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        ASSERT_LT(std::max({a, b, c}), mesh.positions.size());
        const glm::dvec3 origin = mesh.positions[a];
        const glm::dvec3 area = glm::cross(glm::dvec3(mesh.positions[b]) - origin,
                                           glm::dvec3(mesh.positions[c]) - origin);
        degenerate += glm::length(area) > 1e-13 ? 0 : 1;
        const glm::dvec3 mean = mesh.normals[a] + mesh.normals[b] + mesh.normals[c];
        against += glm::dot(area, mean) > 0.0 ? 0 : 1;
    }
    EXPECT_EQ(degenerate, 0u);
    // A deep crease may tip a small facet over against its smoothed normal; more is a mistake.
    EXPECT_LE(against, mesh.indices.size() / 3 / 500);
}

TEST(MakeSceneGeometry, EveryMeshIsSound)
{
    for (const SceneInfo& info : listScenes()) {
        SCOPED_TRACE(info.name);
        const ReadScene scene = testing::generate(info.name);
        EXPECT_FALSE(scene.meshes.empty());
        EXPECT_FALSE(scene.cameras.empty());
        for (const std::string& camera : scene.cameras)
            EXPECT_FALSE(camera.empty());
        for (const ReadMesh& mesh : scene.meshes)
            checkMesh(mesh);
    }
}

void expectClosed(const std::string& sceneName, const std::set<std::string>& names)
{
    const ReadScene scene = testing::generate(sceneName);
    std::set<std::string> found;
    for (const ReadMesh& mesh : scene.meshes)
        if (names.contains(mesh.name)) {
            found.insert(mesh.name);
            EXPECT_EQ(openEdges(mesh), 0u) << mesh.name;
            EXPECT_GT(volume(mesh), 0.0) << mesh.name;
        }
    EXPECT_EQ(found, names);
}

TEST(MakeSceneGeometry, SolidsOfTheStillLifeAreClosed)
{
    expectClosed("still-life", {"carafe", "water", "bowl", "goblet", "apple", "pear", "orange",
                                "lemon", "stem", "grapes", "gold sphere", "copper sphere",
                                "car body", "car windows", "car tyres", "book cover", "table",
                                "soap bubble", "parapet"});
}

TEST(MakeSceneGeometry, SolidsOfTheRoomAreClosed)
{
    expectClosed("room", {"walls", "ceiling", "floor slab", "floor boards", "shelf", "lamp shade",
                          "lamp bulb", "globe", "mirror", "mirror frame", "pot", "window frame"});
}

TEST(MakeSceneGeometry, SolidsOfTheCorridorAreClosed)
{
    expectClosed("corridor", {"rib", "flame", "torch iron", "torch shaft", "door planks",
                              "door frame", "barrel", "barrel hoops", "crate"});
}

TEST(MakeSceneGeometry, TheThreeObjectsAreClosed)
{
    expectClosed("three-objects", {"pleated bulb", "low sphere", "high sphere"});
}

TEST(MakeSceneGeometry, StonesAndPostOfTheShoreAreClosed)
{
    expectClosed("shore", {"rock 1", "rock 2", "rock 3", "rock 4", "post"});
}

TEST(MakeSceneGeometry, TheGlassIsThickAndTheWaterIsInsideIt)
{
    const ReadScene scene = testing::generate("still-life");
    const ReadMesh *glass = nullptr, *water = nullptr;
    for (const ReadMesh& mesh : scene.meshes) {
        glass = mesh.name == "carafe" ? &mesh : glass;
        water = mesh.name == "water" ? &mesh : water;
    }
    ASSERT_TRUE(glass != nullptr && water != nullptr);
    EXPECT_NEAR(volume(*water), 1.3e-3, 0.4e-3);  // m^3: somewhat over a litre
    EXPECT_GT(volume(*glass), 1e-4);
    EXPECT_LT(volume(*glass), 5e-4);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(water->low[axis], glass->low[axis]);
        EXPECT_LT(water->high[axis], glass->high[axis]);
    }
}

TEST(MakeSceneGeometry, TheClosedSphereFacesInwards)
{
    for (const double subdivisions : {2.0, 32.0}) {
        const ReadScene scene =
            testing::generate("closed-sphere", {{"subdivisions", subdivisions}});
        const ReadMesh& shell = scene.meshes.at(0);
        EXPECT_EQ(openEdges(shell), 0u);
        EXPECT_EQ(shell.indices.size() / 3,
                  static_cast<std::size_t>(12 * subdivisions * subdivisions));
        EXPECT_LT(volume(shell), 0.0);
        EXPECT_GT(volume(shell), -4.18880);
        for (std::size_t i = 0; i < shell.positions.size(); ++i) {
            EXPECT_NEAR(glm::length(shell.positions[i]), 1.0f, 1e-5f);
            EXPECT_LT(glm::dot(shell.positions[i], shell.normals[i]), -0.5f);
        }
    }
}

}  // namespace
}  // namespace gp::make_scene
