// Normals, tangents and the arrays that tracing reads.
#include "shading/shading.h"

#include <gtest/gtest.h>

#include "scene/scene.h"
#include "scene/tangents.h"

using namespace gp;

namespace {

glm::vec3 normalOf(const Mesh& m, uint32_t v) {
    return shading::octahedral_decode(m.vertices[v].normalOct);
}
glm::vec3 tangentOf(const Mesh& m, uint32_t v) {
    return shading::tangent_decode(m.vertices[v].tangentOct);
}
float signOf(const Mesh& m, uint32_t v) {
    return shading::tangent_decode_handedness(m.vertices[v].tangentOct);
}

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance = 1e-3f) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << " instead of "
                                             << b.x << " " << b.y << " " << b.z;
}

// A square facing +Z with the picture upright on it: v falls from 1 to 0 on the way up.
MeshData square() {
    MeshData d;
    d.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    d.normals.assign(4, {0, 0, 1});
    d.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    d.indices = {0, 1, 2, 0, 2, 3};
    return d;
}

Mesh filled(MeshData d, bool tangents) {
    Mesh m;
    MeshOptions options;
    options.needsTangents = tangents;
    fillMesh(m, std::move(d), options);
    EXPECT_EQ(m.positions.size(), m.vertexCount() + 1);
    return m;
}

}  // namespace

TEST(FillMesh, MissingNormalsAreFlat) {
    MeshData d;
    d.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    d.indices = {0, 2, 1, 0, 3, 2};
    d.uv[0] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    const Mesh m = filled(d, false);
    ASSERT_EQ(m.vertexCount(), 6u);  // no vertex is shared
    for (const glm::uvec3 t : m.triangles)
        for (int c = 0; c < 3; ++c)
            expectNear(normalOf(m, t[c]), t == m.triangles[0] ? glm::vec3(0, 0, -1)
                                                              : glm::vec3(-1, 0, 0));
    EXPECT_EQ(m.positions[m.triangles[1].y], glm::vec3(0, 0, 1));
    EXPECT_EQ(m.vertices[m.triangles[1].y].uv, glm::vec2(1, 1));
}

TEST(FillMesh, NormalsOfAnyLengthAndNone) {
    MeshData d = square();
    d.normals = {{0, 0, 1e-30f}, {0, 0, 1e30f}, {0, 0, 0}, {0, 3, 4}};
    const Mesh m = filled(d, false);
    expectNear(normalOf(m, 0), {0, 0, 1});
    expectNear(normalOf(m, 1), {0, 0, 1});
    expectNear(normalOf(m, 2), {0, 0, 1});  // from its triangles
    expectNear(normalOf(m, 3), {0, 0.6f, 0.8f});
}

TEST(FillMesh, DegenerateTrianglesHarmNothing) {
    MeshData d;
    d.positions = {{1, 1, 1},     {1, 1, 1},          {1, 1, 1},
                   {3e38f, 0, 0}, {-3e38f, 3e38f, 0}, {0, 0, 3e38f}};
    const Mesh m = filled(d, true);
    for (uint32_t v = 0; v < 6; ++v) EXPECT_NEAR(glm::length(normalOf(m, v)), 1, 1e-3);
}

TEST(FillMesh, ColorsAndSecondCoordinates) {
    MeshData d = square();
    d.colors.assign(4, {0.5f, 2.0f, -1.0f, 1.0f});
    d.uv[1].assign(4, {3, 4});
    const Mesh m = filled(d, false);
    EXPECT_EQ(m.colors[0], glm::u8vec4(128, 255, 0, 255));
    EXPECT_EQ(m.uv1[3], glm::vec2(3, 4));
    EXPECT_EQ(m.revision, 1u);
}

TEST(Tangents, UprightPicture) {
    const Mesh m = filled(square(), true);
    ASSERT_EQ(m.vertexCount(), 4u);  // nothing had to be split
    for (uint32_t v = 0; v < 4; ++v) {
        expectNear(tangentOf(m, v), {1, 0, 0});
        EXPECT_EQ(signOf(m, v), 1);  // bitangent = cross(+Z, +X) = +Y: up in the picture
    }
}

// What surface.glsl takes as "none", so that it looks at the texture coordinates.
TEST(Tangents, NoneAreZero) {
    const Mesh m = filled(square(), false);
    for (uint32_t v = 0; v < 4; ++v) EXPECT_EQ(m.vertices[v].tangentOct, 0u);
}

