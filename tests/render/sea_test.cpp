// The sea in pictures: known answers for calm water, energy, far waves against near ones, hostile
// settings, the same bits on any number of threads.
#include <cmath>

#include <gtest/gtest.h>

#include "render/calm_sea.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 24, height = 16;

// The mean of f(cosine with the vertical) over such a picture.
template <class F>
double meanFromAbove(double pitch, const F& f) {
    return meanOverPicture(width, height, 0.25, pitch, [&](glm::dvec3 w) { return f(-w.y); });
}

Picture seaPicture(const GpOceanDesc& desc, const GpCameraDesc& camera, uint32_t samples,
                   uint32_t threads = 0) {
    Stage stage(bestFullVariant().front(), threads);
    stage.surround(glm::vec3(1));
    stage.check(gpSetOcean(stage.scene, &desc));
    stage.check(gpSetOceanTime(stage.scene, 12));
    return stage.render(width, height, camera, stage.options(samples));
}

TEST(Sea, CalmWaterReflectsByFresnel) {
    for (const double pitch : {-0.25, -0.5, -1.2}) {
        const Picture picture = seaPicture(calm(), looking(pitch), effort(64));
        expectMean(picture, meanFromAbove(pitch, fresnel), std::to_string(pitch));
    }
}

// What is refracted is compressed by the square of the index.
TEST(Sea, CalmClearWaterShowsWhatIsBelow) {
    GpOceanDesc desc = calm();
    desc.transparent = 1;
    const double pitch = -0.6;
    const Picture picture = seaPicture(desc, looking(pitch), effort(256));
    expectMean(picture, meanFromAbove(pitch, [](double c) {
                   return fresnel(c) + (1 - fresnel(c)) / (eta * eta);
               }));
}

TEST(Sea, WaterThatAbsorbsIsBlackWithoutAnEnd) {
    GpOceanDesc desc = calm();
    desc.transparent = 1;
    for (float& a : desc.absorption) a = 0.1f;
    const Picture clear = seaPicture(desc, looking(-0.6), effort(256));
    desc.transparent = 0;
    const Picture deep = seaPicture(desc, looking(-0.6), effort(256));
    EXPECT_NEAR(clear.mean().y, deep.mean().y, 4 * std::hypot(clear.sigma().y, deep.sigma().y));
}

// What comes back from below has the colour of scattering over absorption.
TEST(Sea, DeepWaterHasItsOwnColour) {
    GpOceanDesc desc = calm();
    const float scattering[3] = {0.01f, 0.03f, 0.1f};
    for (int c = 0; c < 3; ++c) desc.absorption[c] = 0.1f, desc.scattering[c] = scattering[c];
    const double pitch = -1.2;
    const Picture picture = seaPicture(desc, looking(pitch), effort(1024));
    const double mirror = meanFromAbove(pitch, fresnel);
    for (int c = 0; c < 3; ++c) {
        const double r = leavingShare(0.1, double(scattering[c]));
        const double back = picture.mean()[c] - mirror;
        // Less than all of it leaves, by twice Fresnel's loss at most.
        EXPECT_LT(back, 1.02 * r) << c;
        EXPECT_GT(back, 0.80 * r - 4 * picture.sigma()[c]) << c;
    }
}

TEST(Sea, WavesKeepEnergy) {
    for (const float wind : {3.0f, 12.0f}) {
        GpOceanDesc desc = windy(wind);
        const GpCameraDesc camera = looking(-0.35);
        const Picture reflected = seaPicture(desc, camera, effort(256));
        desc.transparent = 1;
        const Picture both = seaPicture(desc, camera, effort(256));
        const double r = reflected.mean().y, t = (both.mean().y - r) * eta * eta;
        // Single scattering loses what facets hide from one another; none may be made.
        EXPECT_LT(r + t, 1.01) << wind;
        EXPECT_GT(r + t, 0.93) << wind;
    }
}

