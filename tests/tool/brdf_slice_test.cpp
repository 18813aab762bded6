// glitterpath brdf slice: pictures over half and difference angles.
#include <gtest/gtest.h>

#include <cmath>

#include "csv_table.h"

namespace gp::test {
namespace {

struct Sheet {
    unsigned width = 0, height = 0;
    std::vector<float> rgba;
    std::size_t count(float r, float g, float b) const {
        std::size_t n = 0;
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            n += std::abs(rgba[i] - r) < 0.01f && std::abs(rgba[i + 1] - g) < 0.01f &&
                 std::abs(rgba[i + 2] - b) < 0.01f;
        }
        return n;
    }
};

Sheet sliced(std::vector<std::string> words) {
    const TestFolder folder;
    words.insert(words.begin(), {"brdf", "slice", "--size", "64", "-o", folder("s.png")});
    const ToolResult result = runTool(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    Sheet sheet;
    sheet.rgba = readPicture(folder("s.png"), sheet.width, sheet.height);
    return sheet;
}

constexpr std::size_t kInner = 62 * 62;  // gnuplot softens the edges

TEST(BrdfSlice, ShowsFWithExposure) {
    const auto f = static_cast<float>(1 / M_PI);
    EXPECT_GE(sliced({"lambert:base_color=1,0.5,0"}).count(f, f / 2, 0), kInner);
    EXPECT_GE(sliced({"lambert:base_color=1,0.5,0", "--exposure", "1"}).count(2 * f, f, 0), kInner);
    EXPECT_GE(sliced({"lambert:base_color=0.4,0.2,0", "--chroma"}).count(1, 0.5f, 0), kInner);
    const Sheet two = sliced({"lambert:base_color=1,0,0", "lambert:base_color=0,1,0"});
    EXPECT_GE(two.count(f, 0, 0), kInner);
    EXPECT_GE(two.count(0, f, 0), kInner);
}

TEST(BrdfSlice, MarksWhatLiesBelowTheHorizon) {
    // In the plane of incidence half of it does: theta_h + theta_d above 90 degrees.
    const auto dark = static_cast<float>(std::pow((150 / 255.0 + 0.055) / 1.055, 2.4));
    const auto light = static_cast<float>(std::pow((190 / 255.0 + 0.055) / 1.055, 2.4));
    const Sheet sheet = sliced({"lambert:base_color=0", "--phi-d", "0"});
    const auto marked = double(sheet.count(dark, dark, dark) + sheet.count(light, light, light));
    EXPECT_NEAR(marked / (64 * 64), 0.5, 0.05);
}

TEST(BrdfSlice, DifferenceIsSigned) {
    const Sheet sheet = sliced({"lambert:base_color=1", "lambert:base_color=0", "--difference",
                                "--exposure", "3"});
    // 1/pi is more than 2^-3: all red.
    const auto linear = [](double v) { return float(std::pow((v + 0.055) / 1.055, 2.4)); };
    EXPECT_GE(sheet.count(linear(0.698), linear(0.094), linear(0.169)), kInner);
    const Sheet other = sliced({"lambert:base_color=0", "lambert:base_color=1", "--difference"});
    EXPECT_GE(other.count(linear(0.129), linear(0.4), linear(0.675)), kInner);
    const Sheet same = sliced({"ward", "ward", "--difference"});
    EXPECT_GE(same.count(linear(0.969), linear(0.969), linear(0.969)), kInner);
}

TEST(BrdfSlice, SquareGivesSmallAnglesRoom) {
    const TestFolder folder;
    for (const bool square : {false, true}) {
        std::vector<std::string> words = {"brdf", "slice", "lambert", "--size", "16", "-o",
                                          folder("s.png"), "--csv", folder("s.csv")};
        if (square) {
            words.push_back("--square-theta-h");
        }
        EXPECT_EQ(runTool(words).exitCode, 0);
        const Table table(readText(folder("s.csv")));
        ASSERT_EQ(table.rows().size(), 256u);
        const double t = 0.5 / 16;
        EXPECT_NEAR(table.rows()[0].number("theta_h"), 90 * (square ? t * t : t), 1e-4);
        EXPECT_NEAR(table.rows()[0].number("theta_d"), 90 * (1 - t), 1e-4);
        EXPECT_NEAR(table.rows()[99].number("f_b"), 1 / M_PI, 1e-6);
    }
}

TEST(BrdfSlice, Refuses) {
    const TestFolder folder;
    const auto slice = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"brdf", "slice", "-o", folder("x.png")});
        return runTool(words);
    };
    expectError(slice({}), 2, "which MODEL?");
    expectError(slice({"lambert", "--difference"}), 2, "takes two models, not 1");
    expectError(slice({"a", "b", "c", "--difference"}), 2, "takes two models, not 3");
    expectError(slice({"lambert", "--chroma", "--exposure", "1"}), 2, "--chroma");
    expectError(slice({"lambert", "--size", "3"}), 2, "--size");
    expectError(slice({"lambert", "--phi-d", "x"}), 2, "--phi-d");
    expectError(slice({"lambert", "--exposure", "99"}), 2, "-40..40");
    expectError(slice({"lambert", "--csv", folder("no/x.csv")}), 1, "no/x.csv");
    EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace gp::test
