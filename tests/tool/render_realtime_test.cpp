// `glitterpath render --mode realtime`, and the exposure of `animate` that follows what is seen.
#include <gtest/gtest.h>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

Words with(const Words& a, const Words& b) {
    Words words = a;
    words.insert(words.end(), b.begin(), b.end());
    return words;
}

Words realtimeWords(const std::string& out, const Words& more) {
    return with({"render", cornellPath(), "-o", out, "--size", "48x36", "--mode", "realtime"},
                more);
}

void render(const std::string& out, const Words& more = {}) {
    const ToolResult result = runTool(realtimeWords(out, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
}

// Relative: else the lamp's edge would be most of it, where the modes have other pixel filters.
double relativeError(const std::string& a, const std::string& b) {
    return Json::parse(runTool({"compare", a, b, "--json", "-"}).out)["relmse"].get<double>();
}

TEST(RenderRealtime, ThePictureBuildsOnEarlierFrames) {
    const TestFolder folder;
    const ToolResult reference =
        runTool({"render", cornellPath(), "-o", folder("reference.exr"), "--size", "48x36", "--spp",
                 "256", "--bounces", "1"});
    ASSERT_EQ(reference.exitCode, 0) << reference.err;
    render(folder("one.exr"), {"--frames", "1", "--seed", "3"});
    render(folder("many.exr"), {"--frames", "48", "--seed", "3"});
    const double one = relativeError(folder("one.exr"), folder("reference.exr"));
    const double many = relativeError(folder("many.exr"), folder("reference.exr"));
    EXPECT_LT(many, 0.7 * one);  // 0.44 when this was written
    render(folder("again.exr"), {"--frames", "48", "--seed", "3"});
    EXPECT_EQ(readText(folder("many.exr")), readText(folder("again.exr")));
}

TEST(RenderRealtime, OptionsChangeThePicture) {
    const TestFolder folder;
    const auto picture = [&](const Words& more) {
        render(folder("x.exr"), with({"--frames", "3"}, more));
        return readText(folder("x.exr"));
    };
    Words pictures = {picture({})};
    EXPECT_EQ(pictures[0], picture({"--denoiser", "asvgf", "--bounces", "1"}));
    for (const Words& words : std::vector<Words>{{"--denoiser", "none"},
                                                 {"--aa", "none"},
                                                 {"--render-scale", "0.5"},
                                                 {"--light-reuse", "biased"},
                                                 {"--tune", "filter_luminance=4"},
                                                 {"--bounces", "2"}}) {
        const std::string other = picture(words);
        for (const std::string& seen : pictures) {
            EXPECT_NE(other, seen) << words[0];
        }
        pictures.push_back(other);
    }
}

TEST(RenderRealtime, JsonCountsAllFrames) {
    const TestFolder folder;
    render(folder("a.png"), {"--frames", "5", "--json", folder("a.json")});
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["mode"], "realtime");
    EXPECT_EQ(json["frames"], 5);
    EXPECT_EQ(json["spp"], 5);
    EXPECT_EQ(json["bounces"], 1);
    EXPECT_GE(json["rays"]["camera"].get<double>(), 48 * 36 * 5);
    EXPECT_TRUE(json["noise"].is_null());
    EXPECT_TRUE(json["exposure_ev"].is_number());
    render(folder("b.png"), {"--json", folder("b.json")});
    EXPECT_EQ(readJson(folder("b.json"))["frames"], 16);
}

TEST(RenderRealtime, LayersButVariance) {
    const TestFolder folder;
    render(folder("a.exr"), {"--frames", "2", "--aov", "all"});
    const std::string file = readText(folder("a.exr"));
    for (const char* layer : {"albedo.R", "normal.X", "depth", "direct.R"}) {
        EXPECT_NE(file.find(layer), std::string::npos) << layer;
    }
    EXPECT_EQ(file.find("variance"), std::string::npos);
    const ToolResult wrong = runTool(realtimeWords(folder("b.exr"), {"--aov", "variance"}));
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_NE(wrong.err.find("no variance in real time"), std::string::npos) << wrong.err;
    EXPECT_FALSE(exists(folder("b.exr")));
}

TEST(RenderRealtime, CtrlCSavesTheLastWholeFrame) {
    const TestFolder folder;
    const ToolResult result = runTool(
        realtimeWords(folder("a.png"), {"--frames", "65536", "--json", folder("a.json")}), 2.0);
    EXPECT_EQ(result.exitCode, 130) << result.err;
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_GT(json["frames"].get<int>(), 0);
    EXPECT_LT(json["frames"].get<int>(), 65536);
    EXPECT_TRUE(exists(folder("a.png")));
}

TEST(Animate, TheExposureFollowsWhatIsSeen) {
    const TestFolder folder;
    const auto exposure = [&](const Words& more) {
        const ToolResult result =
            runTool(with({"animate", cornellPath(), "-o", folder("%d.png"), "--size", "32x24",
                          "--frames", "2", "--json", folder("a.json")}, more));
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return readJson(folder("a.json"))["exposure_ev"].get<double>();
    };
    const double found = exposure({"--eye-adaptation", "0.5"});
    const std::string plain = readText(folder("1.png"));
    EXPECT_NEAR(exposure({"--eye-adaptation", "0.5", "--exposure", "-1.5"}), found - 1.5, 1e-4);
    EXPECT_NE(readText(folder("1.png")), plain);
    EXPECT_NEAR(exposure({"--eye-adaptation", "0.5", "--eye-range", "7,8"}), 7, 1e-4);
    EXPECT_NEAR(exposure({"--eye-adaptation", "0.5", "--eye-range", "-9,-8.5"}), -8.5, 1e-4);
    for (const auto& [words, says] : std::vector<std::pair<Words, std::string>>{
             {{"--eye-adaptation", "-1"}, "--eye-adaptation"},
             {{"--eye-adaptation", "3601"}, "--eye-adaptation"},
             {{"--eye-adaptation", "1", "--eye-range", "2"}, "MIN,MAX"},
             {{"--eye-adaptation", "1", "--eye-range", "2,1"}, "2 is above 1"},
             {{"--eye-adaptation", "1", "--eye-range", "0,0"}, "--exposure"},
             {{"--eye-adaptation", "1", "--eye-range", "0,101"}, "--eye-range"},
             {{"--eye-range", "1,2"}, "needs --eye-adaptation"},
             {{"--mode", "reference", "--eye-adaptation", "1"}, "only with --mode realtime"}}) {
        const ToolResult wrong = runTool(with({"animate", cornellPath(), "-o", folder("x%d.png"),
                                               "--frames", "1"}, words));
        EXPECT_EQ(wrong.exitCode, 2) << words[0];
        EXPECT_NE(wrong.err.find(says), std::string::npos) << wrong.err;
    }
    EXPECT_FALSE(exists(folder("x0.png")));
}

}  // namespace
}  // namespace gp::test
