// Comparisons with noisy references say what comparisons with the truth would.
#include "metrics/noisy_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "metrics/pixel_errors.h"
#include "metrics/ssim.h"
#include "test_pictures.h"

namespace gp::metrics {
namespace {

constexpr int kSize = 128;

// Waves of several lengths: something for SSIM to find.
Picture truth() {
    Picture picture(kSize, kSize);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            picture.at(x, y) = glm::vec3(0.5f + 0.1f * static_cast<float>(std::sin(0.4 * x)) +
                                         0.1f * static_cast<float>(std::cos(0.13 * x + 0.3 * y)));
        }
    }
    return picture;
}

// Grey noise, so that linear values stay within 0..1.
Picture withNoise(Picture picture, float deviation, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0, deviation);
    for (glm::vec3& pixel : picture.pixels) {
        pixel += glm::vec3(normal(random));
    }
    return picture;
}

Plane greyOf(const Picture& picture) {
    Plane plane(picture.width, picture.height);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i) {
        plane.pixels[i] = picture.pixels[i].x;
    }
    return plane;
}

TEST(NoisyReference, MeanSquaredErrorIsThatAgainstTheTruth) {
    const Picture test = withNoise(truth(), 0.03f, 1);
    const Picture a = withNoise(truth(), 0.1f, 2);
    const Picture b = withNoise(truth(), 0.1f, 3);
    const double expected = meanSquaredError(test, truth());
    // Each product deviates by about 0.01; 16,384 of them.
    EXPECT_NEAR(compareWithPair(test, {a, b}).mse, expected, 3 * 0.01 / kSize);
    EXPECT_GT(meanSquaredError(test, a), 5 * expected);
}

TEST(NoisyReference, SsimIsThatAgainstTheTruth) {
    const Plane perfect = greyOf(truth());
    const Plane a = greyOf(withNoise(truth(), 0.05f, 2));
    const Plane b = greyOf(withNoise(truth(), 0.05f, 3));
    for (const float deviation : {0.0f, 0.02f, 0.06f}) {
        const Plane test = greyOf(withNoise(truth(), deviation, 1));
        const double expected = ssim(test, perfect);
        EXPECT_NEAR(ssim(test, a, b), expected, 0.02) << deviation;
        EXPECT_LT(ssim(test, a), expected - 0.05) << deviation;
    }
    EXPECT_EQ(ssim(perfect, perfect, perfect), ssim(perfect, perfect));
}

TEST(NoisyReference, NoiseIsThatOfTheMean) {
    const ReferencePair pair{withNoise(truth(), 0.1f, 2), withNoise(truth(), 0.1f, 3)};
    const double measured = std::sqrt(meanSquaredError(pair.mean(), truth()));
    EXPECT_NEAR(noiseOf(pair).rmse, 0.1 / std::sqrt(2.0), 0.002);
    EXPECT_NEAR(noiseOf(pair).rmse, measured, 0.002);
    EXPECT_LT(noiseOf(pair).ssim, 0.9);
    EXPECT_EQ(noiseOf({truth(), truth()}).rmse, 0.0);
}

TEST(NoisyReference, FlipIsOfTheMean) {
    const ReferencePair pair{uniformPicture(32, 32, glm::vec3(0.2f)),
                             uniformPicture(32, 32, glm::vec3(0.4f))};
    EXPECT_NEAR(compareWithPair(uniformPicture(32, 32, glm::vec3(0.3f)), pair).flip.mean, 0, 1e-3);
    EXPECT_GT(compareWithPair(pair.a, pair).flip.mean, 0.05);
}

}  // namespace
}  // namespace gp::metrics
