// The camera that frames a scene: everything is in the picture, and the picture is filled.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/sky.h"

namespace gp {
namespace {

// One instance of a mesh that is just the two corners of a box.
Scene sceneOf(const glm::vec3& lo, const glm::vec3& hi) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {lo, hi, hi, glm::vec3(0)};
    mesh->vertices.resize(3);
    mesh->triangles = {{0, 1, 2}};
    mesh->material = std::make_shared<Material>();
    Scene scene;
    scene.instances.push_back(std::make_shared<Instance>());
    scene.instances[0]->mesh = mesh;
    return scene;
}

struct Extent {
    double x = 0, y = 0;   // largest |coordinate| in the picture; 1 is its edge
    double nearest = 1e30; // along the view
};

Extent project(const Camera& camera, const glm::vec3& lo, const glm::vec3& hi, double aspect) {
    const glm::dvec3 eye(camera.position);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double tanY = std::tan(camera.verticalFov / 2.0);
    Extent extent;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z);
        const glm::dvec3 v = corner - eye;
        const double depth = glm::dot(v, forward);
        extent.nearest = std::min(extent.nearest, depth);
        extent.x = std::max(extent.x, std::abs(glm::dot(v, right)) / (depth * tanY * aspect));
        extent.y = std::max(extent.y, std::abs(glm::dot(v, up)) / (depth * tanY));
    }
    return extent;
}

TEST(FrameScene, EverythingIsInThePictureAndFillsIt) {
    const glm::vec3 boxes[][2] = {{{-1, -1, -1}, {1, 1, 1}},
                                  {{100, 5, -3}, {101, 25, -2}},
                                  {{-50, 0, -50}, {50, 1, 50}},
                                  {{-1e-3f, 0, 0}, {1e-3f, 1e-3f, 2e-3f}},
                                  {{0, 0, -1000}, {1, 1, 1000}}};
    for (const auto& box : boxes)
        for (double aspect : {0.5, 1.0, 16.0 / 9, 4.0}) {
            const Camera camera = frameScene(sceneOf(box[0], box[1]), float(aspect));
            const Extent extent = project(camera, box[0], box[1], aspect);
            EXPECT_GT(extent.nearest, 0);
            EXPECT_LE(extent.x, 1);
            EXPECT_LE(extent.y, 1);
            EXPECT_GT(std::max(extent.x, extent.y), 0.9) << "needlessly far away";
        }
}

TEST(FrameScene, FromTheFrontALittleFromAboveAndTheRight) {
    const Camera camera = frameScene(sceneOf({-1, -1, -1}, {1, 1, 1}), 1);
    const glm::vec3 back = glm::normalize(camera.position - camera.target);
    EXPECT_GT(back.z, 0.8);
    EXPECT_GT(back.y, 0.1);
    EXPECT_LT(back.y, 0.5);
    EXPECT_GT(back.x, 0.1);
    EXPECT_EQ(camera.up, glm::vec3(0, 1, 0));
}

TEST(FrameScene, EmptyAndPointLikeScenesAreSafe) {
    const glm::vec3 points[] = {{0, 0, 0}, {7, -2, 1e6f}};
    for (const glm::vec3& point : points) {
        const Camera camera = frameScene(sceneOf(point, point), 1);
        EXPECT_TRUE(std::isfinite(glm::length(camera.position)));
        EXPECT_NE(camera.position, camera.target);
    }
    const Camera camera = frameScene(Scene{}, 1.5f);
    EXPECT_TRUE(std::isfinite(glm::length(camera.position)));
    EXPECT_NE(camera.position, camera.target);
}

}  // namespace
}  // namespace gp
