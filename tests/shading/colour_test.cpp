// Colour and spherical harmonics.
#include "shading/shading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random.h"

namespace gp::shading {
namespace {

using test::Random;

TEST(Powers, AreThoseOfTheStandardLibrary) {
    for (double x = 1e-37; x < 1e38; x *= 1.003) {
        const double log2 = std::log2(double(float(x)));
        EXPECT_NEAR(log2_above_0(float(x)), log2, 3e-7 + 6e-8 * std::abs(log2)) << x;
    }
    EXPECT_EQ(log2_above_0(1.0f), 0.0f);
    EXPECT_EQ(log2_above_0(8.0f), 3.0f);
    for (float x = -125.9f; x < 126.0f; x += 0.0137f) {
        EXPECT_NEAR(exp2_within_126(x) / std::exp2(double(x)), 1.0, 3e-7) << x;
    }
    EXPECT_EQ(exp2_within_126(-3.0f), 0.125f);
    for (const float exponent : {1.0f / 2.4f, 2.2f}) {
        for (float x = 1e-6f; x <= 1.0f; x *= 1.01f) {
            const double power = std::pow(double(x), double(exponent));
            EXPECT_NEAR(pow_above_0(x, exponent) / power, 1.0, 4e-7 - 1e-7 * std::log2(power))
                << x;
        }
        EXPECT_EQ(pow_above_0(1.0f, exponent), 1.0f);
        EXPECT_LT(pow_above_0(0.0f, exponent), 1e-12f);
    }
}

TEST(Colour, SrgbRoundTripAndKnownValues) {
    for (int i = 0; i <= 1000; ++i) {
        const float v = float(i) / 1000.0f;
        EXPECT_NEAR(srgb_decode_1(srgb_encode_1(v)), v, 2e-6f);
        EXPECT_NEAR(srgb_encode_1(srgb_decode_1(v)), v, 2e-6f);
    }
    EXPECT_NEAR(srgb_decode_1(0.5f), 0.21404114f, 1e-6f);
    EXPECT_NEAR(srgb_encode_1(0.18f), 0.46135613f, 1e-6f);
    EXPECT_NEAR(srgb_encode_1(0.0031308f), 0.04045f, 1e-5f);  // where the pieces meet
    EXPECT_NEAR(luminance(vec3(1.0f)), 1.0f, 1e-6f);
}

// Grey stays grey, more light is never darker, black is black, and the brightest is in range.
TEST(Colour, ToneMapsKeepGreyAndOrder) {
    struct Named {
        const char* name;
        vec3 (*map)(vec3);
        float tint;   // how far from grey the published matrices leave a grey
        float black;  // what they make of black
    };
    const Named maps[] = {{"reinhard", tonemap_reinhard, 1e-6f, 0.0f},
                          {"aces", tonemap_aces, 2e-4f, 1e-6f},
                          {"agx", tonemap_agx, 2e-3f, 1e-6f}};
    for (const Named& m : maps) {
        float last = -1.0f;
        EXPECT_LE(m.map(vec3(0.0f)).x, m.black) << m.name;
        for (float ev = -12.0f; ev <= 12.0f; ev += 0.25f) {
            const vec3 c = m.map(vec3(0.18f * std::exp2(ev)));
            EXPECT_NEAR(c.x, c.y, m.tint) << m.name << " " << ev;
            EXPECT_NEAR(c.z, c.y, m.tint) << m.name << " " << ev;
            EXPECT_GE(c.y, last - 1e-6f) << m.name << " " << ev;
            EXPECT_TRUE(c.y >= 0.0f && c.y <= 1.0f);
            last = c.y;
        }
        EXPECT_GT(last, 0.9f) << m.name;
        for (const vec3& wild : {vec3(1e30f), vec3(-1.0f, 2.0f, 0.5f), vec3(65504.0f, 0, 0)}) {
            const vec3 c = m.map(wild);
            EXPECT_TRUE(all(greaterThanEqual(c, vec3(0.0f))) && all(lessThanEqual(c, vec3(1.0f))))
                << m.name;
        }
    }
}

TEST(Colour, ToneMapsHaveTheirPublishedValues) {
    EXPECT_NEAR(tonemap_reinhard(vec3(REINHARD_WHITE)).x, 1.0f, 1e-6f);
    EXPECT_NEAR(tonemap_reinhard(vec3(1.0f)).x, (1.0f + 1.0f / 16.0f) / 2.0f, 1e-6f);
    // Hill's curve at 1: (1.0245786 - 0.000090537) / (0.983729 + 0.432951 + 0.238081) = 0.6191.
    EXPECT_NEAR(tonemap_aces(vec3(1.0f)).y, 0.6191f, 1e-3f);
    // AgX: middle grey is at 10 of 16.5 stops, where the polynomial gives 0.4967 of the signal.
    EXPECT_NEAR(tonemap_agx(vec3(0.18f)).y, std::pow(0.4967f, 2.2f), 1e-3f);
    EXPECT_GT(tonemap_agx(vec3(0.18f * 91.0f)).y, 0.95f);  // 6.5 stops above grey is white
}

// A smooth function on the sphere, for the integrals below.
float lobes(vec3 d) { return std::exp(d.x) + 2.0f * std::max(d.z, 0.0f) + 0.3f; }

TEST(Sh, BasisIsOrthonormal) {
    glm::dmat4 gram(0.0);
    constexpr int n = 256;
    for (int i = 0; i < n * n; ++i) {
        const vec2 u((float(i % n) + 0.5f) / n, (float(i / n) + 0.5f) / n);
        const glm::dvec4 b(sh_basis(square_to_uniform_sphere(u)));
        gram += glm::outerProduct(b, b) * (4.0 * M_PI / (n * n));
    }
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            EXPECT_NEAR(gram[i][j], i == j ? 1.0 : 0.0, 1e-4);
        }
    }
}

