// `glitterpath render` with the real renderer: pictures, numbers, light, cameras, interruption.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

Words renderWords(const std::string& scene, const std::string& out, const Words& more) {
    Words words = {"render", scene, "-o", out, "--size", "64x48"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

ToolResult render(const std::string& scene, const std::string& out, const Words& more = {}) {
    const ToolResult result = runTool(renderWords(scene, out, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result;
}

double meanLuminance(const std::string& path) {
    unsigned width = 0;
    unsigned height = 0;
    const std::vector<float> rgba = readPicture(path, width, height);
    double sum = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        sum += 0.2126 * rgba[i] + 0.7152 * rgba[i + 1] + 0.0722 * rgba[i + 2];
    }
    return sum / static_cast<double>(rgba.size() / 4);
}

TEST(Render, JsonHoldsWhatWasMeasured) {
    const TestFolder folder;
    render(cornellPath(), folder("a.png"), {"--spp", "4", "--bounces", "3", "--seed", "7",
                                            "--json", folder("a.json")});
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["width"], 64);
    EXPECT_EQ(json["height"], 48);
    EXPECT_EQ(json["spp"], 4);
    EXPECT_EQ(json["bounces"], 3);
    EXPECT_EQ(json["seed"], 7);
    for (const char* key : {"load", "build", "render"}) {
        EXPECT_TRUE(json["seconds"][key].is_number()) << key;
        EXPECT_GE(json["seconds"][key].get<double>(), 0.0) << key;
    }
    const Json& rays = json["rays"];
    EXPECT_EQ(rays["camera"], 64 * 48 * 4);
    EXPECT_GT(rays["bounce"].get<double>(), 0);
    EXPECT_GT(rays["shadow"].get<double>(), 0);
    EXPECT_EQ(rays["total"].get<std::uint64_t>(), rays["camera"].get<std::uint64_t>() +
                                                      rays["bounce"].get<std::uint64_t>() +
                                                      rays["shadow"].get<std::uint64_t>());
    const double seconds = json["seconds"]["render"].get<double>();
    EXPECT_NEAR(json["mrays_per_second"].get<double>() * seconds * 1e6,
                rays["total"].get<double>(), 1e-6 * rays["total"].get<double>());
    EXPECT_NEAR(json["msamples_per_second"].get<double>() * seconds * 1e6, 64 * 48 * 4, 0.1);
    EXPECT_GT(json["peak_memory_bytes"].get<double>(), 1e6);
    EXPECT_TRUE(json["noise"].is_number());
    EXPECT_TRUE(json["exposure_ev"].is_number());
    EXPECT_NE(json["device"].get<std::string>().find("CPU"), std::string::npos);
    EXPECT_EQ(json["interrupted"], false);
}

TEST(Render, JsonGoesToStdoutAndMessagesDoNot) {
    const TestFolder folder;
    const ToolResult result =
        render(cornellPath(), folder("a.exr"), {"--spp", "1", "--json", "-"});
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["spp"], 1);
    EXPECT_TRUE(json["exposure_ev"].is_null());
    EXPECT_NE(result.err.find("saved"), std::string::npos);
    EXPECT_EQ(render(cornellPath(), folder("a.exr"), {"--spp", "1", "--quiet"}).err, "");
}

TEST(Render, PipesHaveNoProgressBar) {
    const TestFolder folder;
    const ToolResult result = render(cornellPath(), folder("a.png"), {"--time-limit", "1.5"});
    EXPECT_EQ(result.err.find('\r'), std::string::npos);
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
}

TEST(Render, TheSeedDecidesAndTheThreadsDoNot) {
    const TestFolder folder;
    render(cornellPath(), folder("a.exr"), {"--spp", "2", "--seed", "1", "--threads", "1"});
    render(cornellPath(), folder("b.exr"), {"--spp", "2", "--seed", "1", "--threads", "2"});
    render(cornellPath(), folder("c.exr"), {"--spp", "2", "--seed", "2", "--threads", "2"});
    unsigned width = 0;
    unsigned height = 0;
    const std::vector<float> a = readPicture(folder("a.exr"), width, height);
    EXPECT_EQ(a, readPicture(folder("b.exr"), width, height));
    EXPECT_NE(a, readPicture(folder("c.exr"), width, height));
}

TEST(Render, LimitsEndTheRender) {
    const TestFolder folder;
    const auto start = std::chrono::steady_clock::now();
    render(cornellPath(), folder("a.png"), {"--time-limit", "1", "--json", folder("a.json")});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), 30.0);
    const double seconds = readJson(folder("a.json"))["seconds"]["render"].get<double>();
    EXPECT_GT(seconds, 0.8);
    EXPECT_LT(seconds, 10.0);
    render(cornellPath(), folder("b.png"), {"--noise", "0.2", "--json", folder("b.json")});
    EXPECT_LE(readJson(folder("b.json"))["noise"].get<double>(), 0.2);
}

