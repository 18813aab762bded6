// Angles in turns against the library's functions in double precision.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "shading/shading.h"

namespace gp::shading {
namespace {

TEST(Trigonometry, SineAndCosineOfTurns) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> wide(-1000.0f, 1000.0f), unit(0.0f, 1.0f);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        const float turns = i % 2 ? unit(random) : wide(random);
        const SinCos a = sincos_turns(turns);
        const double angle = 2 * M_PI * std::remainder(double(turns), 1.0);
        worst = std::max({worst, std::abs(double(a.s) - std::sin(angle)),
                          std::abs(double(a.c) - std::cos(angle))});
    }
    EXPECT_LT(worst, 1.5e-7);
}

TEST(Trigonometry, QuartersAreExact) {
    for (int q = -4; q <= 8; ++q) {
        const SinCos a = sincos_turns(0.25f * float(q));
        const int wrapped = (q + 8) & 3;
        EXPECT_EQ(a.s, wrapped == 1 ? 1.0f : wrapped == 3 ? -1.0f : 0.0f) << q;
        EXPECT_EQ(a.c, wrapped == 0 ? 1.0f : wrapped == 2 ? -1.0f : 0.0f) << q;
    }
}

TEST(Trigonometry, TurnsOfVectors) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> range(-1.0f, 1.0f);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        const float scale = std::exp2(20 * range(random));
        const float x = scale * range(random), y = scale * range(random);
        const double turns = std::atan2(double(y), double(x)) / (2 * M_PI);
        worst = std::max(worst, std::abs(double(turns_from_vector(y, x)) - turns));
    }
    EXPECT_LT(worst, 6e-8);
    EXPECT_EQ(turns_from_vector(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(turns_from_vector(0.0f, -2.0f), 0.5f);
    EXPECT_EQ(turns_from_vector(-3.0f, 0.0f), -0.25f);
}

}  // namespace
}  // namespace gp::shading
