// Each kind of light over a diffuse plane, against irradiance in closed form.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr float albedo = 0.6f;
const glm::dvec3 up(0, 1, 0);

GpLightDesc lightDesc(GpLightKind kind, float intensity) {
    GpLightDesc d{};
    d.kind = kind;
    d.intensity = intensity;
    return d;
}

GpLightDesc rectangleDesc(glm::vec3 corner, glm::vec3 u, glm::vec3 v, float radiance) {
    GpLightDesc d = lightDesc(GP_LIGHT_RECTANGLE, radiance);
    put(d.position, corner), put(d.edgeU, u), put(d.edgeV, v);
    return d;
}

class Lights : public ::testing::TestWithParam<Variant> {
protected:
    Lights() { begin(); }
    void begin() {
        owned = std::make_unique<Stage>(GetParam());
        Triangles plane;
        plane.quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40});
        owned->add(plane, owned->lambert(glm::vec3(albedo)));
    }
    // A patch of a millimetre in the middle, seen from a hand's breadth above.
    Picture look(uint32_t samples, int32_t bounces = GP_NO_BOUNCES) {
        const GpCameraDesc camera =
            lookFrom({0, 0, 0}, {0.2672612f, 0.8017837f, 0.5345225f}, 0.1f, 1e-3f);
        GpRenderOptions o = stage().options(effort(samples));
        o.maxBounces = bounces;
        return stage().render(8, 8, camera, o);
    }
    void expectIrradiance(glm::dvec3 e, uint32_t samples, const char* what) {
        expectMean(look(samples), e * (albedo / pi), what);
    }
    void expectIrradiance(double e, uint32_t samples, const char* what) {
        expectIrradiance(glm::dvec3(e), samples, what);
    }
    Stage& stage() { return *owned; }
    std::unique_ptr<Stage> owned;
};

TEST_P(Lights, Directional) {
    GpLightDesc d = lightDesc(GP_LIGHT_DIRECTIONAL, 3);
    put(d.direction, {1, -2, 0.5f});
    put(d.color, {1, 0.5f, 0.25f});
    stage().light(d);
    const double cosine = 2 / std::sqrt(1 + 4 + 0.25);
    expectIrradiance(glm::dvec3(3, 1.5, 0.75) * cosine, 4, "parallel");
}

TEST_P(Lights, DirectionalDisk) {
    GpLightDesc d = lightDesc(GP_LIGHT_DIRECTIONAL, 3);
    put(d.direction, {1, -2, 0.5f});
    d.angularRadius = 0.4f;
    stage().light(d);
    expectIrradiance(3 * 2 / std::sqrt(5.25), 64, "disk");
}

// The disk's share above the horizon, by integration over its circles of equal distance.
TEST_P(Lights, DirectionalDiskAtTheHorizon) {
    GpLightDesc d = lightDesc(GP_LIGHT_DIRECTIONAL, 3);
    put(d.direction, {1, 0, 0});
    d.angularRadius = 0.3f;
    stage().light(d);
    // The upper half: integral of sin(elevation) is the half disk's projected solid angle.
    const double r = 0.3, n = 2000;
    double projected = 0;
    for (int i = 0; i < n; ++i) {
        const double t = (i + 0.5) * r / n;
        projected +=
            std::sin(t) * std::sin(t) * 2 * r / n;  // integral over phi of max(sin phi, 0) = 2
    }
    expectIrradiance(3 / (pi * std::sin(r) * std::sin(r)) * projected, 6144, "half a disk");
}

TEST_P(Lights, PointAndItsUnits) {
    const glm::dvec3 at(0.5, 2, -1);
    const double d2 = glm::dot(at, at), form = 2 / std::sqrt(d2) / d2;
    GpLightDesc d = lightDesc(GP_LIGHT_SPHERE, 7);
    put(d.position, glm::vec3(at));
    stage().light(d);
    expectIrradiance(7 * form, 4, "W/sr");
    d.unit = GP_UNIT_POWER_W;
    stage().light(d);
    expectIrradiance((7 + 7 / (4 * pi)) * form, 64, "and W");
    d.unit = GP_UNIT_PHOTOMETRIC, d.intensity = 683;
    stage().light(d);
    expectIrradiance((8 + 7 / (4 * pi)) * form, 256, "and candela");
}

TEST_P(Lights, Sphere) {
    const glm::dvec3 at(0.5, 1, -0.3);
    GpLightDesc d = lightDesc(GP_LIGHT_SPHERE, 2);
    d.radius = 0.7f;
    put(d.position, glm::vec3(at));
    stage().light(d);
    expectIrradiance(2 / (pi * 0.49) * sphereIrradiance(at, 0.7, up), 256, "sphere");
}

