// The built-in sky against what is measured on clear days, and against itself.
#include "scene/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene/environment_table.h"

namespace gp {
namespace {

constexpr double pi = std::numbers::pi;

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2127, 0.7152, 0.0722)); }

struct SkyScene {
    Scene scene;
    double elevation;

    SkyScene(double degrees, double azimuth = 0, float lux = 0) : elevation(degrees * pi / 180) {
        setSky(scene, float(azimuth), float(elevation), lux);
    }
    const EnvironmentTable& image() const { return *scene.environment.table; }
    const Light& sun() const { return *scene.lights.at(0); }
    glm::dvec3 pixel(uint32_t x, uint32_t y) const {
        return image().radiance(x, y);
    }
    double sunLux() const { return 683 * luminance(glm::dvec3(sun().emission)); }
    // By the midpoints of the pixels, not by the exact areas that the sky itself uses.
    double skyLux() const {
        const uint32_t w = image().width, h = image().height;
        double sum = 0;
        for (uint32_t y = 0; y < h / 2; ++y) {
            const double theta = (y + 0.5) * pi / h;
            for (uint32_t x = 0; x < w; ++x)
                sum += luminance(pixel(x, y)) * std::cos(theta) * std::sin(theta);
        }
        return 683 * sum * (2 * pi / w) * (pi / h);
    }
};

TEST(Sky, EveryPixelIsFiniteAndNotNegative) {
    for (double degrees : {0.0, 0.5, 3.0, 10.0, 30.0, 60.0, 89.0, 90.0}) {
        const SkyScene sky(degrees, 1.3);
        for (uint32_t y = 0; y < sky.image().height; ++y)
            for (uint32_t x = 0; x < sky.image().width; ++x) {
                const glm::dvec3 c = sky.pixel(x, y);
                ASSERT_TRUE(std::isfinite(c.x + c.y + c.z)) << degrees << ": " << x << ' ' << y;
                ASSERT_GE(std::min({c.x, c.y, c.z}), 0) << degrees << ": " << x << ' ' << y;
            }
    }
}

TEST(Sky, AsBrightAsAClearDay) {
    const SkyScene noon(60);
    EXPECT_GT(noon.sunLux(), 90000);
    EXPECT_LT(noon.sunLux(), 110000);
    EXPECT_GT(noon.skyLux(), 13000);
    EXPECT_LT(noon.skyLux(), 20000);
    // The handbook's formula, by another quadrature than the one that set the scale.
    EXPECT_NEAR(noon.skyLux() / (800 + 15500 * std::sqrt(std::sin(noon.elevation))), 1, 1e-3);
}

TEST(Sky, TheSunFadesAndReddensTowardsTheHorizon) {
    double lux = 1e9, redness = 0;
    for (double degrees : {80.0, 40.0, 20.0, 10.0, 5.0, 2.0, 0.0}) {
        const SkyScene sky(degrees);
        const glm::vec3 e = sky.sun().emission;
        EXPECT_LT(sky.sunLux(), lux);
        EXPECT_GT(e.r / e.b, redness);
        EXPECT_GT(sky.sunLux(), 0);
        lux = sky.sunLux();
        redness = e.r / e.b;
    }
    const SkyScene high(80);
    EXPECT_LT(high.sun().emission.r / high.sun().emission.b, 2) << "the high sun is nearly white";
    EXPECT_GT(redness, 5) << "the setting sun is red";
}

TEST(Sky, GivenIlluminanceIsTheSunsOwn) {
    const SkyScene sky(30, 0, 50000);
    EXPECT_NEAR(sky.sunLux(), 50000, 50000 * 1e-3);
    EXPECT_NEAR(sky.skyLux(), SkyScene(30).skyLux(), 1) << "and leaves the sky as it was";
}

TEST(Sky, BlueAwayFromTheSun) {
    const SkyScene sky(40);  // the sun at -Z, the middle of the image
    const glm::dvec3 away = sky.pixel(0, 50);
    EXPECT_GT(away.b, 1.3 * away.r);
}

TEST(Sky, BrightestAroundTheSunWhoseLightComesFromThere) {
    for (double azimuth : {0.0, 0.9, 2.5, -1.7}) {
        const SkyScene sky(35, azimuth);
        const uint32_t w = sky.image().width, h = sky.image().height;
        uint32_t bestX = 0, bestY = 0;
        for (uint32_t y = 0; y < h / 2; ++y)
            for (uint32_t x = 0; x < w; ++x)
                if (luminance(sky.pixel(x, y)) > luminance(sky.pixel(bestX, bestY))) {
                    bestX = x;
                    bestY = y;
                }
        const double phi = ((bestX + 0.5) / w - 0.5) * 2 * pi, theta = (bestY + 0.5) / h * pi;
        const glm::dvec3 brightest(std::sin(theta) * std::sin(phi), std::cos(theta),
                                   -std::sin(theta) * std::cos(phi));
        const glm::dvec3 towardsSun = -glm::dvec3(sky.sun().direction);
        EXPECT_GT(glm::dot(brightest, towardsSun), std::cos(0.02)) << "azimuth " << azimuth;
        EXPECT_NEAR(towardsSun.x, std::cos(sky.elevation) * std::sin(azimuth), 1e-6);
        EXPECT_NEAR(towardsSun.y, std::sin(sky.elevation), 1e-6);
    }
}

TEST(Sky, TheGroundReflectsAQuarterOfWhatItReceives) {
    const SkyScene sky(50);
    const double onGround = sky.skyLux() + sky.sunLux() * std::sin(sky.elevation);
    const double ground = 683 * luminance(sky.pixel(10, 200)) * pi;
    EXPECT_NEAR(ground / onGround, 0.25, 1e-3);
    EXPECT_EQ(sky.pixel(0, 128), sky.pixel(511, 255)) << "it is the same everywhere";
}

TEST(Sky, AnotherSkyReplacesTheFirstAndNoOtherLight) {
    Scene scene;
    scene.lights.push_back(std::make_shared<Light>());
    setSky(scene, 0, 1, 0);
    const uint64_t revision = scene.revision;
    setSky(scene, 0, 0.5f, 0);
    EXPECT_EQ(scene.lights.size(), 2u);
    EXPECT_GT(scene.revision, revision);
    removeSkySun(scene);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_FALSE(scene.lights[0]->ofSky);
}

}  // namespace
}  // namespace gp