TEST(Render, BouncesClampShadingAndFilterChangeThePicture) {
    const TestFolder folder;
    render(cornellPath(), folder("full.exr"), {"--spp", "16"});
    render(cornellPath(), folder("direct.exr"), {"--spp", "16", "--bounces", "0"});
    render(cornellPath(), folder("clamp.exr"), {"--spp", "16", "--clamp", "0.01"});
    render(cornellPath(), folder("box.exr"), {"--spp", "16", "--filter", "box"});
    const double full = meanLuminance(folder("full.exr"));
    EXPECT_GT(full, 0.0);
    EXPECT_LT(meanLuminance(folder("direct.exr")), 0.9 * full);
    EXPECT_LT(meanLuminance(folder("clamp.exr")), 0.98 * full);
    EXPECT_NE(readText(folder("box.exr")), readText(folder("full.exr")));
}

TEST(Render, ASceneWithoutLightGetsASkyAndSaysSo) {
    const TestFolder folder;
    const std::string scene = folder("triangle.gltf");
    writeTriangleScene(scene);
    const ToolResult sky = render(scene, folder("sky.exr"), {"--spp", "2"});
    EXPECT_NE(sky.err.find("no light"), std::string::npos) << sky.err;
    EXPECT_NE(sky.err.find("no camera"), std::string::npos) << sky.err;
    EXPECT_GT(meanLuminance(folder("sky.exr")), 0.1);
    const ToolResult black = render(scene, folder("black.exr"), {"--env-color", "0,0,0"});
    EXPECT_EQ(black.err.find("no light"), std::string::npos) << black.err;
    EXPECT_EQ(meanLuminance(folder("black.exr")), 0.0);
}

// Surfaces that glow are light; glow painted with a texture up to radiance 1 is not.
TEST(Render, PaintedGlowIsNoLight) {
    const TestFolder folder;
    writeTriangleScene(folder("triangle.gltf"));
    const std::string plain = readText(folder("triangle.gltf"));
    // One white pixel as a PNG.
    const std::string image =
        R"("images": [{"uri": "pixel.png"}], "textures": [{"source": 0}], )";
    writePicture(folder("pixel.png"), 1, 1, uniformRgba(1, 1, 1, 1, 1));
    const auto note = [&](const std::string& material, const std::string& more) {
        std::string scene = plain;
        const std::string triangle = R"("POSITION": 0})";
        scene.replace(scene.find(triangle), triangle.size(), triangle + R"(, "material": 0)");
        scene.insert(1, more + R"("materials": [{)" + material + "}], ");
        writeText(folder("glow.gltf"), scene);
        return render(folder("glow.gltf"), folder("glow.exr"), {"--spp", "1"}).err;
    };
    const std::string texture = R"(, "emissiveTexture": {"index": 0})";
    const std::string factor = R"("emissiveFactor": [1, 1, 1])";
    EXPECT_EQ(note(factor, "").find("no light"), std::string::npos);
    EXPECT_NE(note(factor + texture, image).find("no light"), std::string::npos);
}

// A uniform surrounding of radiance L shows L where nothing is in front of it.
TEST(Render, SurroundingsShowTheirRadiance) {
    const TestFolder folder;
    const std::string scene = folder("triangle.gltf");
    writeTriangleScene(scene);
    const Words away = {"--spp", "4", "--from", "0,0,-1", "--look-at", "0,0,-2"};
    Words color = away;
    color.insert(color.end(), {"--env-color", "0.25,0.5,2"});
    render(scene, folder("color.exr"), color);
    writePicture(folder("env.hdr"), 8, 4, uniformRgba(8, 4, 0.25f, 0.5f, 2.0f));
    Words file = away;
    file.insert(file.end(), {"--env", folder("env.hdr"), "--env-rotation", "30"});
    render(scene, folder("file.exr"), file);
    for (const char* name : {"color.exr", "file.exr"}) {
        unsigned width = 0;
        unsigned height = 0;
        const std::vector<float> rgba = readPicture(folder(name), width, height);
        ASSERT_EQ(width, 64u);
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            ASSERT_NEAR(rgba[i], 0.25f, 0.01f) << name;
            ASSERT_NEAR(rgba[i + 1], 0.5f, 0.01f) << name;
            ASSERT_NEAR(rgba[i + 2], 2.0f, 0.02f) << name;
        }
    }
}

// The triangle lies in z = 0 and faces +Z; light from the sun alone is E albedo / pi.
TEST(Render, TheSunHasTheIlluminanceAskedFor) {
    const TestFolder folder;
    const std::string scene = folder("triangle.gltf");
    writeTriangleScene(scene);
    render(scene, folder("sun.exr"),
           {"--spp", "16", "--env-color", "0,0,0", "--sun", "180,0,68300", "--shading", "diffuse",
            "--from", "0.25,0.25,0.1", "--look-at", "0.25,0.25,0", "--fov", "40"});
    // 68,300 lux are 100 W/m^2; the sun stands on +Z, right above the surface.
    EXPECT_NEAR(meanLuminance(folder("sun.exr")), 100.0 / 3.14159265, 0.5);
}

