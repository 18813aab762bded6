// `glitterpath animate`: files, videos, motion, numbers, interruption.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "tool_runner.h"

namespace gp::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

// The triangle of writeTriangleScene, moved by 2 m to the right within a second.
void writeMovingScene(const std::string& path) {
    writeTriangleScene(path);
    Json json = readJson(path);
    // Two times and two positions behind the triangle's 36 bytes, as floats: 0 1, 0 0 0, 2 0 0.
    json["buffers"].push_back({{"byteLength", 32},
                               {"uri", "data:application/octet-stream;base64,"
                                       "AAAAAAAAgD8AAAAAAAAAAAAAAAAAAABAAAAAAAAAAAA="}});
    json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 32}});
    json["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", 5126}, {"count", 2}, {"type", "SCALAR"}});
    json["accessors"].push_back({{"bufferView", 1}, {"byteOffset", 8}, {"componentType", 5126},
                                 {"count", 2}, {"type", "VEC3"}});
    json["animations"] = {
        {{"samplers", {{{"input", 1}, {"output", 2}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    writeText(path, json.dump());
}

Words animateWords(const std::string& scene, const std::string& out, const Words& more) {
    Words words = {"animate", scene, "-o", out};
    const std::pair<const char*, const char*> usual[] = {
        {"--size", "32x24"}, {"--mode", "reference"}, {"--spp", "2"}};
    for (const auto& [name, value] : usual) {
        if (std::find(more.begin(), more.end(), name) == more.end()) {
            words.insert(words.end(), {name, value});
        }
    }
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

ToolResult animate(const std::string& scene, const std::string& out, const Words& more) {
    const ToolResult result = runTool(animateWords(scene, out, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result;
}

// Where the picture's light is, in pixels from the left.
double centreX(const std::string& path) {
    unsigned width = 0;
    unsigned height = 0;
    const std::vector<float> rgba = readPicture(path, width, height);
    double sum = 0;
    double weighted = 0;
    for (std::size_t i = 0; i < rgba.size() / 4; ++i) {
        sum += rgba[4 * i];
        weighted += rgba[4 * i] * (static_cast<double>(i % width) + 0.5);
    }
    return weighted / sum;
}

// Lit from the front on black, seen along -Z from 6 m: 32 pixels show 5.33 m.
const Words kStraightView = {"--env-color", "0,0,0", "--sun", "180,0,100000", "--from", "1,0.4,6",
                             "--look-at", "1,0.4,0", "--fov", "36.87"};

Words with(const Words& a, const Words& b) {
    Words words = a;
    words.insert(words.end(), b.begin(), b.end());
    return words;
}

TEST(Animate, TheFilePlays) {
    const TestFolder folder;
    writeMovingScene(folder("scene.gltf"));
    animate(folder("scene.gltf"), folder("%02d.exr"),
            with(kStraightView, {"--frames", "7", "--fps", "4", "--spp", "16"}));
    const double metre = 24 / 4.0;  // pixels; the view is 4 m high
    const double start = centreX(folder("00.exr"));
    EXPECT_NEAR(start, 16 + (1.0 / 3 - 1) * metre, 0.15);
    EXPECT_NEAR(centreX(folder("02.exr")) - start, metre, 0.15);       // 0.5 s of 2 m/s
    EXPECT_NEAR(centreX(folder("04.exr")) - start, 0, 0.15);           // 1 s: from the start again
    EXPECT_NEAR(centreX(folder("06.exr")) - start, metre, 0.15);
    EXPECT_FALSE(exists(folder("07.exr")));
    animate(folder("scene.gltf"), folder("hold%d.exr"),
            with(kStraightView, {"--frames", "6", "--fps", "4", "--hold", "--spp", "16"}));
    EXPECT_NEAR(centreX(folder("hold5.exr")) - start, 2 * metre, 0.15);
    animate(folder("scene.gltf"), folder("late%d.exr"),
            with(kStraightView, {"--frames", "1", "--time", "0.25", "--spp", "16"}));
    EXPECT_NEAR(centreX(folder("late0.exr")) - start, 0.5 * metre, 0.15);
}

TEST(Animate, ResumedRunsWriteTheSameFiles) {
    const TestFolder folder;
    writeMovingScene(folder("scene.gltf"));
    animate(folder("scene.gltf"), folder("a%03d.png"), {"--frames", "4", "--path", "orbit"});
    animate(folder("scene.gltf"), folder("b%03d.png"),
            {"--frames", "4", "--path", "orbit", "--start", "2"});
    EXPECT_FALSE(exists(folder("b001.png")));
    EXPECT_EQ(readText(folder("a002.png")), readText(folder("b002.png")));
    EXPECT_EQ(readText(folder("a003.png")), readText(folder("b003.png")));
    EXPECT_NE(readText(folder("a002.png")), readText(folder("a003.png")));
}

// The triangle faces +Z. From behind, after half an orbit, one sees it mirrored.
TEST(Animate, OrbitsGoAround) {
    const TestFolder folder;
    writeTriangleScene(folder("scene.gltf"));
    const Words light = {"--env-color", "1,1,1", "--spp", "8", "--exposure", "0"};
    animate(folder("scene.gltf"), folder("%d.exr"),
            with(light, {"--frames", "5", "--fps", "1", "--path", "orbit", "--orbit-period", "4",
                         "--look-at", "0.5,0.5,0", "--from", "0.5,0.5,3"}));
    const auto alphaLeft = [&](const std::string& name) {
        const ToolResult result =
            runTool({"compare", folder(name), folder("0.exr"), "--json", "-"});
        return Json::parse(result.out)["rmse"].get<double>();
    };
    EXPECT_GT(alphaLeft("1.exr"), 0.01);
    EXPECT_GT(alphaLeft("2.exr"), 0.01);
    // Full circle: the same view, with other noise.
    EXPECT_LT(alphaLeft("4.exr"), 0.5 * alphaLeft("2.exr"));
}

TEST(Animate, KeysOfAFileMoveTheCamera) {
    const TestFolder folder;
    writeTriangleScene(folder("scene.gltf"));
    writeText(folder("path.json"), R"({"interpolation": "linear", "keys": [
        {"time": 0, "position": [0, 0, 6], "target": [0, 0, 0], "fov": 36.87},
        {"time": 1, "position": [1, 0, 6], "target": [1, 0, 0]}]})");
    animate(folder("scene.gltf"), folder("%d.exr"),
            {"--frames", "3", "--fps", "2", "--path", folder("path.json"), "--spp", "16",
             "--env-color", "0,0,0", "--sun", "180,0,100000"});
    const double metre = 24 / 4.0;
    EXPECT_NEAR(centreX(folder("0.exr")) - centreX(folder("1.exr")), 0.5 * metre, 0.15);
    EXPECT_NEAR(centreX(folder("0.exr")) - centreX(folder("2.exr")), metre, 0.15);
}

TEST(Animate, CamerasOfTheFileAreNamed) {
    const TestFolder folder;
    const std::string name =
        Json::parse(runTool({"info", cornellPath(), "--json"}).out)["cameras"][0]["name"];
    animate(cornellPath(), folder("a%d.png"), {"--frames", "1", "--path", name});
    animate(cornellPath(), folder("b%d.png"), {"--frames", "1"});
    EXPECT_EQ(readText(folder("a0.png")), readText(folder("b0.png")));
    const ToolResult wrong = runTool(
        animateWords(cornellPath(), folder("c%d.png"), {"--frames", "1", "--path", "nobody"}));
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_NE(wrong.err.find(name), std::string::npos) << wrong.err;
}

TEST(Animate, JsonHoldsWhatWasMeasured) {
    const TestFolder folder;
    animate(cornellPath(), folder("%d.png"),
            {"--frames", "3", "--fps", "30", "--json", folder("a.json")});
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["frames"], 3);
    EXPECT_EQ(json["mode"], "reference");
    EXPECT_EQ(json["spp"], 2);
    EXPECT_EQ(json["fps"], 30.0);
    const Json& ms = json["milliseconds_per_frame"];
    EXPECT_GT(ms["mean"].get<double>(), 0);
    EXPECT_LE(ms["p50"].get<double>(), ms["p95"].get<double>());
    EXPECT_GT(json["rays_per_frame"].get<double>(), 32 * 24 * 2);
    EXPECT_GT(json["frame_image_bytes_per_pixel"].get<double>(), 16);
    EXPECT_TRUE(json["passes"].empty());  // the path tracer has none
    EXPECT_EQ(json["interrupted"], false);
}

TEST(Animate, RealTimeFramesBuildOnEachOther) {
    const TestFolder folder;
    const Words words = {"animate", cornellPath(), "-o", folder("%d.exr"), "--size", "32x24",
                         "--frames", "3", "--json", folder("a.json")};
    const ToolResult result = runTool(words);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_TRUE(exists(folder("2.exr")));
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["mode"], "realtime");
    EXPECT_FALSE(json["passes"].empty());
    double sum = 0;
    for (const auto& [name, ms] : json["passes"].items()) {
        EXPECT_GE(ms.get<double>(), 0.0) << name;
        sum += ms.get<double>();
    }
    EXPECT_GT(sum, 0.0);
    EXPECT_LE(sum, json["milliseconds_per_frame"]["mean"].get<double>());
}

TEST(Animate, RealTimeOptionsChangeThePicture) {
    const TestFolder folder;
    const auto render = [&](const std::string& name, const Words& more) {
        Words words = {"animate", cornellPath(), "-o", folder(name + "%d.exr"), "--size", "32x24",
                       "--frames", "3", "--exposure", "0"};
        words.insert(words.end(), more.begin(), more.end());
        const ToolResult result = runTool(words);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return readText(folder(name + "2.exr"));
    };
    std::vector<std::string> pictures = {render("plain", {})};
    EXPECT_EQ(pictures[0], render("again", {"--denoiser", "asvgf", "--aa", "temporal"}));
    const std::vector<Words> others = {
        {"--denoiser", "svgf"}, {"--denoiser", "none"}, {"--aa", "none"}, {"--render-scale", "0.5"},
        {"--light-reuse", "unbiased"}, {"--indirect-reuse", "biased"},
        {"--tune", "direct_history_frames=2"}, {"--bounces", "2"}};
    for (const Words& words : others) {
        const std::string picture = render("other", words);
        for (const std::string& seen : pictures) {
            EXPECT_NE(picture, seen) << words[0] << " " << words[1];
        }
        pictures.push_back(picture);
    }
    const ToolResult unknown = runTool({"animate", cornellPath(), "-o", folder("x%d.exr"),
                                        "--frames", "1", "--tune", "direct_histroy_frames=2"});
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_NE(unknown.err.find("direct_history_frames"), std::string::npos) << unknown.err;
}

TEST(Animate, WrongCommandLinesSayWhatIsWrong) {
    const TestFolder folder;
    const auto errorOf = [&](const std::string& out, const Words& more) {
        const ToolResult result = runTool(animateWords(cornellPath(), folder(out), more));
        EXPECT_EQ(result.exitCode, 2) << result.err;
        EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
        return result.err;
    };
    const auto expect = [&](const std::string& error, const std::string& part) {
        EXPECT_NE(error.find(part), std::string::npos) << error;
    };
    expect(errorOf("a.png", {"--frames", "2"}), "names one file");
    expect(errorOf("%d%d.png", {"--frames", "2"}), "holds several numbers");
    expect(errorOf("%s.png", {"--frames", "2"}), "begins no number");
    expect(errorOf("%04d.gif", {"--frames", "2"}), "does not end in");
    expect(errorOf("%d.png", {}), "--frames");
    expect(errorOf("%d.png", {"--frames", "0"}), "--frames");
    expect(errorOf("%d.png", {"--frames", "2", "--start", "2"}), "--start");
    expect(errorOf("a.mp4", {"--frames", "2", "--start", "1"}), "numbered files");
    expect(errorOf("a.mp4", {"--frames", "2", "--size", "31x24"}), "even");
    expect(errorOf("%d.png", {"--frames", "2", "--orbit-height", "1"}), "--path orbit");
    expect(errorOf("%d.png", {"--frames", "2", "--path", "0", "--from", "1,2,3"}), "--from");
    expect(errorOf("%d.png", {"--frames", "2", "--aa", "none"}), "--mode realtime");
    expect(errorOf("%d.png", {"--frames", "2", "--mode", "realtime"}), "--spp");
    EXPECT_EQ(folder.fileCount(), 0u);
    const ToolResult noFolder =
        runTool(animateWords(cornellPath(), folder("no/%d.png"), {"--frames", "1"}));
    EXPECT_EQ(noFolder.exitCode, 1);
    EXPECT_NE(noFolder.err.find("there is no folder"), std::string::npos) << noFolder.err;
}

TEST(Animate, PercentSignsMayStandInNames) {
    const TestFolder folder;
    animate(cornellPath(), folder("100%%_%d.png"), {"--frames", "1"});
    EXPECT_TRUE(exists(folder("100%_0.png")));
}

TEST(Animate, CtrlCKeepsWholeFrames) {
    const TestFolder folder;
    const ToolResult result = runTool(
        animateWords(cornellPath(), folder("%04d.png"),
                     {"--frames", "100000", "--json", folder("a.json")}), 3.0);
    EXPECT_EQ(result.exitCode, 130) << result.err;
    const auto frames = readJson(folder("a.json"))["frames"].get<std::size_t>();
    EXPECT_GT(frames, 0u);
    EXPECT_EQ(folder.fileCount(), frames + 1);  // nothing half done, nothing temporary
    EXPECT_NE(result.err.find("--start " + std::to_string(frames)), std::string::npos)
        << result.err;
}

}  // namespace
}  // namespace gp::test
