// `glitterpath render --mode local`: one picture, sheets of several, and what the file tells.
#include <gtest/gtest.h>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Words = std::vector<std::string>;

// `make-scene three-objects`, made once for all tests.
const std::string& objectsPath() {
    static const TestFolder folder;
    static const std::string path = [] {
        const std::string file = folder("objects.glb");
        const ToolResult made = runTool({"make-scene", "three-objects", "-o", file});
        EXPECT_EQ(made.exitCode, 0) << made.err;
        return file;
    }();
    return path;
}

ToolResult render(const std::string& out, const Words& more) {
    Words words = {"render", objectsPath(), "-o", out, "--size", "64x36", "--spp", "2", "--mode",
                   "local"};
    words.insert(words.end(), more.begin(), more.end());
    const ToolResult result = runTool(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result;
}

TEST(LocalMode, TheReportTellsWhatWasDone) {
    const TestFolder folder;
    render(folder("a.png"), {"--lighting", "ward:alpha_x=0.3,base_color=0.8,0.5,0.3", "--frequency",
                             "gouraud", "--json", folder("a.json")});
    const nlohmann::json json = readJson(folder("a.json"));
    EXPECT_EQ(json["mode"], "local");
    EXPECT_EQ(json["lighting"], "ward:alpha_x=0.3,base_color=0.8,0.5,0.3");
    EXPECT_EQ(json["frequency"], "gouraud");
    EXPECT_FALSE(json.contains("bounces"));
    EXPECT_EQ(json["rays"]["camera"], 64 * 36 * 2);
    EXPECT_EQ(json["rays"]["total"], json["rays"]["camera"]);  // no shadows, no bounces
    render(folder("b.png"), {"--json", folder("b.json")});
    EXPECT_TRUE(readJson(folder("b.json"))["lighting"].is_null());
}

TEST(LocalMode, EveryOptionChangesThePicture) {
    const TestFolder folder;
    const std::vector<Words> cases = {
        {},
        {"--lighting", "phong"},
        {"--lighting", "phong", "--set", "exponent=5"},
        {"--lighting", "phong", "--frequency", "gouraud"},
        {"--lighting", "phong", "--frequency", "flat"},
        {"--lighting", "phong", "--falloff", "inverse"},
        {"--lighting", "phong", "--falloff", "none"},
        {"--lighting", "phong", "--ambient", "0.5,0.5,0"},
        {"--lighting", "ggx_conductor:alpha_x=0.05,alpha_y=0.02"},
        {"--lighting", "ggx_conductor:alpha_x=0.05,alpha_y=0.02", "--ndf-filter", "kaplanyan"},
        {"--lighting", "ggx_conductor:alpha_x=0.05,alpha_y=0.02", "--ndf-filter", "tokuyoshi"},
        {"--lighting", "ggx_conductor:alpha_x=0.05,alpha_y=0.02", "--ndf-filter", "deferred"},
        {"--env-color", "0.5,0.5,0.5"},
        {"--shading", "diffuse"}};
    std::vector<std::string> files;
    for (const Words& more : cases) {
        const std::string file = folder(std::to_string(files.size()) + ".exr");
        render(file, more);
        for (const std::string& other : files) {
            EXPECT_NE(readText(file), readText(other)) << file << " " << other;
        }
        files.push_back(file);
    }
    // Two ways to say the same.
    render(folder("own.exr"), {"--lighting", "phong:exponent=5"});
    EXPECT_EQ(readText(folder("own.exr")), readText(files[2]));
}

TEST(LocalMode, ClampedParametersAreNoted) {
    const TestFolder folder;
    const ToolResult result = render(folder("a.exr"), {"--lighting", "minnaert:k=200"});
    EXPECT_NE(result.err.find("minnaert: k: 200 is outside of"), std::string::npos) << result.err;
    EXPECT_EQ(render(folder("a.exr"), {"--lighting", "minnaert:k=200", "--quiet"}).err, "");
}

TEST(LocalMode, SheetsHoldAPictureForEachModelAndFrequency) {
    const TestFolder folder;
    unsigned width = 0, height = 0, wide = 0, high = 0;
    const ToolResult two = render(folder("two.png"), {"--lighting", "lambert", "--lighting",
                                                      "blinn_phong:exponent=90"});
    EXPECT_NE(two.err.find("2 pictures of 64x36"), std::string::npos) << two.err;
    readPicture(folder("two.png"), width, height);
    EXPECT_GE(width, 2 * 64u);
    EXPECT_GE(height, 36u);
    const ToolResult six =
        render(folder("six.png"), {"--lighting", "lambert", "--lighting", "ward", "--frequency",
                                   "flat", "--frequency", "gouraud", "--frequency", "phong"});
    EXPECT_NE(six.err.find("6 pictures"), std::string::npos) << six.err;
    readPicture(folder("six.png"), wide, high);
    EXPECT_GT(wide, width);   // three columns,
    EXPECT_GT(high, height);  // two rows
}

// All opaque models: those of the list without transmission, microfacets with each distribution.
TEST(LocalMode, AllModelsInOneSheet) {
    const TestFolder folder;
    const nlohmann::json models =
        nlohmann::json::parse(runTool({"brdf", "list", "--json"}).out);
    std::size_t expected = 0;
    for (const nlohmann::json& model : models) {
        if (model["transmissive"] == true || model["fromFile"] == true) {
            continue;
        }
        std::size_t pictures = 1;
        for (const nlohmann::json& parameter : model["parameters"]) {
            if (model["name"] == "microfacet" && parameter["name"] == "distribution") {
                pictures = parameter["choices"].size();
            }
        }
        expected += pictures;
    }
    EXPECT_GT(expected, 25u);
    const ToolResult result = render(folder("all.png"), {"--lighting", "all"});
    EXPECT_NE(result.err.find(std::to_string(expected) + " pictures"), std::string::npos)
        << expected << " " << result.err;
}

TEST(LocalMode, ASheetIsAPicture) {
    const TestFolder folder;
    const Words words = {"render", objectsPath(), "-o", folder("a.exr"), "--mode", "local",
                         "--lighting", "all"};
    const ToolResult result = runTool(words);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(linesOf(result.err).size(), 1u);
    EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace gp::test
