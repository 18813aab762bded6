// Backs and mirror images: a transform of negative determinant shows the mirrored object, its lamps
// shine from the same side, its normals and normal maps turn with it.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class Mirrored : public ::testing::TestWithParam<Variant> {};

// A lamp, a smooth lump and a slanted plate with a normal map, without any symmetry.
void furnish(Stage& stage, bool byTransform) {
    const float flip = byTransform ? 1.0f : -1.0f;
    const float mirror[12] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const uint8_t bumps[16] = {200, 128, 220, 255, 128, 60,  220, 255,
                               90,  150, 230, 255, 128, 128, 255, 255};
    const auto add = [&](Triangles t, GpMaterial m) {
        if (!byTransform) {  // mirrored by hand: x negated, the winding turned
            for (glm::vec3& p : t.positions) p.x *= flip;
            for (glm::vec3& n : t.normals) n.x *= flip;
            for (size_t i = 0; i < t.positions.size(); i += 3) {
                std::swap(t.positions[i + 1], t.positions[i + 2]);
                if (!t.normals.empty()) std::swap(t.normals[i + 1], t.normals[i + 2]);
                if (!t.uv0.empty()) std::swap(t.uv0[i + 1], t.uv0[i + 2]);
            }
        }
        stage.add(t, m, 0, byTransform ? mirror : nullptr);
    };
    Triangles lamp, lump, plate;
    lamp.quad({0.2f, 1.5f, 0}, {0.8f, 0.3f, 0}, {0, 0.1f, 0.9f});
    lump.sphere({-0.5f, 0, 0.1f}, 0.5f, 8, false, true);
    plate.quad({0, -0.8f, 0.2f}, {0.9f, 0.1f, -0.3f}, {0.2f, 0.9f, -0.2f});
    GpTextureDesc texture{};
    texture.width = texture.height = 2, texture.pixels = bumps,
    texture.colorSpace = GP_COLOR_LINEAR;
    texture.noMipmaps = 1;
    GpMaterialDesc bumpy = lambertDesc(glm::vec3(0.8f));
    bumpy.normalTexture.texture = stage.texture(texture);
    GpMaterialDesc glow = lambertDesc(glm::vec3(0));
    put(glow.emission, {8, 6, 4});
    glow.emissionTexture.texture = bumpy.normalTexture.texture;
    add(lamp, stage.material(glow));
    add(lump, stage.lambert({0.9f, 0.5f, 0.4f}));
    add(plate, stage.material(bumpy));
}

TEST_P(Mirrored, TransformsAndMirroredMeshesAreTheSame) {
    Picture pictures[2];
    for (const int byTransform : {0, 1}) {
        Stage stage(GetParam());
        furnish(stage, byTransform == 1);
        GpCameraDesc c{};
        put(c.position, {0.3f, 0.2f, 4});
        c.verticalFov = 0.6f;
        GpRenderOptions o = stage.options(effort(2048));
        o.seed = uint64_t(byTransform);
        pictures[byTransform] = stage.render(16, 16, c, o);
    }
    const Picture &a = pictures[0], &b = pictures[1];
    double lit = 0;
    for (size_t i = 0; i < a.color.size(); ++i) {
        const double sigma = std::sqrt(double(a.variance[i].x + b.variance[i].x));
        EXPECT_NEAR(a.color[i].x, b.color[i].x, 5 * sigma + 1e-4) << i;
        lit += a.color[i].x > 0.01f;
    }
    EXPECT_GT(lit, 40);
    expectMean(a, b.mean());
}

// Opaque surfaces reflect on both sides alike.
TEST_P(Mirrored, BacksReflectAsFrontsDo) {
    for (const bool turned : {false, true}) {
        Stage stage(GetParam());
        Triangles t;
        if (turned)
            t.quad({-1, -1, 0}, {0, 2, 0}, {2, 0, 0});
        else
            t.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        stage.add(t, stage.lambert({0.7f, 0.5f, 0.3f}));
        GpLightDesc sun{};
        sun.intensity = 2;
        put(sun.direction, {0, 0.6f, -0.8f});
        stage.light(sun);
        expectMean(stage.render(4, 4, lookFrom({0, 0, 0}, {0, 0, 1}, 1, 0.5f), stage.options(4)),
                   glm::dvec3(0.7, 0.5, 0.3) * (2 * 0.8 / 3.14159265358979),
                   turned ? "back" : "front");
    }
}

INSTANTIATE_TEST_SUITE_P(All, Mirrored, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
