// Inside of a closed surface that reflects the share a of all light and emits e, the radiance is
// the same everywhere and in all directions: e + a e + a^2 e + ... = e / (1 - a), for any shape.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class ClosedSphere : public ::testing::TestWithParam<Variant> {
protected:
    static Picture render(glm::vec3 albedo, glm::vec3 emission, int32_t maxBounces, bool roulette,
                          uint32_t samples) {
        Stage stage(GetParam());
        Triangles t;
        t.sphere(glm::vec3(1, 2, 3), 2, 12, true, false);
        stage.add(t, stage.lambert(albedo, emission));
        GpCameraDesc camera{};
        put(camera.position, {1.3f, 2.2f, 2.9f});
        put(camera.target, {0, 1.5f, 4});
        camera.verticalFov = 1.5f;
        GpRenderOptions o = stage.options(effort(samples));
        o.maxBounces = maxBounces;
        o.noRussianRoulette = !roulette;
        return stage.render(8, 8, camera, o);
    }
};

class DeepClosedSphere : public ClosedSphere {};

TEST_P(DeepClosedSphere, Roulette) {
    expectMean(render({0.2f, 0.5f, 0.8f}, {1, 2, 0.5f}, 2000, true, 2000),
               {1 / 0.8, 2 / 0.5, 0.5 / 0.2});
}

TEST_P(DeepClosedSphere, NoRoulette) {
    expectMean(render({0, 0.4f, 0.7f}, glm::vec3(1), 60, false, 96), {1, 1 / 0.6, 1 / 0.3});
}

// The camera's own surface is no bounce, and what arrives after bounce n + 1 counts (light that
// arrives directly is always there): the terms 0 to n + 1 of the series.
TEST_P(ClosedSphere, EndsAfterTheGivenBounces) {
    const double a = 0.75, e = 2;
    for (const int n : {0, 1, 2, 5}) {
        const int option = n == 0 ? GP_NO_BOUNCES : n;
        const double expected = e * (1 - std::pow(a, n + 2)) / (1 - a);
        expectMean(render(glm::vec3(float(a)), glm::vec3(float(e)), option, false, 96), expected,
                   "bounces " + std::to_string(n));
    }
}

TEST_P(DeepClosedSphere, RouletteKeepsTheGivenBounces) {
    expectMean(render(glm::vec3(0.75f), glm::vec3(2), 5, true, 640), 8 * (1 - std::pow(0.75, 7)));
}

TEST_P(ClosedSphere, SixteenBouncesAreTheDefault) {
    expectMean(render(glm::vec3(0.9f), glm::vec3(1), 0, false, 96), (1 - std::pow(0.9, 18)) / 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, ClosedSphere, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });
INSTANTIATE_TEST_SUITE_P(Best, DeepClosedSphere, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
