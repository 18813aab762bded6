// What water scatters along a ray: the closed form against its integral, its limits, and the light
// that comes down into a sea.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "shading/lang.h"

#include "scene/environment_table.h"
#include "scene/water_light.h"

GP_SHADING_BEGIN
#include "shading/fresnel.glsl"
#include "shading/ocean/water_light.glsl"
GP_SHADING_END

namespace gp {
namespace {

using shading::water_light;

constexpr double pi = 3.14159265358979323846;
constexpr float endless = 3.402823466e38f;

struct Ray {
    double loss, stretch, depth, down, length;
};

// Simpson's rule over the source, as the file states it, behind what is before it.
double integral(const Ray& r) {
    double end = r.length;
    if (r.down < 0) end = std::min(end, r.depth / -r.down);
    end = std::min(end, 60 / r.loss);
    constexpr int steps = 4000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double s = end * i / steps;
        const double source = r.loss * (1 + r.stretch * std::max(r.down, 0.0)) *
                              std::exp(-r.stretch * r.loss * (r.depth + r.down * s));
        sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * source * std::exp(-r.loss * s);
    }
    return sum * end / (3 * steps);
}

float closed(const Ray& r, double length) {
    return water_light(1, float(r.loss), float(r.stretch), float(r.depth), float(r.down),
                       float(length));
}

std::vector<Ray> rays() {
    std::vector<Ray> all;
    for (const double loss : {0.003, 0.1, 2.0, 40.0})
        for (const double stretch : {1.0, 1.25, 1.5, 2.0})
            for (const double depth : {0.0, 0.4, 7.0})
                for (const double down : {-1.0, -0.81, -0.8, -0.799, -0.5, -0.01, 0.0, 0.02, 1.0})
                    for (const double length : {1e-4, 0.3, 5.0, 300.0})
                        all.push_back({loss, stretch, depth, down, length});
    return all;
}

TEST(WaterLight, IsTheIntegralOfItsSource) {
    for (const Ray& r : rays()) {
        const double expected = integral(r);
        EXPECT_NEAR(double(closed(r, r.length)), expected, 2e-5 * expected + 1e-9)
            << r.loss << ' ' << r.stretch << ' ' << r.depth << ' ' << r.down << ' ' << r.length;
    }
}

// A ray cut in two brings the same as the whole one.
TEST(WaterLight, PartsOfARayAddUp) {
    for (const Ray& r : rays()) {
        Ray whole = r;
        if (r.down < 0) whole.length = std::min(r.length, r.depth / -r.down);
        const double cut = 0.3 * whole.length;
        Ray rest = whole;
        rest.depth = whole.depth + whole.down * cut;
        const double parts = double(closed(whole, cut)) +
                             std::exp(-r.loss * cut) * double(closed(rest, whole.length - cut));
        const double all = double(closed(whole, whole.length));
        EXPECT_NEAR(parts, all, 3e-5 * all + 1e-9);
    }
}

TEST(WaterLight, HasItsLimits) {
    // Things fade to the radiance of the deep at the viewer's depth, and no ray brings more.
    for (const double down : {1.0, 0.3, 0.0}) {
        EXPECT_NEAR(water_light(3, 0.1f, 1.2f, 0, float(down), endless), 3, 3e-6);
        EXPECT_NEAR(water_light(3, 0.1f, 1.2f, 5, float(down), endless),
                    3 * std::exp(-0.6), 3e-6);
    }
    for (const Ray& r : rays()) {
        const float light = closed(r, r.length);
        EXPECT_GE(light, 0);
        EXPECT_LE(light, 1);
    }
    for (const float loss : {0.0f, 1e-30f, 1e-6f, 1000.0f})
        for (const float depth : {0.0f, 1e-30f, 1e6f})
            for (const float down : {-1.0f, -1e-30f, 0.0f, 1e-30f, 1.0f})
                for (const float length : {0.0f, 1e-30f, 1e6f, endless}) {
                    const float light = water_light(1, loss, 1.5f, depth, down, length);
                    EXPECT_TRUE(light >= 0 && light <= 1.0001f)
                        << light << ": " << loss << ' ' << depth << ' ' << down << ' ' << length;
                    EXPECT_TRUE(loss > 0 || light == 0);
                }
}

// ------------------------------------------------------------------------------- from above

SeaSettings seaOf(glm::vec3 absorption, glm::vec3 backscattering, float ior = 1.333f) {
    SeaSettings s;
    s.absorption = absorption, s.backscattering = backscattering, s.ior = ior;
    return s;
}

shared::LightRecord sunAt(double zenith, glm::vec3 irradiance) {
    shared::LightRecord sun{};
    sun.direction = {float(std::sin(zenith)), -float(std::cos(zenith)), 0};
    sun.emission = irradiance;
    return sun;
}

double through(double cosine, float ior) {
    return 1 - double(shading::fresnel_dielectric(float(cosine), ior));
}

double meanThrough(float ior) {
    constexpr int steps = 10000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps;
        sum += 2 * c * through(c, ior) / steps;
    }
    return sum;
}

