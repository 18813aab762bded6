// The sea of a scene: what its triangles stand for, and what is told of its surface.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/sea.h"

namespace gp {
namespace {

SeaSettings smallSea() {
    SeaSettings s;
    s.waves.windSpeed = 7;
    s.waves.size = 64;
    s.sectors = 32;
    s.level = 2;
    return s;
}

Camera cameraAt(glm::vec3 position) {
    Camera camera;
    camera.position = position;
    camera.target = position + glm::vec3(0, 0, -1);
    return camera;
}

TEST(Sea, IsPlacedAnewOnlyWhenSomethingChanged) {
    Sea sea(smallSea());
    const Camera here = cameraAt({3, 5, 4}), there = cameraAt({9, 5, 4});
    EXPECT_TRUE(sea.place(here, false));
    EXPECT_FALSE(sea.place(here, false));
    const uint64_t revision = sea.instance()->mesh->revision;
    sea.setTime(0);
    EXPECT_FALSE(sea.place(here, false));
    sea.setTime(1);
    EXPECT_TRUE(sea.place(here, false));
    EXPECT_TRUE(sea.place(there, false));
    EXPECT_EQ(sea.instance()->mesh->revision, revision + 2);
}

TEST(Sea, KnowsWhereItsPointsWere) {
    Sea sea(smallSea()), past(smallSea());
    const Camera here = cameraAt({3, 5, 4}), there = cameraAt({9, 6, 1});
    sea.setTime(10), past.setTime(10);
    sea.place(here, true);
    sea.setTime(10.25);
    sea.place(there, true);
    past.place(there, true);  // the same vertices, at the time before
    const Mesh& mesh = *sea.instance()->mesh;
    EXPECT_EQ(mesh.beforeRevision + 1, mesh.revision);
    EXPECT_EQ(mesh.before, past.instance()->mesh->positions);
    EXPECT_NE(mesh.positions, mesh.before);
    // The camera alone: nothing moved.
    sea.place(here, true);
    EXPECT_EQ(mesh.positions, mesh.before);
    sea.place(there, false);
    EXPECT_TRUE(mesh.before.empty());
}

TEST(Sea, TextureCoordinatesAreThePointsAtRest) {
    Sea sea(smallSea());
    sea.setTime(3);
    sea.place(cameraAt({30, 4, -20}), false);
    const Mesh& mesh = *sea.instance()->mesh;
    ASSERT_EQ(mesh.positions.size(), mesh.vertexCount() + 1);
    const glm::vec2 rest = mesh.vertices[0].uv;
    EXPECT_EQ(rest, glm::vec2(30, 20));
    for (size_t i = 0; i < 200; i += 7) {
        // Of the innermost rings, whose cells are finer than any wave of this sea.
        const glm::vec3 d = sea.ocean().displacement(mesh.vertices[i].uv);
        const glm::vec3 expected(mesh.vertices[i].uv.x + d.x, 2 + d.z,
                                 -(mesh.vertices[i].uv.y + d.y));
        EXPECT_NEAR(mesh.positions[i].y, expected.y, 0.02) << i;
        EXPECT_NEAR(mesh.positions[i].x, expected.x, 0.02) << i;
        EXPECT_NEAR(mesh.positions[i].z, expected.z, 0.02) << i;
    }
}

TEST(Sea, TellsItsSurfaceAboveAnyPoint) {
    Sea sea(smallSea());
    sea.setTime(21);
    for (int i = 0; i < 100; ++i) {
        const glm::vec2 rest(2.37f * float(i), 71 - 1.73f * float(i));
        const glm::vec3 d = sea.ocean().displacement(rest);
        const SeaPoint point = sea.at(rest.x + d.x, -(rest.y + d.y));
        EXPECT_NEAR(point.height, 2 + d.z, 2e-3) << i;
        EXPECT_NEAR(glm::length(point.normal), 1, 1e-5);
    }
}

// By the waves at the camera, not by the level.
TEST(Sea, KnowsWhoIsBelow) {
    Sea sea(smallSea());
    sea.setTime(3);
    int crests = 0;
    for (int i = 0; i < 40; ++i) {
        const float x = 1.7f * float(i), height = sea.at(x, 5).height;
        crests += height > sea.settings().level ? 1 : 0;
        EXPECT_FALSE(sea.isBelow(cameraAt({x, height + 1e-3f, 5}))) << x;
        EXPECT_TRUE(sea.isBelow(cameraAt({x, height - 1e-3f, 5}))) << x;
    }
    EXPECT_GT(crests, 5);
    EXPECT_LT(crests, 35);
    Camera parallel = cameraAt({0, -50, 5});
    parallel.kind = CameraKind::orthographic;
    EXPECT_FALSE(sea.isBelow(parallel));
}

TEST(Sea, NormalsAreThoseOfTheHeightsAround) {
    SeaSettings settings = smallSea();
    // Only waves of 20 m and more: several points of the grid in each.
    settings.waves.size = 256, settings.waves.cascades = 1, settings.waves.windSpeed = 14;
    Sea sea(settings);
    sea.setTime(21);
    double slopes = 0, errors = 0;
    for (int i = 0; i < 100; ++i) {
        const float x = 3.37f * float(i), z = 7.73f * float(i) - 71;
        const SeaPoint point = sea.at(x, z);
        const float step = 1;
        slopes += double(std::hypot(point.normal.x, point.normal.z) / point.normal.y) / 100;
        const float dx = (sea.at(x + step, z).height - sea.at(x - step, z).height) / (2 * step);
        const float dz = (sea.at(x, z + step).height - sea.at(x, z - step).height) / (2 * step);
        errors += double(std::hypot(point.normal.x / point.normal.y + dx,
                                    point.normal.z / point.normal.y + dz)) / 100;
    }
    // Heights are interpolated as slopes are, each between its own grid points.
    EXPECT_GT(slopes, 0.03);
    EXPECT_LT(errors, 0.25 * slopes);
}

}  // namespace
}  // namespace gp
