#include "metrics/compare_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "metrics/color.h"
#include "metrics/pixel_errors.h"
#include "metrics/ssim.h"
#include "test_pictures.h"

namespace gp::metrics {
namespace {

Plane greyOf(const Picture& picture) {
    Plane plane(picture.width, picture.height);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i) {
        plane.pixels[i] = picture.pixels[i].x;
    }
    return plane;
}

// [Wang et al. 2004, section III] for one window, straight from the definitions.
double windowSsim(const Plane& a, const Plane& b, int cx, int cy) {
    double weights = 0, ma = 0, mb = 0;
    const auto weight = [](int x, int y) { return std::exp(-(x * x + y * y) / 4.5); };
    for (int y = -5; y <= 5; ++y) {
        for (int x = -5; x <= 5; ++x) {
            weights += weight(x, y);
            ma += weight(x, y) * a.at(cx + x, cy + y);
            mb += weight(x, y) * b.at(cx + x, cy + y);
        }
    }
    ma /= weights;
    mb /= weights;
    double va = 0, vb = 0, cov = 0;
    for (int y = -5; y <= 5; ++y) {
        for (int x = -5; x <= 5; ++x) {
            const double w = weight(x, y) / weights;
            const double da = a.at(cx + x, cy + y) - ma, db = b.at(cx + x, cy + y) - mb;
            va += w * da * da;
            vb += w * db * db;
            cov += w * da * db;
        }
    }
    return (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) /
           ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
}

TEST(Ssim, EqualsItsDefinition) {
    const Plane a = greyOf(noisePicture(17, 14, 1));
    const Plane b = greyOf(noisePicture(17, 14, 2));
    double sum = 0;
    for (int y = 5; y < 9; ++y) {
        for (int x = 5; x < 12; ++x) {
            sum += windowSsim(a, b, x, y);
        }
    }
    EXPECT_NEAR(ssim(a, b), sum / 28, 1.0e-5);
}

TEST(Ssim, KnownCases) {
    const Plane noise = greyOf(noisePicture(40, 40, 3));
    EXPECT_NEAR(ssim(noise, noise), 1.0, 1.0e-9);
    const Plane a(20, 20, 0.3f);
    const Plane b(20, 20, 0.5f);
    EXPECT_NEAR(ssim(a, b), (2 * 0.3 * 0.5 + 1e-4) / (0.09 + 0.25 + 1e-4), 1.0e-4);
    Plane inverse = noise;
    for (float& v : inverse.pixels) {
        v = 1.0f - v;
    }
    EXPECT_LT(ssim(noise, inverse), -0.8);
    EXPECT_DOUBLE_EQ(ssim(noise, inverse), ssim(inverse, noise));
    const Plane tiny(3, 2, 0.4f);
    EXPECT_NEAR(ssim(tiny, tiny), 1.0, 1.0e-9);
}

TEST(PixelErrors, ByHand) {
    Picture a(2, 1);
    Picture b(2, 1);
    a.at(0, 0) = glm::vec3(1, 2, 3);
    b.at(0, 0) = glm::vec3(1, 1, 1);
    a.at(1, 0) = glm::vec3(0, 0, 1);
    b.at(1, 0) = glm::vec3(0, 0, 0);
    EXPECT_NEAR(meanSquaredError(a, b), (1.0 + 4.0 + 1.0) / 6, 1.0e-12);
    EXPECT_NEAR(relativeMse(a, b), (1 / 1.01 + 4 / 1.01 + 1 / 0.01) / 6, 1.0e-9);
    EXPECT_NEAR(meanColor(a).z, 2.0, 1.0e-12);
    EXPECT_NEAR(psnr(0.01), 20.0, 1.0e-12);
    EXPECT_TRUE(std::isinf(psnr(0.0)));
}

TEST(ComparePictures, DisplayPicturesAreMeasuredAsShown) {
    const Picture a = uniformPicture(16, 16, glm::vec3(0.2f));
    const Picture b = uniformPicture(16, 16, glm::vec3(0.3f));
    const Comparison c = comparePictures(a, b, PictureKind::display);
    const double shown = srgbFromLinear(0.3f) - srgbFromLinear(0.2f);
    EXPECT_NEAR(c.rmse, 0.1, 1.0e-6);
    EXPECT_NEAR(c.psnr, -20 * std::log10(shown), 1.0e-3);
    EXPECT_NEAR(c.flip, ldrFlip(a, b).mean, 1.0e-12);
    EXPECT_FALSE(c.identical);
    EXPECT_EQ(c.flipMap.width, 16);
}

TEST(ComparePictures, IdenticalPictures) {
    const Picture a = noisePicture(20, 20, 9, 0.0f, 50.0f);
    for (PictureKind kind : {PictureKind::display, PictureKind::scene}) {
        const Comparison c = comparePictures(a, a, kind);
        EXPECT_TRUE(c.identical);
        EXPECT_EQ(c.rmse, 0.0);
        EXPECT_EQ(c.relmse, 0.0);
        EXPECT_EQ(c.flip, 0.0);
        EXPECT_NEAR(c.ssim, 1.0, 1.0e-9);
        EXPECT_TRUE(std::isinf(c.psnr));
    }
}

// A picture is not told from another by how its radiance is counted.
TEST(ComparePictures, SceneMetricsAsShownDoNotDependOnTheUnit) {
    const Picture a = noisePicture(24, 24, 41, 0.1f, 3.0f);
    const Picture b = noisePicture(24, 24, 42, 0.1f, 3.0f);
    const Comparison one = comparePictures(a, b, PictureKind::scene);
    const Comparison many =
        comparePictures(scaledPicture(a, 32), scaledPicture(b, 32), PictureKind::scene);
    EXPECT_NEAR(one.psnr, many.psnr, 1.0e-3);
    EXPECT_NEAR(one.ssim, many.ssim, 1.0e-5);
    EXPECT_NEAR(many.rmse, 32 * one.rmse, 1.0e-3 * many.rmse);
}

TEST(ComparePictures, SwappingIsSeenOnlyByRelativeAndHdrMetrics) {
    const Picture a = noisePicture(24, 24, 51);
    const Picture b = noisePicture(24, 24, 52);
    const Comparison ab = comparePictures(a, b, PictureKind::display);
    const Comparison ba = comparePictures(b, a, PictureKind::display);
    EXPECT_DOUBLE_EQ(ab.rmse, ba.rmse);
    EXPECT_DOUBLE_EQ(ab.psnr, ba.psnr);
    EXPECT_DOUBLE_EQ(ab.ssim, ba.ssim);
    EXPECT_DOUBLE_EQ(ab.flip, ba.flip);
    EXPECT_NE(ab.relmse, ba.relmse);
}

}  // namespace
}  // namespace gp::metrics