TEST(Render, CamerasByNameAndNumber) {
    const TestFolder folder;
    const Json info = Json::parse(runTool({"info", cornellPath(), "--json"}).out);
    ASSERT_FALSE(info["cameras"].empty());
    const std::string name = info["cameras"][0]["name"];
    render(cornellPath(), folder("default.exr"), {"--spp", "1"});
    render(cornellPath(), folder("number.exr"), {"--spp", "1", "--camera", "0"});
    render(cornellPath(), folder("name.exr"), {"--spp", "1", "--camera", name});
    render(cornellPath(), folder("fov.exr"), {"--spp", "1", "--fov", "10"});
    EXPECT_EQ(readText(folder("default.exr")), readText(folder("number.exr")));
    EXPECT_EQ(readText(folder("default.exr")), readText(folder("name.exr")));
    EXPECT_NE(readText(folder("default.exr")), readText(folder("fov.exr")));
    const ToolResult wrong = runTool(renderWords(cornellPath(), folder("x.png"),
                                                 {"--camera", "no such"}));
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_NE(wrong.err.find(name), std::string::npos) << wrong.err;
    EXPECT_FALSE(exists(folder("x.png")));
}

TEST(Render, NegativeNumbersAreValues) {
    const TestFolder folder;
    render(cornellPath(), folder("a.png"),
           {"--spp", "1", "--from", "-.5,1,3", "--look-at", "-0.1,1,0", "--exposure", "-.5"});
    EXPECT_TRUE(exists(folder("a.png")));
}

TEST(Render, ExposureAndToneMapReachThePicture) {
    const TestFolder folder;
    render(cornellPath(), folder("dark.png"), {"--spp", "4", "--exposure", "-3"});
    render(cornellPath(), folder("bright.png"), {"--spp", "4", "--exposure", "1"});
    EXPECT_LT(2 * meanLuminance(folder("dark.png")), meanLuminance(folder("bright.png")));
    std::vector<std::string> files;
    for (const char* map : {"none", "agx", "aces", "reinhard"}) {
        const std::string file = folder(std::string(map) + ".png");
        render(cornellPath(), file, {"--spp", "4", "--exposure", "0", "--tonemap", map});
        for (const std::string& other : files) {
            EXPECT_NE(readText(file), readText(other)) << map;
        }
        files.push_back(file);
    }
    const ToolResult exr =
        render(cornellPath(), folder("a.exr"), {"--spp", "1", "--exposure", "2"});
    EXPECT_NE(exr.err.find("change nothing"), std::string::npos);
    const ToolResult automatic = render(cornellPath(), folder("auto.png"), {"--spp", "4"});
    EXPECT_NE(automatic.err.find("EV (automatic)"), std::string::npos) << automatic.err;
}

TEST(Render, LayersAndFullFloatsMakeLargerFiles) {
    const TestFolder folder;
    render(cornellPath(), folder("half.exr"), {"--spp", "1"});
    render(cornellPath(), folder("float.exr"), {"--spp", "1", "--full-float"});
    render(cornellPath(), folder("some.exr"), {"--spp", "1", "--aov", "albedo,depth"});
    render(cornellPath(), folder("all.exr"), {"--spp", "1", "--aov", "all"});
    EXPECT_GT(readText(folder("float.exr")).size(), readText(folder("half.exr")).size());
    const std::string some = readText(folder("some.exr"));
    const std::string all = readText(folder("all.exr"));
    EXPECT_NE(some.find("albedo.R"), std::string::npos);
    EXPECT_NE(some.find("depth.Z"), std::string::npos);
    EXPECT_EQ(some.find("normal."), std::string::npos);
    for (const char* layer : {"albedo.", "normal.", "depth.", "emission.", "direct.", "indirect.",
                              "roughness.", "variance.", "instance."}) {
        EXPECT_NE(all.find(layer), std::string::npos) << layer;
    }
}

TEST(Render, TheNullBackendWritesABlackPicture) {
    const TestFolder folder;
    render(cornellPath(), folder("a.hdr"), {"--backend", "null"});
    EXPECT_EQ(meanLuminance(folder("a.hdr")), 0.0);
}

TEST(Render, TheFallbackInstructionSetRendersTheSameScene) {
    const TestFolder folder;
    render(cornellPath(), folder("a.exr"), {"--spp", "16", "--isa", "x86-64"});
    render(cornellPath(), folder("b.exr"), {"--spp", "16"});
    EXPECT_NEAR(meanLuminance(folder("a.exr")) / meanLuminance(folder("b.exr")), 1.0, 0.02);
}

TEST(Interrupt, CtrlCSavesWhatThereIs) {
    const TestFolder folder;
    const ToolResult result =
        runTool(renderWords(cornellPath(), folder("a.png"),
                            {"--time-limit", "100", "--json", folder("a.json")}), 2.0);
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_NE(result.err.find("interrupted; saved"), std::string::npos) << result.err;
    EXPECT_GT(meanLuminance(folder("a.png")), 0.0);
    const Json json = readJson(folder("a.json"));
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_GE(json["spp"].get<int>(), 1);
    EXPECT_LT(json["seconds"]["render"].get<double>(), 60.0);
    EXPECT_EQ(folder.fileCount(), 2u);  // no temporary file stays behind
}

}  // namespace
}  // namespace gp::test
