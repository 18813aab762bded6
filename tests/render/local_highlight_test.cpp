// GP_MODE_LOCAL: highlights filtered by how much a pixel sees of a curved surface (GpNdfFilter),
// against the mean of many samples.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t size = 33;

// A smooth ball in the light of a sun, its highlight a fifth of a pixel wide.
struct Ball {
    explicit Ball(const Variant& variant, bool smooth = true) : stage(variant) {
        GpMaterialDesc d = lambertDesc(glm::vec3(1));
        d.given |= GP_GIVEN_ROUGHNESS;
        d.metallic = 1, d.roughness = 0.1f;
        Triangles t;
        t.sphere({0, 0, 0}, 1, 64, false, smooth);
        stage.add(t, stage.material(d));
        GpLightDesc sun{};
        sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = 1;
        put(sun.direction, glm::normalize(glm::vec3(-0.9f, -1, -0.3f)));
        stage.light(sun);
    }

    // One sample in the middle of each pixel, or the mean under the Gaussian that is assumed.
    Picture look(GpNdfFilter filter, uint32_t samples) {
        GpRenderOptions o = stage.options(samples);
        o.pixelFilter = samples == 1 ? GP_PIXEL_BOX : GP_PIXEL_GAUSSIAN;
        o.pixelFilterRadius = samples == 1 ? 1e-4f : 1.2f;
        o.local.ndfFilter = filter;
        return stage.render(size, size, lookFrom({0, 0, 0}, {0.1f, 0.3f, 1}, 6, 2.4f), o);
    }

    Stage stage;
};

// Absolute difference over all pixels, relative to the light of the second.
double distance(const Picture& a, const Picture& b) {
    double difference = 0, total = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        difference += std::abs(double(a.color[i].x) - double(b.color[i].x));
        total += double(b.color[i].x);
    }
    return difference / total;
}

class LocalHighlight : public ::testing::TestWithParam<Variant> {};

TEST_P(LocalHighlight, OneSampleShowsTheMeanOfMany) {
    Ball ball(GetParam());
    const Picture many = ball.look(GP_NDF_FILTER_NONE, 1024);
    const double none = distance(ball.look(GP_NDF_FILTER_NONE, 1), many);
    EXPECT_GT(none, 4.0);  // pixels that hit the highlight show all of it
    EXPECT_LT(distance(ball.look(GP_NDF_FILTER_KAPLANYAN, 1), many), 1.2);
    EXPECT_LT(distance(ball.look(GP_NDF_FILTER_DEFERRED, 1), many), 0.8);
    EXPECT_LT(distance(ball.look(GP_NDF_FILTER_TOKUYOSHI, 1), many), 0.06);
}

// Nothing turns on flat triangles under a sun far away but the view.
TEST_P(LocalHighlight, FlatSurfacesStayAsTheyAre) {
    Ball ball(GetParam(), false);
    const Picture none = ball.look(GP_NDF_FILTER_NONE, 1);
    EXPECT_EQ(distance(ball.look(GP_NDF_FILTER_DEFERRED, 1), none), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, LocalHighlight, ::testing::ValuesIn(localVariants()),
                         [](const auto& made) { return variantName(made.param); });

}  // namespace
}  // namespace gp::test
