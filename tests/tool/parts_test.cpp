// The parts of the tool that can be tested without running it.
#include <gtest/gtest.h>

#include <cmath>

#include "exposure.h"
#include "output.h"
#include "parse.h"
#include "progress_bar.h"
#include "tool_error.h"
#include "tool_runner.h"

namespace gp::test {
namespace {

double evOf(const std::vector<float>& rgba) {
    return tool::automaticExposureEv(rgba.data(), rgba.size() / 4);
}

TEST(Exposure, WellExposedPicturesAreLeftNearlyAlone) {
    EXPECT_NEAR(evOf(uniformRgba(20, 20, 0.25f, 0.25f, 0.25f)), 0.0, 1.0e-6);
    // Mean radiance 1, spread as pictures are: a third each of 0.3, 0.9 and 1.8.
    std::vector<float> spread;
    for (float value : {0.3f, 0.9f, 1.8f}) {
        const std::vector<float> part = uniformRgba(20, 20, value, value, value);
        spread.insert(spread.end(), part.begin(), part.end());
    }
    EXPECT_NEAR(evOf(spread), 0.0, 0.75);
    EXPECT_NEAR(evOf(uniformRgba(20, 20, 1, 1, 1)), -1.0, 1.0e-5);
}

TEST(Exposure, DaylightIsBroughtDown) {
    const double ev = evOf(uniformRgba(20, 20, 40, 40, 40));
    EXPECT_LT(40 * std::exp2(ev), 0.6);
    EXPECT_GT(40 * std::exp2(ev), 0.2);
}

// A few lamps in the dark: nothing is lifted, since more than 2 % are white already.
TEST(Exposure, LampsInTheDarkStaySo) {
    std::vector<float> night = uniformRgba(20, 20, 0.001f, 0.001f, 0.001f);
    for (std::size_t i = 0; i < 20; ++i) {
        night[4 * i] = night[4 * i + 1] = night[4 * i + 2] = 5.0f;
    }
    EXPECT_EQ(evOf(night), 0.0);
}

TEST(Exposure, DimPicturesAreLiftedWithinLimits) {
    const double dim = evOf(uniformRgba(20, 20, 0.02f, 0.02f, 0.02f));
    EXPECT_GT(dim, 1.5);
    EXPECT_LT(dim, 3.7);
    EXPECT_EQ(evOf(uniformRgba(20, 20, 1.0e-6f, 1.0e-6f, 1.0e-6f)), 6.0);
    EXPECT_EQ(evOf(uniformRgba(20, 20, 0, 0, 0)), 0.0);
}

TEST(Exposure, SurfacesCountMoreThanTheSurroundings) {
    std::vector<float> picture = uniformRgba(20, 20, 40, 40, 40);
    for (std::size_t i = 0; i < picture.size() / 2; i += 4) {
        picture[i] = picture[i + 1] = picture[i + 2] = 4.0f;
    }
    std::vector<float> bright = picture;
    std::vector<float> dark = picture;
    for (std::size_t i = 0; i < picture.size(); i += 4) {
        const bool isDarkHalf = i < picture.size() / 2;
        bright[i + 3] = isDarkHalf ? 0.0f : 1.0f;
        dark[i + 3] = isDarkHalf ? 1.0f : 0.0f;
    }
    EXPECT_LT(evOf(bright), evOf(dark) - 0.5);
}

TEST(ProgressBar, SaysWhatThereIsToSayAndFits) {
    GpProgress progress{};
    progress.fraction = 0.5;
    progress.samplesPerPixel = 12;
    progress.raysPerSecond = 3.25e6;
    progress.noise = -1;
    progress.secondsRemaining = -1;
    const std::string early = tool::ProgressBar::text(progress, 80);
    EXPECT_NE(early.find("50 %  12 spp  3.25 Mrays/s"), std::string::npos) << early;
    EXPECT_EQ(early.find("noise"), std::string::npos);
    EXPECT_EQ(early.find("left"), std::string::npos);
    progress.noise = 0.0213;
    progress.secondsRemaining = 75;
    const std::string late = tool::ProgressBar::text(progress, 80);
    EXPECT_NE(late.find("noise 2.13 %"), std::string::npos) << late;
    EXPECT_NE(late.find("1:15 left"), std::string::npos) << late;
    for (int columns : {1, 10, 40, 60, 80, 200}) {
        EXPECT_LE(tool::ProgressBar::text(progress, columns).size(),
                  static_cast<std::size_t>(columns));
    }
}

TEST(Words, ClockAndBytes) {
    EXPECT_EQ(tool::clockText(7), "0:07");
    EXPECT_EQ(tool::clockText(75.4), "1:15");
    EXPECT_EQ(tool::clockText(7500), "2:05:00");
    EXPECT_EQ(tool::bytesText(12), "12 B");
    EXPECT_EQ(tool::bytesText(12.34e6), "12.3 MB");
}

TEST(Words, NumbersAreReadWholeOrNotAtAll) {
    EXPECT_EQ(tool::parseNumber("--x", "+2.5"), 2.5);
    EXPECT_EQ(tool::parseNumber("--x", "-1e3"), -1000.0);
    for (const char* bad : {"", " ", "1 ", "1x", "0x10", "nan", "inf", "1e999", "--1", "1,0"}) {
        EXPECT_THROW(tool::parseNumber("--x", bad), tool::UsageError) << bad;
    }
    EXPECT_EQ(tool::parseSize("--size", "3x2").height, 2u);
    EXPECT_EQ(tool::parseInteger("--seed", "18446744073709551615", 0, ~std::uint64_t{0}),
              ~std::uint64_t{0});
    EXPECT_EQ(tool::parseTriple("--from", "1,-2,3.5")[1], -2.0f);
}

}  // namespace
}  // namespace gp::test
