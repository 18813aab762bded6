// In a uniform surrounding of radiance 1 a surface shows its albedo: white diffuse and lossless
// glass vanish, nothing is brighter than 1, and single scattering loses no more than is documented.
#include <functional>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class Furnace : public ::testing::TestWithParam<Variant> {};

GpCameraDesc frontCamera() { return lookFrom({0, 0, 0}, {0, 0, 1}, 3, 2.2f); }

TEST_P(Furnace, WhiteDiffuseSphereVanishes) {
    Stage stage(GetParam());
    Triangles t;
    t.sphere({0, 0, 0}, 1, 24, false, true);
    stage.add(t, stage.lambert(glm::vec3(1)));
    stage.surround(glm::vec3(1));
    const Picture picture = stage.render(16, 16, frontCamera(), stage.options(effort(64)));
    expectMean(picture, 1.0);
}

struct MaterialCase {
    const char* name;
    double least;  // of the whole sphere's mean
    std::function<void(GpMaterialDesc&)> change;
};

// The least values: what GGX without multiple scattering keeps, for metals by quadrature
// (glossy_test compares exactly) and a little less where layers lie above each other.
const MaterialCase materials[] = {
    {"smooth metal", 0.995,
     [](GpMaterialDesc& d) { d.metallic = 1, d.given |= GP_GIVEN_ROUGHNESS; }},
    {"half rough metal", 0.87, [](GpMaterialDesc& d) { d.metallic = 1, d.roughness = 0.5f; }},
    {"rough metal", 0.40, [](GpMaterialDesc& d) { d.metallic = 1, d.roughness = 1; }},
    {"rough dielectric", 0.90, [](GpMaterialDesc&) {}},
    {"smooth dielectric", 0.96, [](GpMaterialDesc& d) { d.roughness = 0.1f; }},
    {"coated", 0.90, [](GpMaterialDesc& d) { d.coat = 1; }},
    {"rough coat on metal", 0.60,
     [](GpMaterialDesc& d) {
         d.coat = 1, d.coatRoughness = 0.4f, d.metallic = 1, d.roughness = 0.3f;
     }},
    {"sheen", 0.80,
     [](GpMaterialDesc& d) { put(d.sheenColor, glm::vec3(1)), d.sheenRoughness = 0.5f; }},
    {"anisotropic metal", 0.69,
     [](GpMaterialDesc& d) { d.metallic = 1, d.roughness = 0.4f, d.anisotropy = 0.8f; }},
    {"iridescent", 0.80,
     [](GpMaterialDesc& d) {
         d.iridescence = 1;
         d.roughness = 0.3f;
     }},
    {"thin rough glass", 0.75, [](GpMaterialDesc& d) { d.transmission = 1, d.roughness = 0.4f; }},
    {"solid rough glass", 0.70,
     [](GpMaterialDesc& d) { d.transmission = 1, d.roughness = 0.3f, d.solid = 1; }},
    {"half transmissive", 0.70,
     [](GpMaterialDesc& d) { d.transmission = 0.5f, d.roughness = 0.6f; }},
};

TEST_P(Furnace, EveryMaterialReturnsAtMostWhatArrives) {
    for (const MaterialCase& row : materials) {
        Stage stage(GetParam());
        Triangles t;
        t.sphere({0, 0, 0}, 1, 24, false, true);
        GpMaterialDesc desc{};
        row.change(desc);
        stage.add(t, stage.material(desc));
        stage.surround(glm::vec3(1));
        GpRenderOptions o = stage.options(effort(96));
        o.maxBounces = 64;
        const Picture picture = stage.render(12, 12, frontCamera(), o);
        // pi / 4.84 of the picture is the sphere; the filter's width changes nothing for the mean.
        const double share = 3.14159265 / (2.2 * 2.2);
        for (int c = 0; c < 3; ++c) {
            const double onSphere = 1 + (picture.mean()[c] - 1) / share;
            const double sigma = picture.sigma()[c] / share;
            EXPECT_LT(onSphere, 1 + 4 * sigma + 2e-3) << row.name << " channel " << c;
            EXPECT_GT(onSphere, row.least - 4 * sigma) << row.name << " channel " << c;
            EXPECT_LT(sigma, 0.01) << row.name << ": too few samples";
        }
    }
}

class SmoothGlass : public Furnace {
protected:
    static Picture render(const Triangles& t, bool solid, bool roulette) {
        Stage stage(GetParam());
        GpMaterialDesc desc{};
        desc.given = GP_GIVEN_ROUGHNESS;  // smooth
        desc.transmission = 1;
        desc.solid = solid;
        stage.add(t, stage.material(desc));
        stage.surround(glm::vec3(1));
        GpRenderOptions o = stage.options(effort(64));
        o.maxBounces = 200;
        o.noRussianRoulette = !roulette;
        return stage.render(16, 16, frontCamera(), o);
    }
};

TEST_P(SmoothGlass, SolidSphereVanishes) {
    Triangles t;
    t.sphere({0, 0, 0}, 1, 32, false, true);
    expectMean(render(t, true, false), 1.0, "without roulette");
    expectMean(render(t, true, true), 1.0, "with roulette");
}

TEST_P(SmoothGlass, SolidBoxVanishes) {
    Triangles t;
    t.box({-0.8f, -0.7f, -0.6f}, {0.8f, 0.7f, 0.6f});
    expectMean(render(t, true, false), 1.0);
}

TEST_P(SmoothGlass, ThinSheetVanishes) {
    Triangles t;
    t.quad({-0.9f, -0.9f, 0.5f}, {1.8f, 0.2f, -1}, {0.1f, 1.8f, 0.2f});
    expectMean(render(t, false, true), 1.0);
}

INSTANTIATE_TEST_SUITE_P(All, Furnace, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });
INSTANTIATE_TEST_SUITE_P(All, SmoothGlass, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