TEST(Sh, ProjectionAndIrradianceEqualIntegrals) {
    // Radiance that is itself of degree 1 is kept, and its irradiance is exact.
    const auto linear = [](vec3 d) { return 2.0f + 0.5f * d.x - 0.7f * d.y + 1.1f * d.z; };
    ShRgb sh = sh_rgb_zero();
    constexpr int n = 256;
    const float weight = FOUR_PI / (n * n);
    for (int i = 0; i < n * n; ++i) {
        const vec2 u((float(i % n) + 0.5f) / n, (float(i / n) + 0.5f) / n);
        const vec3 d = square_to_uniform_sphere(u);
        sh = sh_rgb_add(sh, d, vec3(linear(d), lobes(d), 1.0f) * weight);
    }
    for (const vec3& v : {vec3(0, 0, 1), vec3(0, -1, 0), vec3(3, 4, -5)}) {
        const vec3 normal = normalize(v);
        EXPECT_NEAR(sh_rgb_eval(sh, normal).x, linear(normal), 2e-3f);
        dvec3 exact(0.0);
        for (int i = 0; i < n * n; ++i) {
            const vec2 u((float(i % n) + 0.5f) / n, (float(i / n) + 0.5f) / n);
            const vec3 d = square_to_uniform_sphere(u);
            exact += dvec3(vec3(linear(d), lobes(d), 1.0f)) *
                     (double(std::max(0.0f, dot(d, normal))) * weight);
        }
        const vec3 e = sh_rgb_irradiance(sh, normal);
        EXPECT_NEAR(double(e.x), exact.x, 3e-3);
        EXPECT_NEAR(double(e.z), exact.z, 3e-3);
        EXPECT_NEAR(double(e.y) / exact.y, 1.0, 0.1);  // cut off at l = 1, as the header says
    }
}

TEST(Sh, LumaEqualsRgbForOneColour) {
    Random random(1);
    const vec3 colour(0.9f, 0.4f, 0.1f);
    ShRgb rgb = sh_rgb_zero();
    ShLuma luma = sh_luma_zero();
    for (int i = 0; i < 100; ++i) {
        const float x = random.uniform();
        const vec3 d = square_to_cosine_hemisphere(vec2(x, random.uniform()));
        const vec3 power = colour * random.uniform();
        rgb = sh_rgb_add(rgb, d, power);
        luma = sh_luma_add(luma, d, power);
    }
    for (const vec3& n : {vec3(0, 0, 1), vec3(1, 0, 0), normalize(vec3(1, -2, 1))}) {
        const vec3 a = sh_rgb_irradiance(rgb, n);
        EXPECT_LT(distance(a, sh_luma_irradiance(luma, n)), 1e-4f * length(a));
    }
    EXPECT_EQ(sh_luma_irradiance(sh_luma_zero(), vec3(0, 0, 1)), vec3(0.0f));
}

TEST(Rgb9e5, EveryCodeComesBack) {
    for (uint exponent = 0; exponent < 32; ++exponent)
        for (uint m = 0; m < 512; ++m) {
            const uint code = m | (m ^ 511u) << 9 | (511u - m / 2) << 18 | exponent << 27;
            const vec3 v = rgb9e5_decode(code);
            EXPECT_EQ(rgb9e5_decode(rgb9e5_encode(v)), v) << exponent << " " << m;
        }
}

TEST(Rgb9e5, RoundsToNearestOfTheLargest) {
    Random random(3);
    double error = 0;
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
        const float size = std::exp2(30.0f * random.uniform() - 15.0f);
        const vec3 v = size * vec3(random.uniform(), random.uniform(), random.uniform());
        const vec3 back = rgb9e5_decode(rgb9e5_encode(v));
        const float most = std::max({v.x, v.y, v.z});
        for (int c = 0; c < 3; ++c) ASSERT_LE(std::abs(back[c] - v[c]), most / 511.0f + 3.1e-8f);
        error += double(back.y - v.y) / double(most);
    }
    EXPECT_NEAR(error / count, 0, 1e-5);  // no bias: half a step is 1e-3
}

TEST(Rgb9e5, ClampsWhatItCannotHold) {
    const float infinity = INFINITY, none = NAN;
    EXPECT_EQ(rgb9e5_decode(rgb9e5_encode(vec3(none, -1, 0))), vec3(0));
    EXPECT_EQ(rgb9e5_decode(rgb9e5_encode(vec3(infinity, 1e9f, none))),
              vec3(RGB9E5_LARGEST, RGB9E5_LARGEST, 0));
    EXPECT_EQ(rgb9e5_decode(rgb9e5_encode(vec3(511.9f, 0, 0))).x, 512.0f);  // the next exponent
}

}  // namespace
}  // namespace gp::shading