TEST(WaterLight, OfSuns) {
    const SeaSettings sea = seaOf({0.3f, 0.1f, 0.02f}, {0.01f, 0.02f, 0.03f});
    const glm::vec3 colors[] = {{1, 2, 3}, {4, 1, 0.5f}, {100, 100, 100}};
    const double zenith[] = {0.4, 1.3, 1.7};  // the last is below the horizon
    shared::LightRecord suns[3];
    glm::dvec3 enters(0);
    double ways = 0, weights = 0;
    for (int i = 0; i < 3; ++i) {
        suns[i] = sunAt(zenith[i], colors[i]);
        if (i == 2) continue;
        const double c = std::cos(zenith[i]);
        const double below = std::cos(std::asin(std::sin(zenith[i]) / 1.333));
        const glm::dvec3 e = glm::dvec3(colors[i]) * (c * through(c, 1.333f));
        const double y = glm::dot(e, glm::dvec3(0.2126, 0.7152, 0.0722));
        enters += e, ways += y / below, weights += y;
    }
    const WaterLight light = waterLight(sea, suns, 3, {nullptr, 0, glm::vec3(0)});
    EXPECT_NEAR(double(light.stretch), ways / weights, 1e-4);
    const glm::vec3 r = seaReflectance(sea);
    for (int c = 0; c < 3; ++c) {
        // What leaves through the surface again is the reflectance's share of what enters.
        const double leaves =
            double(light.radiance[c]) * pi * meanThrough(1.333f) / (1.333 * 1.333);
        EXPECT_NEAR(leaves, double(r[c]) * enters[c], 2e-4 * enters[c]) << c;
    }
}

// From all sides alike it is in balance: the radiance below would be n^2 were all returned.
TEST(WaterLight, OfAWhiteSky) {
    for (const float ior : {1.01f, 1.333f, 3.0f}) {
        const SeaSettings sea = seaOf(glm::vec3(0), glm::vec3(0.1f), ior);
        const WaterLight light = waterLight(sea, nullptr, 0, {nullptr, 0, glm::vec3(1)});
        const float share = seaReflectance(sea).y;
        EXPECT_NEAR(light.radiance.y, share * ior * ior, 1e-5f * ior * ior);
        // The source of a ray is below that of the balance: no light is gained.
        EXPECT_LE(share * (1 + light.stretch), 1.0f) << ior;
        const std::vector<glm::vec3> rows(7, glm::vec3(0.5f));
        const WaterLight same = waterLight(sea, nullptr, 0, {rows.data(), 7, glm::vec3(2)});
        EXPECT_NEAR(same.radiance.y, light.radiance.y, 2e-4f * light.radiance.y);
        EXPECT_NEAR(same.stretch, light.stretch, 1e-3f);
    }
    const WaterLight none =
        waterLight(seaOf(glm::vec3(0), glm::vec3(0)), nullptr, 0, {nullptr, 0, glm::vec3(1)});
    EXPECT_EQ(none.radiance, glm::vec3(0));
}

// Of an image the rows above the horizon count, each by what the surface lets through there.
TEST(WaterLight, OfASkyImage) {
    constexpr uint32_t width = 8, height = 90;
    std::vector<float> image(width * height * 4, 1.0f);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t c = 0; c < 3; ++c)
                image[(y * width + x) * 4 + c] =
                    y < 45 ? float((x % 2 + 1) * (y == 30)) * 2 : 50.0f;
    const auto table = makeEnvironmentTable(image.data(), width, height);
    ASSERT_EQ(table->rowMeans.size(), height);
    EXPECT_NEAR(table->rowMeans[30].y, 3, 1e-6f);
    const SeaSettings sea = seaOf(glm::vec3(0.1f), glm::vec3(0.1f));
    const WaterLight light =
        waterLight(sea, nullptr, 0, {table->rowMeans.data(), height, glm::vec3(1)});
    const double hi = std::cos(pi * 30 / height), lo = std::cos(pi * 31 / height);
    const double enters = 3 * pi * (hi * hi - lo * lo) * through((hi + lo) / 2, 1.333f);
    const double out = meanThrough(1.333f) / (1.333 * 1.333);
    const double share = 0.165 * out / (1 - 0.165 * (1 - out));
    const double expected = share * enters * 1.333 * 1.333 / (pi * meanThrough(1.333f));
    EXPECT_NEAR(double(light.radiance.y), expected, 1e-3 * expected);
}

// Of the light below the surface 0.33 b / (a + b) goes up, and of that what the surface throws back
// down counts again.
TEST(WaterLight, ReflectanceIsBoundedAndGrowsWithScattering) {
    SeaSettings s;
    s.ior = 1.333f;
    EXPECT_EQ(seaReflectance(s), glm::vec3(0));
    s.backscattering = glm::vec3(1, 0.01f, 0);
    s.absorption = glm::vec3(0, 0.09f, 1);
    const double out = meanThrough(1.333f) / (1.333 * 1.333);
    EXPECT_NEAR(out, 0.53, 0.005);
    const glm::vec3 r = seaReflectance(s);
    EXPECT_NEAR(double(r.x), 0.33 * out / (1 - 0.33 * (1 - out)), 1e-4);
    EXPECT_NEAR(double(r.y), 0.033 * out / (1 - 0.033 * (1 - out)), 1e-5);
    EXPECT_EQ(r.z, 0);
}

}  // namespace
}  // namespace gp
