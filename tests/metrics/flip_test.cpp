#include "metrics/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brute_force_flip.h"
#include "metrics/flip_color.h"
#include "metrics/flip_features.h"
#include "test_pictures.h"

namespace gp::metrics {
namespace {

TEST(Flip, IdenticalPicturesDifferByExactlyNothing) {
    const Picture picture = noisePicture(40, 30, 1);
    const FlipResult ldr = ldrFlip(picture, picture);
    const FlipResult hdr = hdrFlip(scaledPicture(picture, 9), scaledPicture(picture, 9));
    EXPECT_EQ(ldr.mean, 0.0);
    EXPECT_EQ(hdr.mean, 0.0);
    for (float error : ldr.map.pixels) {
        EXPECT_EQ(error, 0.0f);
    }
}

// Filters leave uniform pictures alone and find no features in them, so that FLIP is the colour
// error of the two colours, which the test computes by itself.
TEST(Flip, UniformPicturesGiveTheColorError) {
    const glm::vec3 pairs[][2] = {{{0.2f, 0.4f, 0.6f}, {0.25f, 0.4f, 0.6f}},
                                  {{0.5f, 0.5f, 0.5f}, {0.52f, 0.52f, 0.52f}},
                                  {{0.9f, 0.1f, 0.1f}, {0.1f, 0.1f, 0.9f}},
                                  {{0.01f, 0.02f, 0.01f}, {0.02f, 0.01f, 0.02f}},
                                  {{0.0f, 1.0f, 0.0f}, {0.7f, 0.0f, 0.9f}}};
    for (const auto& pair : pairs) {
        const FlipResult flip =
            ldrFlip(uniformPicture(9, 7, pair[0]), uniformPicture(9, 7, pair[1]));
        EXPECT_NEAR(flip.mean, bruteForceColorError(pair[0], pair[1]), 3.0e-3);
    }
}

// L* differs by 100 and chroma by nothing: 100^0.7 on the scale on which green against blue is 1.
TEST(Flip, BlackAgainstWhiteInClosedForm) {
    const FlipResult flip = ldrFlip(uniformPicture(5, 5, glm::vec3(0.0f)),
                                    uniformPicture(5, 5, glm::vec3(1.0f)));
    const double largest = 41.276;  // (L*a*b* of the two primaries, Hunt, HyAB)^0.7
    const double expected =
        0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest);
    EXPECT_NEAR(flip.mean, expected, 2.0e-4);
}

TEST(Flip, GreenAgainstBlueIsTheLargestError) {
    EXPECT_NEAR(colorError(glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)), 1.0f, 1.0e-6f);
    const Picture colors = noisePicture(64, 2, 5);
    for (int i = 0; i < 64; ++i) {
        const float error = colorError(colors.at(i, 0), colors.at(i, 1));
        EXPECT_GE(error, 0.0f);
        EXPECT_LT(error, 1.0f);
    }
}

TEST(Flip, EqualsTheBruteForceEvaluation) {
    for (double pixelsPerDegree : {20.0, kPixelsPerDegree}) {
        const Picture a = noisePicture(26, 19, 11);
        Picture b = a;
        b.at(5, 5) = glm::vec3(1.0f);
        b.at(20, 12) = glm::vec3(0.0f);
        for (int x = 0; x < 26; ++x) {
            b.at(x, 15) *= 0.5f;
        }
        const FlipResult fast = ldrFlip(b, a, pixelsPerDegree);
        const std::vector<double> slow = bruteForceFlip(b, a, pixelsPerDegree);
        for (std::size_t i = 0; i < slow.size(); ++i) {
            EXPECT_NEAR(fast.map.pixels[i], slow[i], 5.0e-3) << "pixel " << i;
        }
    }
}

TEST(Flip, IsSymmetric) {
    const Picture a = noisePicture(33, 21, 3);
    const Picture b = noisePicture(33, 21, 4);
    EXPECT_DOUBLE_EQ(ldrFlip(a, b).mean, ldrFlip(b, a).mean);
}

TEST(Flip, TheMeanIsThatOfTheMapAndTheMapStaysInRange) {
    const FlipResult flip = ldrFlip(noisePicture(33, 21, 3), stepPicture(33, 21, 16));
    double sum = 0;
    for (float error : flip.map.pixels) {
        EXPECT_GE(error, 0.0f);
        EXPECT_LE(error, 1.0f);
        sum += error;
    }
    EXPECT_NEAR(flip.mean, sum / (33 * 21), 1.0e-9);
    EXPECT_GT(flip.mean, 0.1);
}

