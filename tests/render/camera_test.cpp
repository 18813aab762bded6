// Where things appear: film positions, the blur of a lens, the weight of pixel filters.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class Cameras : public ::testing::TestWithParam<Variant> {
protected:
    Cameras() : stage(GetParam()) {}
    void lamp(glm::vec3 centre, float size, glm::vec3 x = {1, 0, 0}, glm::vec3 y = {0, 1, 0}) {
        Triangles t;
        t.quad(centre - 0.5f * size * (x + y), size * x, size * y);
        GpMaterialDesc d = lambertDesc(glm::vec3(0));
        put(d.emission, glm::vec3(1));
        d.doubleSided = 1;
        stage.add(t, stage.material(d));
    }
    Picture look(const GpCameraDesc& camera, uint32_t width, uint32_t height, uint32_t samples,
                 GpPixelFilter filter = GP_PIXEL_BOX, float radius = 0) {
        GpRenderOptions o = stage.options(samples);
        o.pixelFilter = filter, o.pixelFilterRadius = radius;
        return stage.render(width, height, camera, o);
    }
    // The only pixels that are not black: exactly this one, wholly lit.
    static void expectOnly(const Picture& p, uint32_t x, uint32_t y) {
        for (uint32_t j = 0; j < p.height; ++j)
            for (uint32_t i = 0; i < p.width; ++i)
                EXPECT_NEAR(p.at(i, j).x, i == x && j == y ? 1 : 0, 1e-5) << i << ", " << j;
    }
    Stage stage;
};

// By the definition of the vertical field of view, y up and x to the right.
TEST_P(Cameras, PerspectiveFilmPositions) {
    constexpr uint32_t w = 40, h = 20;
    const double fov = 0.9, distance = 3, pixel = 2 * distance * std::tan(fov / 2) / h;
    const glm::dvec3 position(1, 2, 3), forward = glm::normalize(glm::dvec3(2, -1, -2));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, {0, 1, 0})),
                     up = glm::cross(right, forward);
    const uint32_t x = 31, y = 4;
    const glm::dvec3 centre = position + forward * distance +
                              right * ((x + 0.5 - w / 2.0) * pixel) +
                              up * ((h / 2.0 - y - 0.5) * pixel);
    lamp(glm::vec3(centre), float(pixel), glm::vec3(right), glm::vec3(up));
    GpCameraDesc c{};
    put(c.position, glm::vec3(position));
    put(c.target, glm::vec3(position + 5.0 * forward));
    c.verticalFov = float(fov);
    // Slightly narrower than the pixel, so that rounding lights no neighbour.
    expectOnly(look(c, w, h, 16, GP_PIXEL_BOX, 0.49f), x, y);
}

TEST_P(Cameras, OrthographicFilmPositions) {
    lamp({0.625f, -0.375f, -7}, 0.25f);
    GpCameraDesc c = lookFrom({0, 0, 0}, {0, 0, 1}, 2, 2);
    expectOnly(look(c, 16, 8, 16, GP_PIXEL_BOX, 0.49f), 10, 5);
}

// A small light at distance d, focus at f: its image is a disk of radius aperture |d - f| / f in
// the plane at d, seen there by the pinhole at the lens's middle.
TEST_P(Cameras, ThinLensBlursAsTheFormulaSays) {
    constexpr uint32_t size = 64;
    const double d = 4, f = 2.5, aperture = 0.12, fov = 0.5;
    lamp({0, 0, float(-d)}, 0.02f);
    GpCameraDesc c{};
    put(c.target, {0, 0, -1});
    c.verticalFov = float(fov), c.apertureRadius = float(aperture), c.focusDistance = float(f);
    const Picture p = look(c, size, size, effort(512));
    const double pixel = 2 * d * std::tan(fov / 2) / size, radius = aperture * (d - f) / f / pixel;
    double sum = 0, reach = 0;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const double r = std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0);
            sum += p.at(x, y).x;
            if (p.at(x, y).x > 0) reach = std::max(reach, r);
            if (r < radius - 1) {
                EXPECT_GT(p.at(x, y).x, 0) << x << ", " << y;
            }
        }
    EXPECT_NEAR(reach, radius, 1);
    // The lens moves light, it adds and takes none: the light's area in pixels.
    EXPECT_NEAR(sum, 0.02 * 0.02 / (pixel * pixel), 0.03 * sum);
}

TEST_P(Cameras, LensIsSharpAtItsFocus) {
    const double f = 2.5, pixel = 2 * f * std::tan(0.25) / 16;
    lamp({float(2.5 * pixel), float(2.5 * pixel), float(-f)}, float(pixel));
    GpCameraDesc c{};
    put(c.target, {0, 0, -1});
    c.verticalFov = 0.5f, c.apertureRadius = 0.2f, c.focusDistance = float(f);
    expectOnly(look(c, 16, 16, 64, GP_PIXEL_BOX, 0.49f), 10, 5);
}

TEST_P(Cameras, FiltersKeepFlatPicturesFlat) {
    stage.surround({0.25f, 1, 3});
    for (const GpPixelFilter filter :
         {GP_PIXEL_BLACKMAN_HARRIS, GP_PIXEL_BOX, GP_PIXEL_TENT, GP_PIXEL_GAUSSIAN})
        for (const glm::vec4& c :
             look(lookFrom({0, 0, 0}, {0, 0, 1}, 1, 1), 6, 6, 16, filter).color)
            EXPECT_EQ(c, glm::vec4(0.25f, 1, 3, 0)) << int(filter);
}

// A pixel half covered: the box sees the area; every filter is symmetric and integrates to one, so
// a row of pixels across an edge sums up to the same.
TEST_P(Cameras, FiltersWeighAreas) {
    lamp({-5.125f + 1.0f / 32, 0, 0}, 10.25f);  // its right edge: x = 1/32, a quarter of a pixel
    const GpCameraDesc c = lookFrom({0, 0, 0}, {0, 0, 1}, 1, 1);
    const Picture box = look(c, 8, 8, 4096);
    EXPECT_NEAR(box.at(4, 3).x, 0.25, 0.004);
    EXPECT_EQ(box.at(3, 3).x, 1);
    EXPECT_EQ(box.at(5, 3).x, 0);
    for (const GpPixelFilter filter :
         {GP_PIXEL_BLACKMAN_HARRIS, GP_PIXEL_TENT, GP_PIXEL_GAUSSIAN}) {
        const Picture p = look(c, 8, 8, 4096, filter);
        double sum = 0;
        for (uint32_t x = 0; x < 8; ++x) sum += p.at(x, 4).x;
        EXPECT_NEAR(sum, 4.25, 0.01) << int(filter);
        EXPECT_GT(p.at(3, 4).x, 0.5) << int(filter);
        EXPECT_LT(p.at(3, 4).x, 0.99) << "as wide as it says, " << int(filter);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Cameras, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
