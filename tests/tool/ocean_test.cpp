// `glitterpath ocean`: pictures and moving pictures of the sea, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tool_runner.h"

namespace gp::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words oceanWords(const std::string& out, const Words& more) {
    Words words = {"ocean", "-o", out, "--size", "32x24", "--resolution", "32", "--cascades", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::vector<float> oceanPicture(const std::string& out, const Words& more) {
    const ToolResult result = runTool(oceanWords(out, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    unsigned width = 0;
    unsigned height = 0;
    std::vector<float> rgba = readPicture(out, width, height);
    EXPECT_EQ(width, 32u);
    EXPECT_EQ(height, 24u);
    return rgba;
}

// Of the rows first .. end - 1.
double meanLuminance(const std::vector<float>& rgba, std::size_t first, std::size_t end) {
    double sum = 0;
    for (std::size_t i = first * 32; i < end * 32; ++i) {
        sum += 0.2126 * rgba[4 * i] + 0.7152 * rgba[4 * i + 1] + 0.0722 * rgba[4 * i + 2];
        EXPECT_TRUE(std::isfinite(rgba[4 * i]));
    }
    return sum / static_cast<double>((end - first) * 32);
}

TEST(Ocean, ShowsSkyAboveAndDarkerWaterBelow) {
    const TestFolder folder;
    const std::vector<float> rgba = oceanPicture(
        folder("sea.exr"), {"--samples", "4", "--pitch", "0", "--sun", "180,40"});
    const double sky = meanLuminance(rgba, 0, 11);
    const double water = meanLuminance(rgba, 16, 24);
    EXPECT_GT(sky, 0.1);
    EXPECT_LT(water, 0.7 * sky);
    EXPECT_GT(water, 0.01 * sky);
}

TEST(Ocean, TheSameWordsGiveTheSameBits) {
    const TestFolder folder;
    const Words words = {"--samples", "2", "--time", "3.5"};
    EXPECT_EQ(oceanPicture(folder("a.exr"), words), oceanPicture(folder("b.exr"), words));
    EXPECT_NE(oceanPicture(folder("a.exr"), words),
              oceanPicture(folder("b.exr"), {"--samples", "2", "--time", "4.5"}));
}

TEST(Ocean, NumberedFramesMove) {
    const TestFolder folder;
    const ToolResult result = runTool(oceanWords(
        folder("%02d.exr"), {"--frames", "3", "--fps", "2", "--mode", "reference",
                                  "--samples", "1"}));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    unsigned width = 0;
    unsigned height = 0;
    const std::vector<float> first = readPicture(folder("00.exr"), width, height);
    const std::vector<float> last = readPicture(folder("02.exr"), width, height);
    EXPECT_TRUE(fs::exists(folder("01.exr")));
    EXPECT_NE(first, last);
}

TEST(Ocean, RealTimeShowsTheSameSeaAsTheReference) {
    const TestFolder folder;
    const Words view = {"--pitch", "-30", "--sun", "180,40", "--wind", "0"};
    Words reference = view;
    reference.insert(reference.end(), {"--samples", "64"});
    Words realtime = view;
    realtime.insert(realtime.end(), {"--mode", "realtime"});
    const double expected =
        meanLuminance(oceanPicture(folder("a.exr"), reference), 0, 24);
    const double found = meanLuminance(oceanPicture(folder("b.exr"), realtime), 0, 24);
    EXPECT_NEAR(found, expected, 0.1 * expected);
}

// A quick still is the same sea too: a sky reflected by facets, the sun as a disc.
TEST(Ocean, LocalLightingShowsTheSameSeaAsTheReference) {
    const TestFolder folder;
    const Words view = {"--pitch", "-20", "--sun", "180,40", "--wind", "6", "--foam", "0"};
    Words reference = view;
    reference.insert(reference.end(), {"--samples", "128"});
    Words local = view;
    local.insert(local.end(), {"--mode", "local", "--samples", "8"});
    const double expected = meanLuminance(oceanPicture(folder("a.exr"), reference), 0, 24);
    const double found = meanLuminance(oceanPicture(folder("b.exr"), local), 0, 24);
    EXPECT_NEAR(found, expected, 0.05 * expected);
    local.insert(local.end(), {"--environment-light", "ambient"});
    const double ambient = meanLuminance(oceanPicture(folder("c.exr"), local), 0, 24);
    EXPECT_GT(std::abs(ambient - expected), 0.1 * expected);
}

TEST(Ocean, FramesOfLocalLightingAreStills) {
    const TestFolder folder;
    const Words view = {"--mode", "local", "--environment-light", "9", "--samples", "2"};
    Words moving = view;
    moving.insert(moving.end(), {"--frames", "2", "--fps", "2", "--time", "3"});
    const ToolResult result = runTool(oceanWords(folder("%d.exr"), moving));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    Words still = view;
    still.insert(still.end(), {"--time", "3.5"});
    unsigned width = 0;
    unsigned height = 0;
    EXPECT_EQ(readPicture(folder("1.exr"), width, height), oceanPicture(folder("a.exr"), still));
    EXPECT_NE(readPicture(folder("0.exr"), width, height),
              readPicture(folder("1.exr"), width, height));
}

TEST(Ocean, RefusesWhatItCannotDo) {
    const TestFolder folder;
    const std::string out = folder("x.png");
    const struct {
        Words more;
        const char* message;
    } rows[] = {
        {{"--wind", "-1"}, "--wind"},
        {{"--wind", "nan"}, "--wind"},
        {{"--fetch", "0"}, "--fetch"},
        {{"--depth", "0"}, "--depth"},
        {{"--spectrum", "tma"}, "tma needs --depth"},
        {{"--spectrum", "jonswop"}, "jonswap"},
        {{"--cascades", "9"}, "--cascades"},
        {{"--sun", "10"}, "AZ,EL"},
        {{"--sun", "10,-5"}, "--sun"},
        {{"--fps", "10"}, "only with --frames"},
        {{"--denoiser", "svgf"}, "only with --mode realtime"},
        {{"--mode", "realtime", "--samples", "4"}, "only with --mode reference"},
        {{"--frames", "2"}, "x.png"},
        {{"--environment-light", "9"}, "only with --mode local"},
        {{"--mode", "local", "--environment-light", "8"}, "ambient, 9, 16"},
        {{"--mode", "local", "--bounces", "2"}, "not with --mode local"},
        {{"--camera-height", "0"}, "--camera-height"},
        {{"--wand", "3"}, "did you mean --wind"},
    };
    for (const auto& row : rows) {
        expectRefusal(runTool(oceanWords(out, row.more)), 2, row.message);
    }
    EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace gp::test
