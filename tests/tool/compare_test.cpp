// `glitterpath compare` on pictures that the test writes.
#include <gtest/gtest.h>

#include <cmath>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;

Json compareJson(const std::string& a, const std::string& b) {
    const ToolResult result = runTool({"compare", a, b, "--json", "-"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return Json::parse(result.out);
}

TEST(Compare, IdenticalPictures) {
    const TestFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.hdr"}) {
        writePicture(folder(name), 12, 10, uniformRgba(12, 10, 0.5f, 0.25f, 0.125f));
        const Json json = compareJson(folder(name), folder(name));
        EXPECT_EQ(json["identical"], true);
        EXPECT_TRUE(json["psnr"].is_null());
        EXPECT_EQ(json["rmse"], 0.0);
        EXPECT_EQ(json["relmse"], 0.0);
        EXPECT_EQ(json["flip"], 0.0);
        EXPECT_NEAR(json["ssim"].get<double>(), 1.0, 1.0e-6);
        EXPECT_EQ(json["flip_kind"], std::string(name) == "a.png" ? "ldr" : "hdr");
    }
}

TEST(Compare, NumbersOfUniformPictures) {
    const TestFolder folder;
    writePicture(folder("a.exr"), 16, 8, uniformRgba(16, 8, 1.5f, 0.5f, 0.25f));
    writePicture(folder("b.exr"), 16, 8, uniformRgba(16, 8, 1.0f, 0.5f, 0.25f));
    const Json json = compareJson(folder("a.exr"), folder("b.exr"));
    EXPECT_NEAR(json["rmse"].get<double>(), std::sqrt(0.25 / 3), 1.0e-6);
    EXPECT_NEAR(json["relmse"].get<double>(), 0.25 / 1.01 / 3, 1.0e-6);
    EXPECT_NEAR(json["mean_a"][0].get<double>(), 1.5, 1.0e-6);
    EXPECT_NEAR(json["mean_b"][2].get<double>(), 0.25, 1.0e-6);
    EXPECT_GT(json["flip"].get<double>(), 0.01);
    EXPECT_GT(json["psnr"].get<double>(), 10.0);
    EXPECT_LT(json["ssim"].get<double>(), 1.0);
    EXPECT_EQ(json["identical"], false);
}

// Black against white, as in tests/metrics: the whole way through files.
TEST(Compare, FlipOfBlackAndWhite) {
    const TestFolder folder;
    writePicture(folder("a.png"), 20, 20, uniformRgba(20, 20, 0, 0, 0));
    writePicture(folder("b.png"), 20, 20, uniformRgba(20, 20, 1, 1, 1));
    const Json json = compareJson(folder("a.png"), folder("b.png"));
    EXPECT_NEAR(json["flip"].get<double>(), 0.96738, 5.0e-4);
    EXPECT_NEAR(json["psnr"].get<double>(), 0.0, 1.0e-6);
    EXPECT_NEAR(json["rmse"].get<double>(), 1.0, 1.0e-6);
}

TEST(Compare, ThresholdsDecideTheExitCode) {
    const TestFolder folder;
    writePicture(folder("a.png"), 16, 16, uniformRgba(16, 16, 0.5f, 0.5f, 0.5f));
    writePicture(folder("b.png"), 16, 16, uniformRgba(16, 16, 0.6f, 0.5f, 0.5f));
    const auto exitCode = [&](const std::vector<std::string>& thresholds) {
        std::vector<std::string> words = {"compare", folder("a.png"), folder("b.png")};
        for (const std::string& threshold : thresholds) {
            words.insert(words.end(), {"--threshold", threshold});
        }
        return runTool(words).exitCode;
    };
    EXPECT_EQ(exitCode({"rmse=0.5", "relmse=0.5", "flip=0.9", "psnr=1", "ssim=0.1"}), 0);
    EXPECT_EQ(exitCode({"rmse=0.001"}), 1);
    EXPECT_EQ(exitCode({"relmse=0.0001"}), 1);
    EXPECT_EQ(exitCode({"flip=0.0001"}), 1);
    EXPECT_EQ(exitCode({"psnr=90"}), 1);
    EXPECT_EQ(exitCode({"ssim=0.99999"}), 1);
    EXPECT_EQ(exitCode({"rmse=0.5", "psnr=90"}), 1);
}

TEST(Compare, TheHeatmapShowsWhere) {
    const TestFolder folder;
    std::vector<float> left = uniformRgba(64, 32, 0.2f, 0.2f, 0.2f);
    writePicture(folder("b.png"), 64, 32, left);
    for (std::size_t i = 0; i < left.size(); i += 4) {
        if (i / 4 % 64 < 16) {
            left[i] = left[i + 1] = left[i + 2] = 0.8f;
        }
    }
    writePicture(folder("a.png"), 64, 32, left);
    const ToolResult result = runTool(
        {"compare", folder("a.png"), folder("b.png"), "--heatmap", folder("h.png")});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("LDR-FLIP"), std::string::npos) << result.out;
    unsigned width = 0;
    unsigned height = 0;
    const std::vector<float> map = readPicture(folder("h.png"), width, height);
    ASSERT_EQ(width, 64u);
    ASSERT_EQ(height, 32u);
    const std::size_t row = 4 * 64 * 16;
    EXPECT_GT(map[row + 4 * 2], 0.5f);   // far left: orange
    EXPECT_LT(map[row + 4 * 60], 0.01f);  // far right: black
}

TEST(Compare, WrongPairs) {
    const TestFolder folder;
    writePicture(folder("a.png"), 4, 4, uniformRgba(4, 4, 0.5f, 0.5f, 0.5f));
    writePicture(folder("b.png"), 4, 5, uniformRgba(4, 5, 0.5f, 0.5f, 0.5f));
    const ToolResult sizes = runTool(
        {"compare", folder("a.png"), folder("b.png"), "--json", folder("c.json")});
    EXPECT_EQ(sizes.exitCode, 1);
    EXPECT_NE(sizes.err.find("sizes differ"), std::string::npos) << sizes.err;
    EXPECT_EQ(linesOf(sizes.err).size(), 1u);
    EXPECT_FALSE(exists(folder("c.json")));
    writePicture(folder("m.exr"), 4, 4, uniformRgba(4, 4, 0.5f, 0.5f, 0.5f));
    const ToolResult mixed = runTool({"compare", folder("a.png"), folder("m.exr")});
    EXPECT_EQ(mixed.exitCode, 0);
    EXPECT_NE(mixed.err.find("taken for radiance"), std::string::npos) << mixed.err;
}

}  // namespace
}  // namespace gp::test
