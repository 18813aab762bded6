// New texture coordinates for meshes of any kind: what was made with them from the start, tangents
// included, and nothing is built anew.
#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class TexCoords : public ::testing::TestWithParam<Variant> {
protected:
    // A ball with a bumpy surface, coordinates by longitude and latitude, flat or smooth.
    static Triangles ball(bool smooth, glm::vec2 scale, glm::vec2 offset) {
        Triangles t;
        t.sphere({0, 0, 0}, 1, 12, false, true);
        t.uv0.clear();
        for (const glm::vec3 p : t.positions)
            t.uv0.push_back(glm::vec2(p.x + 0.3f * p.z, p.y) * scale + offset);
        t.uv1 = t.uv0;
        if (!smooth) t.normals.clear();
        return t;
    }
    static GpMaterial bumpy(Stage& stage, uint32_t set) {
        const uint8_t normals[16] = {160, 128, 250, 255, 128, 160, 250, 255,
                                     96, 128, 250, 255, 128, 96, 250, 255};
        GpTextureDesc texture{};
        texture.width = texture.height = 2, texture.pixels = normals;
        texture.colorSpace = GP_COLOR_LINEAR;
        GpMaterialDesc d = lambertDesc({0.8f, 0.5f, 0.3f});
        d.normalTexture.texture = stage.texture(texture);
        d.normalTexture.texCoord = set;
        d.baseColorTexture = d.normalTexture;
        return stage.material(d);
    }
    static GpMesh add(Stage& stage, const Triangles& t, GpMeshKind kind, uint32_t set) {
        GpMeshDesc mesh = meshDesc(t, bumpy(stage, set));
        mesh.kind = kind;
        GpInstanceDesc instance{};
        instance.mesh = gpNewMesh(stage.device, &mesh);
        if (!instance.mesh || !gpNewInstance(stage.scene, &instance))
            stage.check(gpGetError(stage.device, nullptr));
        return instance.mesh;
    }
    static std::vector<glm::vec4> look(Stage& stage) {
        GpLightDesc sun{};
        sun.intensity = 3;
        put(sun.direction, {1, -1, -1});
        stage.light(sun);
        return stage.render(32, 32, lookFrom({0, 0, 0}, {0, 0, 1}, 4, 2.2f), stage.options(4))
            .color;
    }
};

TEST_P(TexCoords, AreThoseOfAMeshMadeWithThem) {
    for (const GpMeshKind kind : {GP_MESH_STATIC, GP_MESH_MOVABLE, GP_MESH_DYNAMIC})
        for (const uint32_t set : {0u, 1u})
            for (const bool smooth : {false, true}) {
                const Triangles old = ball(smooth, {1, 1}, {0, 0});
                const Triangles moved = ball(smooth, {2, -1.5f}, {0.25f, 0.1f});  // turned over
                Stage changed(GetParam()), fresh(GetParam());
                const GpMesh mesh = add(changed, old, kind, set);
                const auto before = look(changed);
                // Three floats apart, as in an application's vertices.
                std::vector<glm::vec3> spread;
                for (const glm::vec2 uv : moved.uv0) spread.emplace_back(uv, 9.0f);
                changed.check(gpUpdateTexCoords(mesh, set, &spread[0].x, sizeof spread[0]));
                Triangles expected = old;
                (set == 0 ? expected.uv0 : expected.uv1) = moved.uv0;
                add(fresh, expected, kind, set);
                look(fresh);  // the same number of suns
                const auto wanted = look(fresh), got = look(changed);
                EXPECT_NE(got, before);
                ASSERT_EQ(got.size(), wanted.size());
                // Normals of flat triangles are read back from 16 bits: no more than that differs.
                for (size_t i = 0; i < got.size(); ++i)
                    ASSERT_LT(glm::length(got[i] - wanted[i]), 2e-3f)
                        << "pixel " << i << ", kind " << kind << ", set " << set << smooth;
            }
}

TEST_P(TexCoords, NoneAreZeros) {
    const Triangles old = ball(true, {1, 1}, {0, 0});
    Triangles zeros = old;
    zeros.uv0.assign(zeros.uv0.size(), glm::vec2(0));
    Stage changed(GetParam()), fresh(GetParam());
    GpMaterialDesc d = lambertDesc(glm::vec3(1));
    const uint8_t pixels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 9};
    const auto show = [&](Stage& stage, const Triangles& t) {
        GpTextureDesc texture{};
        texture.width = texture.height = 2, texture.pixels = pixels;
        d.baseColorTexture.texture = stage.texture(texture);
        const GpMeshDesc mesh = meshDesc(t, stage.material(d));
        GpInstanceDesc instance{};
        instance.mesh = gpNewMesh(stage.device, &mesh);
        gpNewInstance(stage.scene, &instance);
        return instance.mesh;
    };
    const GpMesh mesh = show(changed, old);
    show(fresh, zeros);
    changed.check(gpUpdateTexCoords(mesh, 0, nullptr, 0));
    EXPECT_EQ(look(changed), look(fresh));
}

// 200,000 triangles of the best quality take much longer to build than to look at.
TEST_P(TexCoords, LeaveAccelerationStructuresAlone) {
    Stage stage(GetParam());
    Triangles t;
    t.sphere({0, 0, 0}, 1, 230, false, true);
    t.uv0.assign(t.positions.size(), glm::vec2(0.5f));
    GpMeshDesc mesh = meshDesc(t, stage.lambert(glm::vec3(0.5f)));
    GpInstanceDesc instance{};
    instance.mesh = gpNewMesh(stage.device, &mesh);
    gpNewInstance(stage.scene, &instance);
    const GpFrame frame = stage.frame(4, 4);
    const GpRenderOptions one = stage.options(1);
    const auto seconds = [&] {
        stage.check(gpRender(frame, stage.scene, nullptr, &one));
        GpFrameStatistics statistics{};
        stage.check(gpGetFrameStatistics(frame, &statistics));
        return statistics.secondsBuild;
    };
    const double whole = seconds();
    stage.check(gpUpdateTexCoords(instance.mesh, 0, &t.uv0[0].x, 0));
    EXPECT_LT(seconds(), whole / 10);
}

INSTANTIATE_TEST_SUITE_P(Best, TexCoords, ::testing::ValuesIn(bestFullVariant()),
                         [](const auto& i) { return variantName(i.param); });

}  // namespace
}  // namespace gp::test
