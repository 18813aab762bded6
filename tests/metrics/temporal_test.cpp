// Flicker and afterglow of sequences that are known.
#include "metrics/temporal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gp::metrics {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;

Plane noise(float deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0, deviation);
    Plane plane(kWidth, kHeight);
    for (float& p : plane.pixels) {
        p = normal(random);
    }
    return plane;
}

// Against references without noise: both errors are one.
ErrorPair twice(const Plane& error) {
    return {error, error};
}

double flicker(const Plane& error, const Plane& previous, const Motion* motion = nullptr,
               const Plane* seen = nullptr) {
    return std::sqrt(squaredFlicker(twice(error), twice(previous), motion, seen));
}

Plane shifted(const Plane& plane, int right) {
    Plane result(plane.width, plane.height, 7.0f);
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            if (x - right >= 0 && x - right < plane.width) {
                result.at(x, y) = plane.at(x - right, y);
            }
        }
    }
    return result;
}

// Everything moved to the right by that many pixels, at a depth of 5 m.
Motion motionOf(float right) {
    Motion motion;
    motion.toPrevious = Offsets(kWidth, kHeight, glm::vec2(-right, 0));
    motion.previousDepth = Plane(kWidth, kHeight, 5.0f);
    motion.slope = Plane(kWidth, kHeight, 0.0f);
    return motion;
}

TEST(Flicker, ErrorsThatStayDoNot) {
    const Plane error = noise(0.3f, 1);
    EXPECT_EQ(flicker(error, error), 0.0);
    const Motion motion = motionOf(0);
    EXPECT_LT(flicker(error, error, &motion), 1e-6);
}

TEST(Flicker, OfWhiteNoiseIsItsDeviationTimesRootTwo) {
    // 6,144 pixels: the deviation of the estimate is about 1 %.
    EXPECT_NEAR(flicker(noise(0.1f, 1), noise(0.1f, 2)), 0.1 * std::sqrt(2.0), 0.005);
    EXPECT_NEAR(flicker(Plane(kWidth, kHeight, 0.25f), Plane(kWidth, kHeight, 0.0f)), 0.25, 1e-6);
}

Plane sum(const Plane& a, const Plane& b) {
    Plane result = a;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        result.pixels[i] += b.pixels[i];
    }
    return result;
}

// Four times as much noise as the picture has, in references that are new in each frame.
TEST(Flicker, NoiseOfReferencesIsNone) {
    const Plane now = noise(0.1f, 1);
    const Plane before = noise(0.1f, 2);
    const ErrorPair errors{sum(now, noise(0.4f, 3)), sum(now, noise(0.4f, 4))};
    const ErrorPair previous{sum(before, noise(0.4f, 5)), sum(before, noise(0.4f, 6))};
    // The product of two changes of variance 0.02 + 0.32 deviates by 0.34 in each pixel.
    const double deviation = 0.34 / std::sqrt(double(kWidth * kHeight));
    EXPECT_NEAR(squaredFlicker(errors, previous), 0.02, 3 * deviation);
    EXPECT_GT(flicker(errors.a, previous.a), 0.5);
}

TEST(Flicker, FollowsTheMotion) {
    const Plane before = noise(0.2f, 3);
    const Plane now = shifted(before, 4);  // the left four columns are new, and wrong by 7
    const Motion motion = motionOf(4);
    EXPECT_LT(flicker(now, before, &motion), 1e-6);
    EXPECT_GT(flicker(now, before), 0.2);
}

// A pattern of half the sampling frequency or less survives interpolation.
TEST(Flicker, FollowsMotionBetweenPixels) {
    Plane before(kWidth, kHeight);
    Plane now(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            before.at(x, y) = static_cast<float>(std::sin(0.1 * x));
            now.at(x, y) = static_cast<float>(std::sin(0.1 * (x - 2.5)));
        }
    }
    const Motion motion = motionOf(2.5f);
    EXPECT_LT(flicker(now, before, &motion), 0.01);
    EXPECT_GT(flicker(now, before), 0.1);
}

TEST(Flicker, WhatWasHiddenDoesNotCount) {
    Plane before(kWidth, kHeight, 0.0f);
    Plane now(kWidth, kHeight, 0.0f);
    Plane seen(kWidth, kHeight, 5.0f);
    const Motion motion = motionOf(0);
    for (int y = 0; y < kHeight; ++y) {
        now.at(10, y) = 1.0f;
        seen.at(10, y) = 2.0f;  // something stood before it
    }
    EXPECT_GT(flicker(now, before, &motion), 0.05);
    EXPECT_EQ(flicker(now, before, &motion, &seen), 0.0);
    seen = Plane(kWidth, kHeight, 5.01f);  // within a hundredth it is the same surface
    EXPECT_GT(flicker(now, before, &motion, &seen), 0.05);
    seen = Plane(kWidth, kHeight, 1.0f);
    EXPECT_EQ(flicker(now, before, &motion, &seen), 0.0);
}

TEST(Afterglow, IsTheShareOfTheLightThatStillShows) {
    Plane step(kWidth, kHeight, 0.0f);
    for (int i = 0; i < 400; ++i) {
        step.pixels[std::size_t(i)] = 0.01f * static_cast<float>(i);
    }
    Plane error = noise(0.3f, 5);
    const double ofNoise = *afterglow(twice(error), twice(step));
    EXPECT_NEAR(ofNoise, 0, 0.02);
    for (std::size_t i = 0; i < error.pixels.size(); ++i) {
        error.pixels[i] += 0.4f * step.pixels[i];
    }
    EXPECT_NEAR(*afterglow(twice(error), twice(step)), 0.4 + ofNoise, 1e-6);
    EXPECT_FALSE(afterglow(twice(error), twice(Plane(kWidth, kHeight, 0.0f))));
}

// The noise of a reference is in its error and in its step, with opposite signs of one root: the
// product of both would take it for light that is gone.
TEST(Afterglow, NoiseOfReferencesIsNone) {
    const Plane light(kWidth, kHeight, 0.2f);
    const Plane a = noise(0.3f, 1);
    const Plane b = noise(0.3f, 2);
    const ErrorPair errors{a, b};  // the light is gone: nothing but noise
    const ErrorPair step{sum(light, a), sum(light, b)};
    EXPECT_NEAR(*afterglow(errors, step), 0, 0.06);  // 0.3 (0.2 + 0.3) / 0.04 / sqrt(pixels), less
    const Plane& own = step.a;
    EXPECT_GT(*afterglow({a, a}, {own, own}), 0.5);
}

// A history of frames that keeps the share k: after n frames k^n is left.
TEST(Lag, OfExponentialHistoriesIsKnown) {
    const auto decay = [](double keep) {
        std::vector<double> shares;
        for (double share = keep; shares.size() < 100; share *= keep) {
            shares.push_back(share);
        }
        return shares;
    };
    EXPECT_EQ(lagFrames(decay(0.05), 0.1), 0u);
    EXPECT_EQ(lagFrames(decay(0.3), 0.1), 1u);   // 0.3, 0.09
    EXPECT_EQ(lagFrames(decay(0.9), 0.1), 21u);  // 0.9^22 = 0.098
    EXPECT_FALSE(lagFrames(decay(0.99), 0.1));
    EXPECT_FALSE(lagFrames({}, 0.1));
    const double returns[] = {0.01, 0.02, -0.5, 0.01};
    EXPECT_EQ(lagFrames(returns, 0.1), 3u);
}

}  // namespace
}  // namespace gp::metrics
