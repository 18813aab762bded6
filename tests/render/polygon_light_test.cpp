// Polygons that shine, against Lambert's formula, and against rectangles of the same shape.
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr float albedo = 0.6f;
const glm::dvec3 up(0, 1, 0);
using Corners = std::vector<glm::vec3>;

// Points into `corners`.
GpLightDesc polygonDesc(const Corners& corners, float radiance) {
    GpLightDesc d{};
    d.kind = GP_LIGHT_POLYGON;
    d.intensity = radiance;
    d.corners = &corners[0].x, d.cornerCount = uint32_t(corners.size());
    return d;
}

// A regular one in a plane at `height` that is tilted about x; from below counter-clockwise.
Corners regular(int corners, glm::vec3 centre, float radius, float tilt) {
    Corners result;
    for (int i = 0; i < corners; ++i) {
        const float a = float(2 * pi) * float(i) / float(corners);
        const glm::vec3 p(radius * std::cos(a), 0, radius * std::sin(a));
        result.push_back(centre + glm::vec3(p.x, p.z * std::sin(tilt), p.z * std::cos(tilt)));
    }
    return result;
}

Corners reversed(Corners corners) {
    std::reverse(corners.begin(), corners.end());
    return corners;
}

double formOf(const Corners& corners) {
    return polygonIrradiance(std::vector<glm::dvec3>(corners.begin(), corners.end()), up);
}

class PolygonLights : public ::testing::TestWithParam<Variant> {
protected:
    PolygonLights() { begin(); }
    void begin() {
        owned = std::make_unique<Stage>(GetParam());
        Triangles plane;
        plane.quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40});
        owned->add(plane, owned->lambert(glm::vec3(albedo)));
    }
    // A patch of a millimetre in the middle, seen from a hand's breadth above.
    Picture look(uint32_t samples) {
        const GpCameraDesc camera =
            lookFrom({0, 0, 0}, {0.2672612f, 0.8017837f, 0.5345225f}, 0.1f, 1e-3f);
        GpRenderOptions o = stage().options(effort(samples));
        o.maxBounces = GP_NO_BOUNCES;
        return stage().render(8, 8, camera, o);
    }
    void expectIrradiance(double e, uint32_t samples, const char* what) {
        expectMean(look(samples), e * (albedo / pi), what);
    }
    Stage& stage() { return *owned; }
    std::unique_ptr<Stage> owned;
};

TEST_P(PolygonLights, IrradianceIsLamberts) {
    for (const int corners : {3, 5, 12}) {
        begin();
        const Corners c = regular(corners, {0.4f, 1, -0.3f}, 0.9f, 0.4f);
        stage().light(polygonDesc(c, 4));
        expectIrradiance(4 * formOf(c), 2048, "polygon");
    }
}

TEST_P(PolygonLights, ShineFromOneSideOrFromBoth) {
    const Corners c = regular(5, {0.4f, 1, -0.3f}, 0.9f, 0.4f);
    const Corners upwards = reversed(c);
    stage().light(polygonDesc(upwards, 4));
    EXPECT_EQ(look(4).mean().x, 0);
    begin();
    GpLightDesc both = polygonDesc(upwards, 4);
    both.twoSided = 1;
    stage().light(both);
    expectIrradiance(4 * formOf(c), 2048, "two-sided");
}

TEST_P(PolygonLights, ThroughTheHorizon) {
    const Corners c = {{1, -1, -0.8f}, {1, -0.7f, 0.9f}, {1, 1.2f, 0.7f}, {1, 0.8f, -0.6f}};
    Corners facing = c;  // towards -x, where the receiver is
    if (glm::cross(c[1] - c[0], c[2] - c[0]).x > 0) facing = reversed(c);
    stage().light(polygonDesc(facing, 4));
    expectIrradiance(4 * formOf(c), 8192, "half hidden");
}

// Corners on straight edges, and one twice, add nothing.
TEST_P(PolygonLights, SuperfluousCornersAreLeftOut) {
    const Corners c = {{-0.5f, 1, -0.5f}, {0, 1, -0.5f}, {0.5f, 1, -0.5f}, {0.5f, 1, -0.5f},
                       {0.5f, 1, 0.5f},   {0, 1, 0.5f},  {-0.5f, 1, 0.5f}, {-0.5f, 1, 0.2f}};
    stage().light(polygonDesc(c, 4));
    expectIrradiance(
        4 * polygonIrradiance(quadPolygon({-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}), up), 2048,
        "square");
}

TEST_P(PolygonLights, UnitsAreThoseOfRectangles) {
    const Corners c = {{-0.5f, 1, -0.2f}, {0.7f, 1.3f, -0.2f}, {0.7f, 1.4f, 0.8f},
                       {-0.5f, 1.1f, 0.8f}};
    for (const GpLightUnit unit : {GP_UNIT_RADIOMETRIC, GP_UNIT_PHOTOMETRIC, GP_UNIT_POWER_W,
                                   GP_UNIT_POWER_LM}) {
        GpLightDesc polygon = polygonDesc(c, 300), rectangle{};
        rectangle.kind = GP_LIGHT_RECTANGLE, rectangle.intensity = 300;
        put(rectangle.position, c[0]), put(rectangle.edgeU, c[1] - c[0]);
        put(rectangle.edgeV, c[3] - c[0]);
        polygon.unit = rectangle.unit = unit;
        polygon.twoSided = rectangle.twoSided = 1;
        begin();
        stage().light(polygon);
        const Picture a = look(512);
        begin();
        stage().light(rectangle);
        const Picture b = look(512);
        EXPECT_NEAR(a.mean().x, b.mean().x, 4 * glm::length(glm::dvec2(a.sigma().x, b.sigma().x)))
            << unit;
    }
}

// Rays see the shape with its radiance, from the front only, unless it is invisible.
TEST_P(PolygonLights, AreSeenAsTheyAre) {
    const Corners c = regular(6, {0, 1, 0}, 0.5f, 0);
    for (const bool invisible : {false, true})
        for (const bool back : {false, true}) {
            begin();
            const Corners facing = back ? reversed(c) : c;
            GpLightDesc d = polygonDesc(facing, 3);
            d.invisible = invisible;
            stage().light(d);
            GpRenderOptions o = stage().options(1);
            o.maxBounces = GP_NO_BOUNCES;
            const Picture p =
                stage().render(16, 16, lookFrom({0, 1, 0}, {0, -1, 0}, 0.5f, 1.2f), o);
            EXPECT_FLOAT_EQ(p.at(8, 8).x, invisible || back ? 0.0f : 3.0f);
            EXPECT_FLOAT_EQ(p.at(0, 0).x, 0.0f);
        }
}

// All around in one colour: what reflects all of the light looks like what shines.
TEST_P(PolygonLights, FurnaceOfSixSquares) {
    Stage box(GetParam());
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 n(0), u(0), v(0);
            n[axis] = side, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = side;
            // Counter-clockwise from the middle: its normal is -n.
            const Corners c = {n - u - v, n - u + v, n + u + v, n + u - v};
            box.light(polygonDesc(c, 0.7f));
        }
    Triangles ball;
    ball.sphere({0, 0, 0}, 0.5f, 24, false, true);
    box.add(ball, box.lambert(glm::vec3(1)));
    GpRenderOptions o = box.options(effort(512));
    o.maxBounces = 1;
    expectMean(box.render(12, 12, lookFrom({0, 0, 0}, {0, 0, 1}, 0.9f, 0.5f), o), 0.7, "furnace");
}

INSTANTIATE_TEST_SUITE_P(All, PolygonLights, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
