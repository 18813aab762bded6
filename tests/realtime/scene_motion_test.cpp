// SceneMotion by itself: which instance of the last frame an instance is.
#include <cmath>

#include <gtest/gtest.h>

#include "frame/scene_motion.h"

namespace gp {
namespace {

std::shared_ptr<Mesh> mesh(MeshKind kind, float x = 0, uint32_t triangles = 1) {
    auto m = std::make_shared<Mesh>();
    m->kind = kind;
    m->material = std::make_shared<Material>();
    for (uint32_t i = 0; i < triangles; ++i) {
        for (glm::vec3 p : {glm::vec3(x, 0, 0), glm::vec3(x + 1, 0, 0), glm::vec3(x, 1, 0)})
            m->positions.push_back(p);
        m->triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return m;
}

std::shared_ptr<Instance> instance(std::shared_ptr<Mesh> m, uint64_t id, float x) {
    auto i = std::make_shared<Instance>();
    i->mesh = std::move(m);
    i->id = id;
    i->worldFromObject[3] = {x, 0, 0};
    return i;
}

float previousX(const SceneMotion& motion, size_t i) {
    return motion.instances()[i].world_from_object[0].w;
}

TEST(SceneMotion, FindsIdsInAnotherOrderAndAsOtherObjects) {
    const auto m = mesh(MeshKind::movable);
    Scene scene;
    for (uint64_t id : {11, 12, 13}) scene.instances.push_back(instance(m, id, float(id)));
    SceneMotion motion;
    motion.compare(scene, makeLightTable(scene));
    for (const auto& p : motion.instances()) EXPECT_EQ(p.index, NO_INDEX);  // nothing before
    motion.remember(scene, makeLightTable(scene));

    Scene next;
    for (uint64_t id : {13, 14, 11}) next.instances.push_back(instance(m, id, 0));
    motion.compare(next, makeLightTable(next));
    EXPECT_EQ(motion.instances()[0].index, 2u);
    EXPECT_EQ(motion.instances()[1].index, NO_INDEX);  // 14 is new
    EXPECT_EQ(motion.instances()[2].index, 0u);
    EXPECT_EQ(previousX(motion, 0), 13);
    EXPECT_EQ(previousX(motion, 2), 11);
    EXPECT_EQ(motion.currentOfPrevious(), (std::vector<uint32_t>{2, NO_INDEX, 0}));  // 12 is gone
}

TEST(SceneMotion, ObjectsWithoutIdAreThemselves) {
    const auto m = mesh(MeshKind::movable);
    Scene scene;
    scene.instances = {instance(m, 0, 1), instance(m, 0, 2)};
    SceneMotion motion;
    motion.remember(scene, makeLightTable(scene));
    std::swap(scene.instances[0], scene.instances[1]);
    scene.instances[0]->worldFromObject[3].x = 5;
    scene.instances.push_back(instance(m, 0, 3));
    motion.compare(scene, makeLightTable(scene));
    EXPECT_EQ(motion.instances()[0].index, 1u);
    EXPECT_EQ(motion.instances()[1].index, 0u);
    EXPECT_EQ(motion.instances()[2].index, NO_INDEX);
    EXPECT_EQ(previousX(motion, 0), 2);  // where it was, not where it is
}

TEST(SceneMotion, KeepsTheVerticesOfDynamicMeshes) {
    const auto m = mesh(MeshKind::dynamic);
    Scene scene;
    scene.instances = {instance(m, 7, 0)};
    SceneMotion motion;
    motion.remember(scene, makeLightTable(scene));
    m->positions[1].x = 100, ++m->revision;
    motion.compare(scene, makeLightTable(scene));
    ASSERT_NE(motion.positions()[0], nullptr);
    EXPECT_EQ(motion.positions()[0][1].x, 1);
    motion.remember(scene, makeLightTable(scene));
    motion.compare(scene, makeLightTable(scene));  // nothing moved since
    EXPECT_EQ(motion.positions()[0][1].x, 100);
    // Triangles that join other vertices say nothing about where corners were.
    ++m->revision, ++m->topologyRevision;
    motion.compare(scene, makeLightTable(scene));
    EXPECT_EQ(motion.instances()[0].index, NO_INDEX);
}

TEST(SceneMotion, AnotherMeshUnderTheSameIdIsItsSuccessor) {
    Scene scene;
    scene.instances = {instance(mesh(MeshKind::dynamic, 4), 7, 0)};
    SceneMotion motion;
    motion.remember(scene, makeLightTable(scene));
    scene.instances = {instance(mesh(MeshKind::dynamic, 5), 7, 0)};
    motion.compare(scene, makeLightTable(scene));
    ASSERT_NE(motion.positions()[0], nullptr);
    EXPECT_EQ(motion.positions()[0][0].x, 4);
    scene.instances = {instance(mesh(MeshKind::dynamic, 5, 2), 7, 0)};  // not of the same triangles
    motion.compare(scene, makeLightTable(scene));
    EXPECT_EQ(motion.instances()[0].index, NO_INDEX);
}

TEST(SceneMotion, FollowsLightsByIdObjectAndInstance) {
    const auto light = [](uint64_t id) {
        auto l = std::make_shared<Light>();
        l->kind = LightKind::sphere, l->id = id;
        return l;
    };
    auto glowing = std::make_shared<Material>();
    glowing->emission = glm::vec3(1);
    const auto lamp = mesh(MeshKind::movable, 0, 2);
    lamp->material = glowing;
    Scene scene;
    scene.revision = 1;
    scene.instances = {instance(mesh(MeshKind::movable), 1, 0), instance(lamp, 2, 0)};
    scene.lights = {light(5), light(0), light(6)};
    SceneMotion motion;
    motion.remember(scene, makeLightTable(scene));
    motion.compare(scene, makeLightTable(scene));
    EXPECT_EQ(motion.currentLightOfPrevious(), (std::vector<uint32_t>{0, 1, 2, 3, 4}));

    Scene next;
    next.revision = 2;
    next.instances = {scene.instances[1], scene.instances[0]};
    next.lights = {light(6), scene.lights[1], light(7), light(8)};  // 5 went out
    motion.compare(next, makeLightTable(next));
    EXPECT_EQ(motion.currentLightOfPrevious(), (std::vector<uint32_t>{NO_INDEX, 1, 0, 4, 5}));
}

// A polygon is as many lights as it has triangles; each finds itself again, or is gone.
TEST(SceneMotion, FindsTheTrianglesOfPolygonalLights) {
    const auto polygon = [](uint64_t id, size_t corners) {
        auto light = std::make_shared<Light>();
        light->id = id, light->kind = LightKind::polygon;
        for (size_t i = 0; i < corners; ++i) {
            const float a = 6.2831853f * float(i) / float(corners);
            light->corners.emplace_back(std::cos(a), std::sin(a), 0);
        }
        return light;
    };
    Scene scene;
    scene.lights = {polygon(1, 5), polygon(2, 4), polygon(0, 3)};  // 3, 2 and 1 triangles
    SceneMotion motion;
    motion.remember(scene, makeLightTable(scene));
    ++scene.revision;
    scene.lights = {polygon(2, 4), scene.lights[2], polygon(1, 4)};
    motion.compare(scene, makeLightTable(scene));
    EXPECT_EQ(motion.currentLightOfPrevious(),
              (std::vector<uint32_t>{3, 4, NO_INDEX, 0, 1, 2}));
}

TEST(SceneMotion, ForgetsOnDemand) {
    Scene scene;
    scene.instances = {instance(mesh(MeshKind::staticMesh), 7, 0)};
    SceneMotion motion;
    motion.remember(scene, makeLightTable(scene));
    motion.forget();
    motion.compare(scene, makeLightTable(scene));
    EXPECT_EQ(motion.instances()[0].index, NO_INDEX);
}

}  // namespace
}  // namespace gp
