// `glitterpath evaluate`: the numbers of a report, its page, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

ToolResult evaluate(const std::string& out, const Words& more) {
    Words words = {"evaluate", cornellPath(), "-o", out, "--size", "48x36", "--spp", "32"};
    words.insert(words.end(), more.begin(), more.end());
    return runTool(words);
}

void expectFinite(const Json& values, std::size_t count, double least, double most) {
    ASSERT_EQ(values.size(), count);
    for (const Json& value : values) {
        EXPECT_GE(value.get<double>(), least);
        EXPECT_LE(value.get<double>(), most);
    }
}

TEST(Evaluate, ReportsEveryFrame) {
    const TestFolder folder;
    const ToolResult result = evaluate(folder("a.json"), {"--frames", "6", "--skip", "2",
                                                          "--path", "orbit", "--orbit-period", "20",
                                                          "--look-at", "0,1,0",
                                                          "--denoiser", "asvgf,none", "--aa",
                                                          "none"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["frames"], 6);
    EXPECT_EQ(json["skip"], 2);
    EXPECT_EQ(json["reference_spp"], 32);
    ASSERT_EQ(json["variants"].size(), 2u);
    EXPECT_EQ(json["variants"][0]["name"], "asvgf");
    EXPECT_EQ(json["variants"][1]["name"], "none");
    // What the denoiser is for.
    EXPECT_LT(2 * json["variants"][0]["flicker"].get<double>(),
              json["variants"][1]["flicker"].get<double>());
    const Json& v = json["variants"][0];
    expectFinite(v["per_frame"]["rmse"], 6, 1e-4, 1);
    expectFinite(v["per_frame"]["ssim"], 6, -1, 0.9999);
    expectFinite(v["per_frame"]["flip"], 6, 1e-4, 1);
    expectFinite(v["per_frame"]["flicker"], 5, 1e-4, 1);
    EXPECT_FALSE(v.contains("lag_frames"));
    double sum = 0;
    for (std::size_t i = 2; i < 6; ++i) {
        sum += v["per_frame"]["ssim"][i].get<double>() / 4;
    }
    EXPECT_NEAR(v["ssim"].get<double>(), sum, 1e-9);
    EXPECT_GT(v["milliseconds"].get<double>(), 0);
    EXPECT_NE(result.err.find("flicker"), std::string::npos) << result.err;
}

// A-SVGF sees that a light has gone out; a plain mean over the frames forgets slowly: after three
// frames with the light, the first one without it has a weight of a fourth, then two fifths.
TEST(Evaluate, MeasuresHowLongLightStays) {
    const TestFolder folder;
    const ToolResult result =
        evaluate(folder("a.json"), {"--frames", "6", "--lamp", "0,1,0.3,4000", "--lamp-off", "3",
                                    "--denoiser", "asvgf,svgf", "--aa", "none", "--exposure", "0"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["lamp"]["off_frame"], 3);
    EXPECT_EQ(json["lamp"]["shows"], true);
    const Json& v = json["variants"][0];
    ASSERT_EQ(v["per_frame"]["afterglow"].size(), 3u);
    EXPECT_EQ(v["lag_frames"], 0);
    const Json& slow = json["variants"][1]["per_frame"]["afterglow"];
    EXPECT_NEAR(slow[0].get<double>(), 0.75, 0.1);
    EXPECT_NEAR(slow[1].get<double>(), 0.6, 0.1);
    EXPECT_NEAR(slow[2].get<double>(), 0.5, 0.1);
    EXPECT_TRUE(json["variants"][1]["lag_frames"].is_null());
    // Below the floor nothing is lit that is seen.
    const ToolResult hidden = evaluate(folder("b.json"), {"--frames", "4", "--lamp",
                                                          "0,-50,0,0.001", "--exposure", "0"});
    ASSERT_EQ(hidden.exitCode, 0) << hidden.err;
    EXPECT_EQ(readJson(folder("b.json"))["lamp"]["shows"], false);
    EXPECT_TRUE(readJson(folder("b.json"))["variants"][0]["lag_frames"].is_null());
}

// References of few samples are far noisier than the picture that they judge; the numbers are not.
TEST(Evaluate, LeavesOutTheNoiseOfTheReferences) {
    const TestFolder folder;
    const auto run = [&](const std::string& samples) {
        const std::string file = folder(samples + ".json");
        const ToolResult result =
            runTool({"evaluate", cornellPath(), "-o", file, "--size", "64x48", "--spp", samples,
                     "--frames", "6", "--skip", "2", "--aa", "none", "--exposure", "0"});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return readJson(file);
    };
    const Json few = run("4");
    const Json many = run("128");
    EXPECT_GT(few["reference_noise"]["rmse"].get<double>(),
              3 * many["reference_noise"]["rmse"].get<double>());
    EXPECT_GT(few["reference_noise"]["rmse"].get<double>(),
              few["variants"][0]["rmse"].get<double>());
    for (const char* name : {"rmse", "ssim", "flicker"}) {
        const double expected = many["variants"][0][name].get<double>();
        std::printf("%s: %.4f, %.4f with few samples\n", name, expected,
                    few["variants"][0][name].get<double>());
        EXPECT_NEAR(few["variants"][0][name].get<double>(), expected, 0.3 * expected) << name;
    }
    // Rays of both go through the centres of pixels, so that edges have no error.
    EXPECT_LT(many["variants"][0]["rmse"].get<double>(), 0.03);
}

TEST(Evaluate, ThePageHoldsEverything) {
    if (runTool({"brdf", "plot", "lambert", "--kind", "polar", "-o",
                 TestFolder()("probe.svg")}).exitCode != 0) {
        GTEST_SKIP() << "gnuplot is missing";
    }
    const TestFolder folder;
    const ToolResult result =
        evaluate(folder("a.html"), {"--frames", "4", "--lamp", "0,1,0.3,4000", "--json",
                                    folder("a.json")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string page = readText(folder("a.html"));
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    const auto count = [&](const std::string& text) {
        std::size_t found = 0;
        for (std::size_t at = page.find(text); at != std::string::npos;
             at = page.find(text, at + 1)) {
            ++found;
        }
        return found;
    };
    EXPECT_EQ(count("data:image/svg+xml;base64,PD94bWwg"), 5u);  // "<?xml "
    EXPECT_EQ(count("data:image/png;base64,iVBORw0KGgo"), 3u);   // reference, picture, FLIP
    EXPECT_EQ(count("http"), 0u);                                // nothing from elsewhere
    EXPECT_NE(page.find("asvgf"), std::string::npos);
    EXPECT_EQ(folder.fileCount(), 2u);
}

TEST(Evaluate, WrongCommandLinesSayWhatIsWrong) {
    const TestFolder folder;
    const auto expect = [&](const std::string& out, const Words& more, const std::string& part) {
        const ToolResult result = evaluate(folder(out), more);
        EXPECT_EQ(result.exitCode, 2) << result.err;
        EXPECT_EQ(linesOf(result.err).size(), 1u);
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    };
    expect("a.txt", {"--frames", "4"}, ".html or .json");
    expect("a.json", {}, "--frames");
    expect("a.json", {"--frames", "4", "--skip", "4"}, "--skip");
    expect("a.json", {"--frames", "4", "--lamp-off", "2"}, "--lamp");
    expect("a.json", {"--frames", "4", "--lamp", "1,2,3"}, "X,Y,Z,LUMEN");
    expect("a.json", {"--frames", "4", "--lamp", "1,2,3,4", "--lamp-off", "4"}, "1..3");
    expect("a.json", {"--frames", "4", "--noise", "0.1"}, "--noise");
    expect("a.json", {"--frames", "4", "--denoiser", "asvgf,best"}, "--denoiser");
    EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace gp::test
