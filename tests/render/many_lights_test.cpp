// Ten thousand emissive quads over a plane: the sum of their closed forms, with much less noise
// than a choice without regard to distance would make. Textured emission.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

class ManyLights : public ::testing::TestWithParam<Variant> {
protected:
    ManyLights() : stage(GetParam()) {
        Triangles plane;
        plane.quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40});
        stage.add(plane, stage.lambert(glm::vec3(1)));
    }
    Picture look(uint32_t samples) {
        GpRenderOptions o = stage.options(effort(samples));
        o.maxBounces = GP_NO_BOUNCES;
        return stage.render(8, 8, lookFrom({0, 0, 0}, {0, 1, 0}, 0.1f, 1e-3f), o);
    }
    Stage stage;
};

TEST_P(ManyLights, MeanIsTheSumAndNoiseIsLow) {
    constexpr int side = 100, kinds = 4;
    constexpr float cell = 0.2f;
    Triangles lamps[kinds];
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> random(0, 1);
    double sum = 0, squares = 0;  // over all triangles
    for (int i = 0; i < side * side; ++i) {
        const float angle = 6.2831853f * random(generator),
                    half = cell * (0.1f + 0.24f * random(generator));
        const int kind = std::min(int(kinds * random(generator)), kinds - 1);
        const glm::vec3 u(2 * half * std::cos(angle), 0, 2 * half * std::sin(angle)),
            v(-u.z, 0, u.x);
        // All in one plane, so that none hides another.
        const glm::vec3 centre((float(i % side) - 49.5f) * cell, 1,
                               (float(i / side) - 49.5f) * cell);
        const glm::vec3 corner = centre - 0.5f * (u + v);
        lamps[kind].quad(corner, u, v);
        for (const glm::vec3 p : {u, v}) {
            const std::vector<glm::dvec3> triangle = {corner, corner + p, corner + u + v};
            const double e = polygonIrradiance(triangle, {0, 1, 0}) * (1 << kind);
            sum += e, squares += e * e;
        }
    }
    for (int kind = 0; kind < kinds; ++kind)
        stage.add(lamps[kind], stage.lambert(glm::vec3(0), glm::vec3(float(1 << kind))));
    const Picture p = look(4096);
    expectMean(p, sum / pi);
    // One of n triangles at random, its light times n: at least this variance of one sample.
    const double n = 2.0 * side * side, uniform = (n * squares - sum * sum) / (pi * pi);
    double variance = 0;
    for (const glm::vec4& v : p.variance)
        variance += double(v.x) * effort(4096) / double(p.variance.size());
    EXPECT_LT(variance, uniform / 8);
}

TEST_P(ManyLights, BlackPartsOfATextureSendNothing) {
    const uint8_t half[8] = {255, 255, 255, 255, 0, 0, 0, 255};
    GpTextureDesc texture{};
    texture.width = 2, texture.height = 1, texture.pixels = half;
    texture.magFilter = texture.minFilter = GP_FILTER_NEAREST;
    Triangles lamp;
    lamp.quad({-1.2f, 1, -0.4f}, {1.6f, 0, 0}, {0, 0, 1});
    GpMaterialDesc d = lambertDesc(glm::vec3(0));
    put(d.emission, {3, 2, 1});
    d.emissionTexture.texture = stage.texture(texture);
    stage.add(lamp, stage.material(d));
    const double form =
        polygonIrradiance(quadPolygon({-1.2, 1, -0.4}, {0.8, 0, 0}, {0, 0, 1}), {0, 1, 0});
    expectMean(look(4096), glm::dvec3(3, 2, 1) * form / pi);
}

INSTANTIATE_TEST_SUITE_P(Best, ManyLights, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
