// Glass with known answers: slabs that absorb, total reflection in a prism, light inside of glass.
#include <cmath>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

class Refraction : public ::testing::TestWithParam<Variant> {
protected:
    Refraction() : stage(GetParam()) {}
    GpMaterial glass(float ior, glm::vec3 left = glm::vec3(1), float distance = 0) {
        GpMaterialDesc d{};
        d.given = GP_GIVEN_ROUGHNESS;
        d.transmission = 1, d.solid = 1, d.ior = ior;
        put(d.attenuationColor, left);
        d.attenuationDistance = distance;
        return stage.material(d);
    }
    Picture look(const GpCameraDesc& camera, uint32_t samples) {
        GpRenderOptions o = stage.options(effort(samples));
        o.maxBounces = 40;
        o.noRussianRoulette = 1;
        return stage.render(8, 8, camera, o);
    }
    Stage stage;
};

// [Born and Wolf 1999, "Principles of Optics", section 7.6, incoherent sum over a slab's faces]
glm::dvec3 slab(double ior, glm::dvec3 through) {
    const double r = (ior - 1) / (ior + 1), f = r * r;
    const glm::dvec3 series = 1.0 / (1.0 - f * f * through * through);
    return (1 - f) * (1 - f) * through * series + f +
           (1 - f) * (1 - f) * f * through * through * series;
}

TEST_P(Refraction, SlabAbsorbsByBeerAndLambert) {
    const glm::dvec3 left(0.95, 0.8, 0.6);  // after 0.25 m; the slab is 0.5 m thick
    for (const double ior : {1.0, 1.0001, 1.33, 1.5, 2.4}) {
        Stage fresh(GetParam());
        Triangles t;
        t.box({-2, -2, -0.5f}, {2, 2, 0});
        GpMaterialDesc d{};
        d.given = GP_GIVEN_ROUGHNESS;
        d.transmission = 1, d.solid = 1, d.ior = float(ior);
        put(d.attenuationColor, glm::vec3(left));
        d.attenuationDistance = 0.25f;
        fresh.add(t, fresh.material(d));
        fresh.surround(glm::vec3(1));
        GpRenderOptions o = fresh.options(effort(ior > 2 ? 6144 : 2048));
        o.noRussianRoulette = 1;
        const Picture p = fresh.render(8, 8, lookFrom({0, 0, 0}, {0, 0, 1}, 1, 0.1f), o);
        expectMean(p, slab(ior, left * left), "ior " + std::to_string(ior));
    }
}

// A right-angled prism seen through one leg: beyond the critical angle all light turns to the other
// leg, where (1 - F) of it comes in; what is reflected there goes to and fro: (1 - F)^2 / (1 -
// F^2).
TEST_P(Refraction, PrismReflectsTotally) {
    Triangles t;
    const glm::vec3 a(0, 0, -4), z(0, 0, 8), x(1, 0, 0), y(0, 1, 0);
    t.quad(a, z, y);          // leg at x = 0, front: -x
    t.quad(a, x, z);          // leg at y = 0, front: -y
    t.quad(a + x, y - x, z);  // hypotenuse, front: x + y
    const glm::vec3 ends[] = {a, a + y, a + x, a + z, a + z + x, a + z + y};
    for (const glm::vec3 p : ends) t.positions.push_back(p), t.uv0.emplace_back(0);
    stage.add(t, glass(1.5f));
    Triangles lamp;
    lamp.quad({-1, -0.5f, -5}, {0, 0, 10}, {3, 0, 0});  // below the leg at y = 0, front: up
    stage.add(lamp, stage.lambert(glm::vec3(0), {1, 2, 4}));
    const Picture p = look(lookFrom({0, 0.5f, 0}, {-1, 0, 0}, 2, 0.1f), 1024);
    const double f = 0.04;
    expectMean(p, glm::dvec3(1, 2, 4) * ((1 - f) / (1 + f)));
}

// Radiance in glass is n^2 times that outside. The way out ends in the same surrounding however
// often the faces turn it back.
TEST_P(Refraction, InsideOfGlassRadianceIsDenser) {
    Triangles t;
    t.box({-3, -3, -1}, {3, 3, 1});
    stage.add(t, glass(1.5f));
    stage.surround(glm::vec3(1));
    expectMean(look(lookFrom({0, 0, -0.5f}, {0, 0, 1}, 1, 0.1f), 256), 2.25);
}

// A slab moves what lies behind it aside by t sin(a) (1 - cos(a) / (n cos(b))), n sin(b) = sin(a).
TEST_P(Refraction, TiltedSlabShiftsBySnell) {
    const double n = 1.5, thickness = 1, angle = 0.7, inner = std::asin(std::sin(angle) / n);
    const double shift = thickness * std::sin(angle - inner) / std::cos(inner);
    const glm::dvec3 normal(std::sin(angle), 0, std::cos(angle)),
        across(std::cos(angle), 0, -std::sin(angle));
    Triangles t;
    const auto quad = [&](glm::dvec3 c, glm::dvec3 u, glm::dvec3 v) {
        t.quad(glm::vec3(c), glm::vec3(u), glm::vec3(v));
    };
    const glm::dvec3 u = 10.0 * across, v(0, 10, 0), w = thickness * normal, c = -0.5 * (u + v + w);
    quad(c + w, u, v), quad(c, v, u), quad(c, w, v), quad(c + u, v, w), quad(c, u, w),
        quad(c + v, w, u);
    stage.add(t, glass(float(n)));
    // The camera's rays travel to -z; behind the slab they are displaced along x by -shift.
    Triangles lamp;
    const double pixel = 1.0 / 8;
    const glm::dvec3 centre(-shift + 2.5 * pixel, -0.5 * pixel, -8);
    lamp.quad(glm::vec3(centre - glm::dvec3(pixel / 2, pixel / 2, 0)), {float(pixel), 0, 0},
              {0, float(pixel), 0});
    stage.add(lamp, stage.lambert(glm::vec3(0), glm::vec3(1)));
    const Picture p = look(lookFrom({0, 0, 0}, {0, 0, 1}, 8, 1), 64);
    glm::dvec2 middle(0);
    double sum = 0;
    for (uint32_t y = 0; y < 8; ++y)
        for (uint32_t x = 0; x < 8; ++x)
            middle += double(p.at(x, y).x) * glm::dvec2(x, y), sum += p.at(x, y).x;
    EXPECT_GT(sum, 0.7);
    EXPECT_NEAR(middle.x / sum, 6, 0.1);
    EXPECT_NEAR(middle.y / sum, 4, 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, Refraction, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
