// A scene that changed is the scene that was made so from the start, to the bit.
#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class Changes : public ::testing::TestWithParam<Variant> {};

struct Moving {
    Triangles first, second;
    Moving() {
        first.sphere({-0.4f, 0, 0}, 0.4f, 8, false, true);
        first.uv0.clear();
        second.sphere({0.3f, 0.2f, 0.1f}, 0.6f, 10, false, true);  // more triangles than before
        second.uv0.clear();
    }
};

GpMesh newDynamicMesh(Stage& stage, const Triangles& t) {
    GpMeshDesc desc = meshDesc(t, stage.lambert({0.8f, 0.4f, 0.2f}));
    desc.kind = GP_MESH_DYNAMIC;
    const GpMesh mesh = gpNewMesh(stage.device, &desc);
    if (!mesh) stage.check(gpGetError(stage.device, nullptr));
    return mesh;
}

void show(Stage& stage, GpMesh mesh, bool asGlass) {
    GpInstanceDesc desc{};
    desc.mesh = mesh;
    if (asGlass) {  // half of the rays pass: the mesh is traced with its alpha filter from now on
        GpMaterialDesc d = lambertDesc(glm::vec3(0.5f));
        d.alphaMode = GP_ALPHA_BLEND;
        d.baseColor[3] = 0.5f;
        desc.material = stage.material(d);
        const float aside[12] = {1, 0, 0, 0.5f, 0, 1, 0, -0.5f, 0, 0, 1, 0.8f};
        std::copy_n(aside, 12, desc.worldFromObject);
    }
    if (!gpNewInstance(stage.scene, &desc)) stage.check(gpGetError(stage.device, nullptr));
}

std::vector<glm::vec4> look(Stage& stage) {
    stage.surround(glm::vec3(1));
    return stage.render(24, 24, lookFrom({0, 0, 0}, {0, 0, 1}, 4, 3), stage.options(8)).color;
}

TEST_P(Changes, ADynamicMeshWithNewVertices) {
    const Moving m;
    Stage fresh(GetParam());
    const GpMesh whole = newDynamicMesh(fresh, m.second);
    show(fresh, whole, false), show(fresh, whole, true);

    Stage stage(GetParam());
    const GpMesh mesh = newDynamicMesh(stage, m.first);
    show(stage, mesh, false);
    const std::vector<glm::vec4> before = look(stage);
    const GpMeshDesc moved = meshDesc(m.second, nullptr);
    stage.check(gpUpdateMesh(mesh, &moved));
    show(stage, mesh, true);  // at once with the new vertices: one build, with the filter
    const std::vector<glm::vec4> after = look(stage);
    EXPECT_EQ(after, look(fresh));
    EXPECT_NE(after, before);
    EXPECT_EQ(after, look(stage));  // and nothing more changes by itself
}

INSTANTIATE_TEST_SUITE_P(Best, Changes, ::testing::ValuesIn(bestFullVariant()),
                         [](const auto& i) { return variantName(i.param); });

}  // namespace
}  // namespace gp::test