TEST_P(Lights, SpotInsideBetweenAndOutside) {
    const double inner = 0.3, outer = 0.6;
    for (const double angle : {0.2, 0.45, 0.7}) {
        for (const float radius : {0.0f, 0.2f}) {
            begin();
            GpLightDesc d = lightDesc(GP_LIGHT_SPOT, 5);
            put(d.position, {0, 2, 0});
            put(d.direction, {float(std::sin(angle)), float(-std::cos(angle)), 0});
            d.innerAngle = float(inner), d.outerAngle = float(outer), d.radius = radius;
            stage().light(d);
            // [KHR_lights_punctual, "Inner and Outer Cone Angles"]
            const double share = std::clamp(
                (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0,
                1.0);
            expectIrradiance(5.0 / 4 * share * share, radius > 0 ? 128 : 4, "spot");
        }
    }
}

TEST_P(Lights, RectangleFromItsTwoSides) {
    const glm::vec3 corner(-0.5f, 1, -0.2f), u(1.2f, 0.3f, 0), v(0, 0.1f, 1);
    const double form = polygonIrradiance(quadPolygon(corner, u, v), up);
    stage().light(rectangleDesc(corner, u, v, 4));  // u x v points down
    expectIrradiance(4 * form, 768, "front");
    stage().light(rectangleDesc(corner + glm::vec3(0, 8, 0), v, u, 4));
    expectIrradiance(4 * form, 768, "the back is dark");
    GpLightDesc both = rectangleDesc(corner + glm::vec3(2, 0, 0), v, u, 3);
    both.twoSided = 1;
    stage().light(both);
    const double second = polygonIrradiance(quadPolygon(corner + glm::vec3(2, 0, 0), v, u), up);
    expectIrradiance(4 * form + 3 * second, 2048, "two-sided");
}

TEST_P(Lights, RectangleThroughTheHorizon) {
    const glm::vec3 corner(1, -1, -0.8f), u(0, 2, 0), v(0, 0, 1.6f);
    stage().light(rectangleDesc(corner, v, u, 4));  // v x u points to -x
    expectIrradiance(4 * polygonIrradiance(quadPolygon(corner, v, u), up), 4608, "half hidden");
}

TEST_P(Lights, EmissiveTrianglesAreTheSameAsARectangle) {
    const glm::vec3 corner(-0.5f, 1, -0.2f), u(1.2f, 0.3f, 0), v(0, 0.1f, 1);
    Triangles quad;
    quad.quad(corner, u, v);
    stage().add(quad, stage().lambert(glm::vec3(0), {4, 2, 0.5f}));
    expectIrradiance(glm::dvec3(4, 2, 0.5) * polygonIrradiance(quadPolygon(corner, u, v), up), 1024,
                     "triangles");
}

// KHR_materials_unlit: it is seen as it is, but lights nothing; it stands in the sky's way.
TEST_P(Lights, UnlitSurfacesCastNone) {
    const glm::vec3 corner(-0.5f, 1, -0.2f), u(1.2f, 0.3f, 0), v(0, 0.1f, 1);
    stage().surround(glm::vec3(0.5f));
    Triangles quad;
    quad.quad(corner, u, v);
    GpMaterialDesc d = lambertDesc(glm::vec3(0.9f));
    d.unlit = 1;
    stage().add(quad, stage().material(d));
    expectIrradiance(0.5 * (pi - polygonIrradiance(quadPolygon(corner, u, v), up)), 6144, "unlit");
}

// Solid lights hide what is behind them, so each takes its own share of the sky away.
TEST_P(Lights, AllAtOnce) {
    const glm::dvec3 sphere(-1, 1, 0.3);
    const glm::vec3 corner(0.3f, 1, -0.2f), u(0.8f, 0.3f, 0), v(0, 0.1f, 1), aside(0, 0.2f, -2.2f);
    stage().surround(glm::vec3(0.5f));
    GpLightDesc d = lightDesc(GP_LIGHT_DIRECTIONAL, 2);
    put(d.direction, {-0.2f, -1, 0.8f});
    stage().light(d);
    d = lightDesc(GP_LIGHT_SPHERE, 3);
    d.radius = 0.3f;
    put(d.position, glm::vec3(sphere));
    stage().light(d);
    d = lightDesc(GP_LIGHT_SPHERE, 1.5f);
    put(d.position, {0, 1, 0});
    stage().light(d);
    stage().light(rectangleDesc(corner, u, v, 2));
    Triangles quad;
    quad.quad(corner + aside, u, v);
    stage().add(quad, stage().lambert(glm::vec3(0), glm::vec3(3)));
    const double formSphere = sphereIrradiance(sphere, 0.3, up);
    const double formRectangle = polygonIrradiance(quadPolygon(corner, u, v), up);
    const double formQuad = polygonIrradiance(quadPolygon(corner + aside, u, v), up);
    const double expected = 0.5 * (pi - formSphere - formRectangle - formQuad) +
                            2 / std::sqrt(1 + 0.04 + 0.64) + 3 / (pi * 0.09) * formSphere + 1.5 +
                            2 * formRectangle + 3 * formQuad;
    expectIrradiance(expected, 2048, "all");
}

INSTANTIATE_TEST_SUITE_P(All, Lights, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