TEST(Tangents, GivenOnesAreKept) {
    MeshData d = square();
    d.tangents.assign(4, {0, 1, 0, -1});
    const Mesh m = filled(d, true);
    expectNear(tangentOf(m, 2), {0, 1, 0});
    EXPECT_EQ(signOf(m, 2), -1);
}

// Two squares side by side, the right one with the picture mirrored about their common edge.
TEST(Tangents, MirroredPicturesAreSplit) {
    MeshData d;
    d.positions = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    d.normals.assign(6, {0, 0, 1});
    d.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {0, 0}};
    d.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    const Mesh m = filled(d, true);
    EXPECT_EQ(m.vertexCount(), 8u);  // the two vertices of the edge exist twice
    for (size_t t = 0; t < 4; ++t)
        for (int c = 0; c < 3; ++c) {
            const uint32_t v = m.triangles[t][c];
            const float side = t < 2 ? 1.0f : -1.0f;
            expectNear(tangentOf(m, v), {side, 0, 0});
            EXPECT_EQ(signOf(m, v), side);
            // Whatever the side, the bitangent points up.
            expectNear(glm::cross(normalOf(m, v), tangentOf(m, v)) * signOf(m, v), {0, 1, 0});
        }
}

TEST(Tangents, FollowTheTransformOfTheTexture) {
    Mesh m;
    MeshOptions options;
    options.needsTangents = true;
    options.uvTransform = {0, -1, 1, 0, 0, 0};  // u' = v, v' = -u: turned by 90 degrees
    fillMesh(m, square(), options);
    expectNear(tangentOf(m, 0), {0, -1, 0});  // u' grows where v grows: downwards
    EXPECT_EQ(signOf(m, 0), 1);
}

TEST(Tangents, SmoothOverACurvedSurface) {
    // Half a cylinder around Y; seams where u is equal must not show.
    MeshData d;
    constexpr int columns = 33;
    for (int i = 0; i < columns; ++i) {
        const float a = float(i) / (columns - 1) * 3.14159265f;
        for (int j = 0; j < 2; ++j) {
            d.positions.push_back({-std::cos(a), float(j), std::sin(a)});
            d.normals.push_back({-std::cos(a), 0, std::sin(a)});
            d.uv[0].push_back({float(i) / (columns - 1), 1 - float(j)});
        }
    }
    for (uint32_t i = 0; i + 1 < columns; ++i) {
        const uint32_t v = i * 2;
        for (const uint32_t k : {v, v + 2, v + 3, v, v + 3, v + 1}) d.indices.push_back(k);
    }
    const Mesh m = filled(d, true);
    ASSERT_EQ(m.vertexCount(), size_t(columns) * 2);
    for (uint32_t v = 2; v + 2 < m.vertexCount(); ++v) {
        const glm::vec3 n = normalOf(m, v);
        expectNear(tangentOf(m, v), {n.z, 0, -n.x}, 2e-3f);
        EXPECT_EQ(signOf(m, v), 1);
    }
}

TEST(Tangents, WithoutAreaInTextureStillAFrame) {
    MeshData d = square();
    d.uv[0].assign(4, {0.5f, 0.5f});
    const Mesh m = filled(d, true);
    for (uint32_t v = 0; v < m.vertexCount(); ++v) {
        EXPECT_NEAR(glm::length(tangentOf(m, v)), 1, 1e-3);
        EXPECT_NEAR(glm::dot(tangentOf(m, v), normalOf(m, v)), 0, 1e-3);
    }
}

TEST(Bounds, OfTransformedInstances) {
    Scene scene;
    EXPECT_TRUE(worldBounds(scene).empty());
    auto mesh = std::make_shared<Mesh>(filled(square(), false));
    for (const float x : {0.0f, 10.0f}) {
        auto instance = std::make_shared<Instance>();
        instance->mesh = mesh;
        instance->worldFromObject = glm::mat4x3(0, 2, 0, -1, 0, 0, 0, 0, 1, x, 0, 5);
        scene.instances.push_back(instance);
    }
    const Bounds b = worldBounds(scene);
    expectNear(b.lo, {-1, 0, 5});
    expectNear(b.hi, {10, 2, 5});
}
