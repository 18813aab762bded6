// New coordinates on a mesh whose vertices were split, flattened, or would have to be split anew.
#include <gtest/gtest.h>

#include "scene/mesh.h"
#include "shading/shading.h"

namespace gp {
namespace {

// Two triangles that share an edge; `mirrored` lets the texture run back in the second.
MeshData hinge(bool normals, bool mirrored) {
    MeshData data;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}};
    if (normals) data.normals.assign(4, {0, 0, 1});
    data.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {mirrored ? 0.0f : 2.0f, 1}};
    data.indices = {0, 1, 2, 1, 3, 2};
    return data;
}

Mesh meshOf(MeshData&& data) {
    Mesh mesh;
    MeshOptions options;
    options.needsTangents = options.updatable = true;
    fillMesh(mesh, std::move(data), options);
    return mesh;
}

// What shading reads at each corner, whichever vertices hold it.
void expectSameCorners(const Mesh& a, const Mesh& b) {
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    for (size_t t = 0; t < a.triangles.size(); ++t)
        for (int c = 0; c < 3; ++c) {
            const ShadingVertex &x = a.vertices[a.triangles[t][c]],
                                &y = b.vertices[b.triangles[t][c]];
            EXPECT_EQ(x.uv, y.uv) << t << ", " << c;
            EXPECT_EQ(x.tangentOct, y.tangentOct) << t << ", " << c;
            EXPECT_NE(x.tangentOct, 0u);
        }
}

std::vector<glm::vec2> turned(std::vector<glm::vec2> uv) {
    for (glm::vec2& p : uv) p = {0.5f * p.y, 0.3f - p.x};
    return uv;
}

TEST(TexCoords, FollowFlatAndSplitVertices) {
    for (const bool normals : {false, true})
        for (const bool mirrored : {false, true}) {
            Mesh changed = meshOf(hinge(normals, mirrored));
            EXPECT_EQ(changed.vertexCount(), !normals ? 6u : mirrored ? 6u : 4u);
            MeshData fresh = hinge(normals, mirrored);
            fresh.uv[0] = turned(fresh.uv[0]);
            const auto triangles = changed.triangles;
            const auto* positions = changed.positions.data();
            updateTexCoords(changed, 0, fresh.uv[0]);
            EXPECT_EQ(changed.triangles, triangles);  // acceleration structures read both
            EXPECT_EQ(changed.positions.data(), positions);
            expectSameCorners(changed, meshOf(std::move(fresh)));
        }
}

// Each triangle takes its own tangents where one vertex would need two.
TEST(TexCoords, LeaveTangentsToTheKernelsWhereAVertexWouldNeedTwo) {
    Mesh changed = meshOf(hinge(true, false));
    updateTexCoords(changed, 0, hinge(true, true).uv[0]);
    for (const ShadingVertex& v : changed.vertices) EXPECT_EQ(v.tangentOct, 0u);
    updateTexCoords(changed, 0, hinge(true, false).uv[0]);  // and back
    expectSameCorners(changed, meshOf(hinge(true, false)));
}

// As a texture that scrolls has them, over hours: nothing turns.
TEST(TexCoords, KeepTangentsWhereTheyMoveAsAWhole) {
    for (const uint32_t set : {0u, 1u}) {
        MeshData data = hinge(true, true);
        // Small and slanted: far from the origin rounding turns what is computed from differences.
        for (glm::vec2& p : data.uv[0]) p = glm::mat2(0.83f, 0.37f, -0.31f, 0.9f) * p / 90.0f;
        data.uv[1] = data.uv[0];
        Mesh mesh;
        MeshOptions options;
        options.needsTangents = options.updatable = true, options.tangentUv = set;
        fillMesh(mesh, MeshData(data), options);
        const std::vector<ShadingVertex> before = mesh.vertices;
        for (const float step : {0.1f, 0.7f, 33.3f, 2000.7f}) {
            auto uv = data.uv[0];
            for (glm::vec2& p : uv) p += glm::vec2(step, -0.3f * step);
            updateTexCoords(mesh, set, uv);
            for (size_t v = 0; v < mesh.vertexCount(); ++v) {
                EXPECT_EQ(mesh.vertices[v].tangentOct, before[v].tangentOct) << step;
                const glm::vec2 now = set == 0 ? mesh.vertices[v].uv : mesh.uv1[v];
                EXPECT_EQ(now, uv[v < 4 ? v : mesh.givenVertex[v]]);
            }
        }
    }
}

TEST(TexCoords, KeepGivenTangentsAndThoseOfTheOtherSet) {
    MeshData given = hinge(true, false);
    given.tangents.assign(4, {0, 1, 0, -1});
    Mesh mesh = meshOf(std::move(given));
    const uint32_t before = mesh.vertices[0].tangentOct;
    updateTexCoords(mesh, 0, turned(hinge(true, false).uv[0]));
    EXPECT_EQ(mesh.vertices[0].tangentOct, before);
    EXPECT_EQ(mesh.vertices[3].uv, glm::vec2(0.5f, 0.3f - 2));

    Mesh other = meshOf(hinge(true, true));  // six vertices of four
    const uint32_t of = other.vertices[0].tangentOct;
    updateTexCoords(other, 1, {{5, 0}, {6, 0}, {7, 0}, {8, 0}});
    EXPECT_EQ(other.vertices[0].tangentOct, of);
    ASSERT_EQ(other.uv1.size(), 6u);
    for (size_t v = 0; v < 6; ++v)
        EXPECT_EQ(other.uv1[v].x, 5 + float(v < 4 ? v : other.givenVertex[v]));
    updateTexCoords(other, 1, {});
    EXPECT_TRUE(other.uv1.empty());
}

}  // namespace
}  // namespace gp