TEST(Flip, GrowsWithTheDifference) {
    const Picture reference = uniformPicture(40, 40, glm::vec3(0.4f));
    double before = 0;
    for (float amount : {0.02f, 0.05f, 0.1f, 0.2f}) {
        const Picture noise = noisePicture(40, 40, 7, 0.4f - amount, 0.4f + amount);
        const double now = ldrFlip(noise, reference).mean;
        EXPECT_GT(now, before);
        before = now;
    }
}

// A moved edge is worse than a change of colour alone: features amplify.
TEST(Flip, FeaturesAmplify) {
    const Plane step = [] {
        Plane plane(60, 40);
        for (int y = 0; y < 40; ++y) {
            for (int x = 30; x < 60; ++x) {
                plane.at(x, y) = 1.0f;
            }
        }
        return plane;
    }();
    const Features features = detectFeatures(step, kPixelsPerDegree);
    // A step through the middle of a balanced detector weighs all of one sign.
    EXPECT_NEAR(features.edges.at(30, 20), 1.0f, 0.02f);
    EXPECT_NEAR(features.edges.at(5, 20), 0.0f, 1.0e-5f);
    EXPECT_NEAR(features.points.at(5, 20), 0.0f, 1.0e-5f);
    EXPECT_FLOAT_EQ(featureError(1, 1, 0.5f, 0.5f), 0.0f);
    EXPECT_FLOAT_EQ(featureError(1, 0, 0.5f, 0.5f), std::sqrt(1.0f / std::sqrt(2.0f)));
    EXPECT_FLOAT_EQ(featureError(0, 0, 0.5f, 0), std::sqrt(0.5f / std::sqrt(2.0f)));
}

TEST(HdrFlip, ExposuresBringBrightestAndMedianToTheSameGrey) {
    Picture reference(3, 1);
    reference.at(0, 0) = glm::vec3(0.25f);
    reference.at(1, 0) = glm::vec3(1.0f);
    reference.at(2, 0) = glm::vec3(16.0f);
    const ExposureRange range = exposureRange(reference);
    EXPECT_NEAR(range.stop - range.start, 4.0, 1.0e-5);
    EXPECT_EQ(range.count, 4);
    const float brightest = 16.0f * std::exp2(static_cast<float>(range.start));
    const float median = 1.0f * std::exp2(static_cast<float>(range.stop));
    EXPECT_NEAR(acesTonemap(glm::vec3(brightest)).y, 0.85f, 1.0e-5f);
    EXPECT_NEAR(acesTonemap(glm::vec3(median)).y, 0.85f, 1.0e-5f);
}

TEST(HdrFlip, BlackReferenceIsNoProblem) {
    const Picture black = uniformPicture(12, 12, glm::vec3(0.0f));
    EXPECT_EQ(hdrFlip(black, black).mean, 0.0);
    const double flip = hdrFlip(uniformPicture(12, 12, glm::vec3(1.0f)), black).mean;
    EXPECT_GT(flip, 0.5);
    EXPECT_LE(flip, 1.0);
}

// Exposures follow the reference, so the unit of radiance does not matter.
TEST(HdrFlip, DoesNotDependOnTheUnit) {
    const Picture a = noisePicture(30, 24, 21, 0.0f, 4.0f);
    const Picture b = noisePicture(30, 24, 22, 0.0f, 4.0f);
    const double one = hdrFlip(a, b).mean;
    const double many = hdrFlip(scaledPicture(a, 64), scaledPicture(b, 64)).mean;
    EXPECT_NEAR(one, many, 1.0e-5);
}

// The largest of all exposures is at least that of each of them.
TEST(HdrFlip, IsAtLeastTheErrorOfItsFirstExposure) {
    const Picture a = noisePicture(30, 24, 31, 0.0f, 4.0f);
    const Picture b = noisePicture(30, 24, 32, 0.0f, 4.0f);
    const ExposureRange range = exposureRange(b);
    const auto shown = [&](Picture picture) {
        for (glm::vec3& pixel : picture.pixels) {
            pixel = acesTonemap(pixel * std::exp2(static_cast<float>(range.start)));
        }
        return picture;
    };
    EXPECT_GE(hdrFlip(a, b).mean, ldrFlip(shown(a), shown(b)).mean);
}

}  // namespace
}  // namespace gp::metrics
