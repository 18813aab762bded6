// --alpha, and that pictures are opaque without it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Words = std::vector<std::string>;

// The triangle covers a part of the picture; around it is what --env-color says.
ToolResult render(const TestFolder& folder, const std::string& out, const Words& more = {}) {
    writeTriangleScene(folder("t.gltf"));
    Words words = {"render", folder("t.gltf"), "-o", folder(out), "--size", "32x32", "--spp", "8",
                   "--env-color", "0.2,0.4,0.8", "--exposure", "0", "--tonemap", "none", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return runTool(words);
}

struct Alphas {
    double least = 1, most = 0, bluest = 0;  // the last where alpha is least
};

Alphas alphasOf(const std::string& path) {
    unsigned width = 0, height = 0;
    const std::vector<float> rgba = readPicture(path, width, height);
    Alphas alphas;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const auto alpha = static_cast<double>(rgba[i + 3]);
        if (alpha < alphas.least) {
            alphas.least = alpha;
            alphas.bluest = 0;
        }
        if (alpha <= alphas.least) {
            alphas.bluest = std::max(alphas.bluest, static_cast<double>(rgba[i + 2]));
        }
        alphas.most = std::max(alphas.most, alpha);
    }
    return alphas;
}

int pngColorType(const std::string& path) { return readText(path).at(25); }

TEST(AlphaOption, PicturesAreOpaqueWithoutIt) {
    const TestFolder folder;
    ASSERT_EQ(render(folder, "a.png").exitCode, 0);
    EXPECT_EQ(pngColorType(folder("a.png")), 2);
    EXPECT_NEAR(alphasOf(folder("a.png")).bluest, 0.8, 0.01) << "the background is seen";
}

TEST(AlphaOption, LeavesTheBackgroundOut) {
    const TestFolder folder;
    ASSERT_EQ(render(folder, "o.png").exitCode, 0);
    for (const char* out : {"a.png", "a.exr"}) {
        const ToolResult result = render(folder, out, {"--alpha"});
        ASSERT_EQ(result.exitCode, 0) << result.err;
        const Alphas alphas = alphasOf(folder(out));
        EXPECT_EQ(alphas.least, 0) << out;
        EXPECT_EQ(alphas.most, 1) << out;
        EXPECT_EQ(alphas.bluest, 0) << out;
    }
    EXPECT_EQ(pngColorType(folder("a.png")), 6);
    // Pictures are compared by their colours: of what is covered these are the same.
    const ToolResult same = runTool({"compare", folder("a.png"), folder("a.png")});
    EXPECT_NE(same.out.find("the pictures are identical"), std::string::npos) << same.out;
    const ToolResult other = runTool({"compare", folder("a.png"), folder("o.png")});
    EXPECT_EQ(other.exitCode, 0) << other.err;
    EXPECT_EQ(other.out.find("the pictures are identical"), std::string::npos) << other.out;
}

TEST(AlphaOption, IsRefusedWhereAFileHasNone) {
    const TestFolder folder;
    writeTriangleScene(folder("t.gltf"));
    const struct {
        Words words;
        const char* message;
    } rows[] = {
        {{"render", folder("t.gltf"), "-o", folder("a.hdr")}, "--alpha: .hdr files have none"},
        {{"render", folder("t.gltf"), "-o", folder("a.png"), "--mode", "local", "--lighting",
          "lambert", "--lighting", "ward"},
         "--alpha: only for a single picture"},
        {{"animate", folder("t.gltf"), "--frames", "2", "-o", folder("a.mp4")},
         "--alpha: only for files of pictures"},
        {{"ocean", "--frames", "2", "-o", folder("a.mp4")}, "--alpha: only for files of pictures"},
        {{"evaluate", folder("t.gltf"), "--frames", "2", "-o", folder("a.json")},
         "--alpha: only for files of pictures"},
    };
    for (const auto& row : rows) {
        Words words = row.words;
        words.emplace_back("--alpha");
        expectRefusal(runTool(words), 2, row.message);
    }
}

}  // namespace
}  // namespace gp::test
