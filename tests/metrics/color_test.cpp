#include "metrics/color.h"

#include <gtest/gtest.h>

#include "metrics/magma.h"

namespace gp::metrics {
namespace {

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Color, WhiteIsTheWhitePoint) {
    expectNear(relativeXyzFromLinear(glm::vec3(1.0f)), glm::vec3(1.0f), 1.0e-6f);
    expectNear(labFromLinear(glm::vec3(1.0f)), glm::vec3(100, 0, 0), 2.0e-4f);
    expectNear(labFromLinear(glm::vec3(0.0f)), glm::vec3(0.0f), 1.0e-5f);
}

// Values as colour calculators give them for sRGB under D65.
TEST(Color, LabOfThePrimaries) {
    expectNear(labFromLinear(glm::vec3(1, 0, 0)), glm::vec3(53.24f, 80.09f, 67.20f), 0.03f);
    expectNear(labFromLinear(glm::vec3(0, 1, 0)), glm::vec3(87.735f, -86.183f, 83.179f), 0.03f);
    expectNear(labFromLinear(glm::vec3(0, 0, 1)), glm::vec3(32.297f, 79.188f, -107.860f), 0.03f);
}

TEST(Color, SrgbRoundTripAndKnownValues) {
    for (int i = 0; i <= 255; ++i) {
        const float encoded = static_cast<float>(i) / 255.0f;
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(encoded)), encoded, 1.0e-6f);
    }
    EXPECT_NEAR(linearFromSrgb(0.5f), 0.21404f, 1.0e-5f);
    EXPECT_NEAR(srgbFromLinear(0.18f), 0.46136f, 1.0e-5f);
}

TEST(Color, YcxczRoundTripAndAgreementWithLab) {
    const glm::vec3 color(0.3f, 0.7f, 0.1f);
    expectNear(linearFromYcxcz(ycxczFromLinear(color)), color, 1.0e-5f);
    // Its lightness of white is that of L*a*b*; greys have no chroma.
    expectNear(ycxczFromLinear(glm::vec3(1.0f)), glm::vec3(100, 0, 0), 2.0e-4f);
    expectNear(ycxczFromLinear(glm::vec3(0.4f)), glm::vec3(30.4f, 0, 0), 2.0e-4f);
}

TEST(Color, HyabAddsLightnessToChromaDistance) {
    EXPECT_FLOAT_EQ(hyabDistance(glm::vec3(10, 3, 4), glm::vec3(3, 0, 0)), 12.0f);
    expectNear(huntAdjusted(glm::vec3(50, 20, -40)), glm::vec3(50, 10, -20), 1.0e-5f);
}

// Values of the full table of 256 between the ten that we keep.
TEST(Magma, IsCloseToTheFullTable) {
    const glm::vec3 tolerance(8.0f);
    const auto expectClose = [&](float t, glm::vec3 bytes) {
        const glm::vec3 d = glm::abs(255.0f * magmaSrgb(t) - bytes);
        EXPECT_TRUE(d.x <= tolerance.x && d.y <= tolerance.y && d.z <= tolerance.z) << "at " << t;
    };
    expectClose(0.0f, {0x00, 0x00, 0x04});
    expectClose(0.25f, {0x51, 0x12, 0x7c});
    expectClose(0.5f, {0xb6, 0x36, 0x79});
    expectClose(0.75f, {0xfb, 0x88, 0x61});
    expectClose(1.0f, {0xfc, 0xfd, 0xbf});
}

TEST(Magma, GrowsBrighterAndClampsOutside) {
    float before = -1;
    for (int i = 0; i <= 100; ++i) {
        const float now = luminance(linearFromSrgb(magmaSrgb(static_cast<float>(i) / 100.0f)));
        EXPECT_GT(now, before);
        before = now;
    }
    EXPECT_EQ(magmaSrgb(-1.0f), magmaSrgb(0.0f));
    EXPECT_EQ(magmaSrgb(2.0f), magmaSrgb(1.0f));
}

}  // namespace
}  // namespace gp::metrics