// Facets that can be counted share out the light of those that cannot; of a white sky all send the
// same, and so do both ways of masking but for what they hide.
TEST(Sea, GlintsAndMaskingKeepTheMean) {
    GpOceanDesc desc = windy(6);
    const GpCameraDesc camera = looking(-0.5);
    const Picture smooth = seaPicture(desc, camera, effort(256));
    desc.glints = GP_GLINTS_ON, desc.glintDensity = 1e4f;
    const Picture dictionary = seaPicture(desc, camera, effort(256));
    desc.glints = GP_GLINTS_COUNTING;
    const Picture counting = seaPicture(desc, camera, effort(256));
    desc.glints = GP_GLINTS_OFF, desc.masking = GP_MASKING_SMITH;
    const Picture smith = seaPicture(desc, camera, effort(256));
    const double expected = smooth.mean().y;
    EXPECT_NEAR(dictionary.mean().y, expected, 0.03 * expected);
    EXPECT_NEAR(counting.mean().y, expected, 0.1 * expected);
    EXPECT_NEAR(smith.mean().y, expected, 0.05 * expected);
    EXPECT_NE(dictionary.color, smooth.color);
    EXPECT_NE(counting.color, smooth.color);
    EXPECT_NE(smith.color, smooth.color);
}

// A picture of few pixels filters the waves; one of many shows them, and its mean is the same.
TEST(Sea, FarWavesLookLikeTheMeanOfNearOnes) {
    Stage stage(bestFullVariant().front());
    GpEnvironmentDesc sky{};
    std::vector<glm::vec4> pixels;  // brighter towards the zenith, so that slopes count
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            pixels.emplace_back(glm::vec3(y < 16 ? 16.0f - float(y) : 0), 1);
    sky.width = 64, sky.height = 32, sky.pixels = &pixels[0].x;
    stage.check(gpSetEnvironment(stage.scene, &sky));
    const GpOceanDesc desc = windy(9);
    stage.check(gpSetOcean(stage.scene, &desc));
    const GpCameraDesc camera = looking(-0.3, 40);
    const Picture few = stage.render(8, 6, camera, stage.options(effort(1024)));
    const Picture many = stage.render(256, 192, camera, stage.options(effort(4)));
    for (uint32_t y = 0; y < 6; ++y) {
        double coarse = 0, fine = 0;
        for (uint32_t x = 0; x < 8; ++x) coarse += double(few.at(x, y).y) / 8;
        for (uint32_t i = 0; i < 32 * 256; ++i)
            fine += double(many.at(i % 256, y * 32 + i / 256).y) / (32 * 256);
        EXPECT_NEAR(coarse, fine, 0.1 * fine) << "row " << y;
    }
}

TEST(Sea, HostileSettingsMakeNoHostilePixels) {
    GpOceanDesc storm = windy(100);
    storm.choppiness = 2, storm.swell = 1, storm.resolution = 16;
    GpOceanDesc puddle = windy(60);
    puddle.spectrum = GP_SPECTRUM_TMA, puddle.depth = 0.1f, puddle.fetch = 100;
    puddle.cascades = 4;
    GpOceanDesc ink = windy(1);
    ink.transparent = 1, ink.ior = 3;
    for (float& a : ink.absorption) a = 1000;
    for (const GpOceanDesc& desc : {storm, puddle, ink})
        for (const float above : {0.0f, 0.5f, -3.0f, 1.0e5f}) {
            const Picture picture = seaPicture(desc, looking(-0.2, above), 4);
            for (const glm::vec4& c : picture.color)
                for (int i = 0; i < 4; ++i) {
                    ASSERT_TRUE(std::isfinite(c[i])) << desc.wind << ' ' << above;
                    ASSERT_GE(c[i], 0) << desc.wind << ' ' << above;
                }
        }
}

TEST(Sea, TheSameBitsOnAnyNumberOfThreads) {
    const GpOceanDesc desc = windy(9);
    const Picture one = seaPicture(desc, looking(-0.3), 4, 1);
    const Picture three = seaPicture(desc, looking(-0.3), 4, 3);
    EXPECT_EQ(one.color, three.color);
}

}  // namespace
}  // namespace gp::test
