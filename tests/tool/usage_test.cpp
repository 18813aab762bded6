// Help, and everything that can be wrong with a command line: exit code 2 (or 1 where a file is at
// fault), one line on stderr, nothing on stdout, no file.
#include <gtest/gtest.h>

#include <algorithm>

#include "tool_runner.h"

namespace gp::test {
namespace {

struct WrongLine {
    std::vector<std::string> arguments;
    int exitCode;
    std::string says;  // must be part of the line
};

void expectRefused(const WrongLine& wrong) {
    const ToolResult result = runTool(wrong.arguments);
    std::string line;
    for (const std::string& word : wrong.arguments) {
        line += word + " ";
    }
    EXPECT_EQ(result.exitCode, wrong.exitCode) << line << "\n" << result.err;
    EXPECT_EQ(linesOf(result.err).size(), 1u) << line << "\n" << result.err;
    EXPECT_EQ(result.err.rfind("glitterpath: error: ", 0), 0u) << line << "\n" << result.err;
    EXPECT_NE(result.err.find(wrong.says), std::string::npos) << line << "\n" << result.err;
    EXPECT_EQ(result.out, "") << line;
}

TEST(Help, ExistsForTheToolAndEachSubcommandWithExamples) {
    for (const char* command : {"", "render", "info", "compare", "make-scene", "brdf", "animate",
                                "evaluate", "view", "ocean"}) {
        std::vector<std::string> arguments;
        if (*command != '\0') {
            arguments.emplace_back(command);
        }
        arguments.emplace_back("--help");
        const ToolResult result = runTool(arguments);
        EXPECT_EQ(result.exitCode, 0) << command;
        EXPECT_EQ(result.err, "") << command;
        EXPECT_NE(result.out.find("Examples:"), std::string::npos) << command;
        EXPECT_NE(result.out.find(std::string("glitterpath ") + command), std::string::npos);
    }
}

TEST(Help, NamesEveryOptionOfRender) {
    const std::string help = runTool({"render", "--help"}).out;
    for (const char* option :
         {"--output", "--size", "--spp", "--time-limit", "--noise", "--bounces", "--env",
          "--env-rotation", "--env-color", "--camera", "--from", "--look-at", "--fov", "--sun",
          "--exposure", "--tonemap", "--aov", "--seed", "--threads", "--json", "--shading",
          "--filter", "--clamp", "--isa", "--backend", "--time", "--full-float", "--quiet",
          "--animation", "--scene", "--no-roulette", "--mode", "--lighting", "--set",
          "--frequency", "--falloff", "--ndf-filter", "--ambient", "--frames", "--denoiser",
          "--light-reuse", "--tune", "--aa", "--render-scale", "--mirrors", "--alpha",
          "Automatic exposure"}) {
        EXPECT_NE(help.find(option), std::string::npos) << option;
    }
}

TEST(Help, Version) {
    const ToolResult result = runTool({"--version"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out.rfind("glitterpath 0.", 0), 0u) << result.out;
    EXPECT_EQ(linesOf(result.out).size(), 1u);
}

TEST(Usage, UnknownThings) {
    for (const WrongLine& wrong : std::vector<WrongLine>{
             {{}, 2, "subcommand is missing"},
             {{"rendr", "x.glb"}, 2, "did you mean render?"},
             {{"--frobnicate"}, 2, "unknown option '--frobnicate'"},
             {{"render"}, 2, "SCENE"},
             {{"render", "x.glb"}, 2, "--output"},
             {{"render", "x.glb", "-o", "x.png", "--sppp", "3"}, 2, "did you mean --spp?"},
             {{"render", "x.glb", "-o", "x.png", "extra"}, 2, "'extra'"},
             {{"render", "x.glb", "-o", "x.png", "--spp"}, 2, "--spp"},
             {{"info"}, 2, "SCENE"},
             {{"compare", "a.png"}, 2, "B"},
             {{"make-scene"}, 2, "--list"},
             {{"make-scene", "no-such", "-o", "x.glb"}, 2, "still-life"}}) {
        expectRefused(wrong);
    }
}

TEST(Usage, WrongValuesOfRender) {
    const TestFolder folder;
    const std::string out = folder("x.png");
    const auto render = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = {"render", "x.glb", "-o", out};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    for (const auto& [more, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--size", "640"}, "--size"},
             {{"--size", "0x5"}, "--size"},
             {{"--size", "20000x5"}, "--size"},
             {{"--size", "-3x5"}, "--size"},
             {{"--spp", "0"}, "--spp"},
             {{"--spp", "-1"}, "--spp"},
             {{"--spp", "3.5"}, "--spp"},
             {{"--spp", "99999999999999999999"}, "--spp"},
             {{"--time-limit", "0"}, "--time-limit"},
             {{"--time-limit", "nan"}, "--time-limit"},
             {{"--noise", "-0.1"}, "--noise"},
             {{"--noise", "inf"}, "--noise"},
             {{"--bounces", "x"}, "--bounces"},
             {{"--bounces", "-2"}, "--bounces"},
             {{"--env-rotation", "abc"}, "--env-rotation"},
             {{"--env-rotation", "90"}, "needs --env"},
             {{"--env-color", "1,2"}, "--env-color"},
             {{"--env", "x.hdr", "--env-color", "1,1,1"}, "--env-color"},
             {{"--from", "1,2,3,4"}, "--from"},
             {{"--from", "1,2,1e99"}, "--from"},
             {{"--look-at", ",,"}, "--look-at"},
             {{"--fov", "180"}, "--fov"},
             {{"--fov", "0"}, "--fov"},
             {{"--sun", "10"}, "--sun"},
             {{"--sun", "10,91,0"}, "--sun"},
             {{"--sun", "10,20,-5"}, "--sun"},
             {{"--env-color", "1,1,1", "--sun", "10,20,0"}, "--sun"},
             {{"--mode", "raster"}, "reference, realtime, local"},
             {{"--lighting", "phong"}, "--lighting: only with --mode local"},
             {{"--set", "exponent=3"}, "--set: only with --mode local"},
             {{"--frequency", "flat"}, "--frequency: only with --mode local"},
             {{"--falloff", "none"}, "--falloff: only with --mode local"},
             {{"--ndf-filter", "tokuyoshi"}, "--ndf-filter: only with --mode local"},
             {{"--mode", "local", "--ndf-filter", "toksvig"}, "kaplanyan, tokuyoshi, deferred"},
             {{"--mode", "local", "--ndf-filter", "deferred", "--frequency", "flat"}, "phong"},
             {{"--ambient", "1,1,1"}, "--ambient: only with --mode local"},
             {{"--mode", "local", "--bounces", "16"}, "--bounces: only with --mode reference"},
             {{"--mode", "local", "--clamp", "1"}, "--clamp: only with --mode reference"},
             {{"--mode", "local", "--no-roulette"}, "--no-roulette: only with --mode reference"},
             {{"--mode", "local", "--set", "exponent=3"}, "--set: needs --lighting"},
             {{"--mode", "local", "--lighting", "phongg"}, "did you mean phong?"},
             {{"--mode", "local", "--lighting", "phong", "--set", "wrap=1"}, "'wrap'"},
             {{"--mode", "local", "--lighting", "phong", "--shading", "diffuse"}, "--lighting"},
             {{"--mode", "local", "--lighting", "all", "--json", "-"}, "--json"},
             {{"--mode", "local", "--frequency", "quad"}, "phong, gouraud, flat"},
             {{"--mode", "local", "--falloff", "cubic"}, "inverse-square, inverse, none"},
             {{"--mode", "local", "--ambient", "1,1"}, "--ambient"},
             {{"--mode", "local", "--ambient", "1,-1,0"}, "negative"},
             {{"--frames", "3"}, "--frames: only with --mode realtime"},
             {{"--denoiser", "svgf"}, "--denoiser: only with --mode realtime"},
             {{"--mode", "local", "--aa", "none"}, "--aa: only with --mode realtime"},
             {{"--tune", "reuse_radius=3"}, "--tune: only with --mode realtime"},
             {{"--mode", "realtime", "--frames", "0"}, "--frames"},
             {{"--mode", "realtime", "--denoiser", "bilateral"}, "svgf"},
             {{"--mode", "realtime", "--spp", "4"}, "--frames says"},
             {{"--mode", "realtime", "--time-limit", "4"}, "--time-limit: not in real time"},
             {{"--mode", "realtime", "--noise", "0.1"}, "--noise: not in real time"},
             {{"--mode", "realtime", "--filter", "tent"}, "--filter: not in real time"},
             {{"--mode", "realtime", "--lighting", "ward"}, "--lighting: only with --mode local"},
             {{"--exposure", "bright"}, "--exposure"},
             {{"--tonemap", "filmic"}, "agx"},
             {{"--aov", "albedo"}, "--aov"},
             {{"--full-float"}, "--full-float"},
             {{"--seed", "-1"}, "--seed"},
             {{"--threads", "1025"}, "--threads"},
             {{"--shading", "toon"}, "diffuse"},
             {{"--filter", "lanczos"}, "tent"},
             {{"--clamp", "-1"}, "--clamp"},
             {{"--isa", "neon"}, "avx2"},
             {{"--backend", "opengl"}, "null"},
             {{"--time", "soon"}, "--time"},
             {{"--animation", "0"}, "--animation"},
             {{"--spp", "3", "--spp", "4"}, "--spp"}}) {
        expectRefused({render(more), 2, says});
    }
    expectRefused({{"render", "x.glb", "-o", folder("x.jpg")}, 2, "--output"});
    expectRefused({{"render", "x.glb", "-o", folder("x.exr"), "--aov", "beauty"}, 2, "albedo"});
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(Usage, WrongValuesOfTheOthers) {
    const TestFolder folder;
    for (const WrongLine& wrong : std::vector<WrongLine>{
             {{"compare", "a.png", "b.png", "--threshold", "flip"}, 2, "--threshold"},
             {{"compare", "a.png", "b.png", "--threshold", "vmaf=3"}, 2, "ssim"},
             {{"compare", "a.png", "b.png", "--threshold", "flip=x"}, 2, "--threshold"},
             {{"compare", "a.png", "b.png", "--heatmap", folder("h.exr")}, 2, "--heatmap"},
             {{"make-scene", "cornell"}, 2, "-o"},
             {{"make-scene", "cornell", "-o", folder("x.gltf")}, 2, ".glb"},
             {{"make-scene", "cornell", "-o", folder("x.glb"), "--set", "radiance"}, 2, "--set"},
             {{"make-scene", "cornell", "-o", folder("x.glb"), "--set", "glow=1"}, 2, "radiance"},
             {{"make-scene", "cornell", "-o", folder("x.glb"), "--set", "radiance=-1"}, 2,
              "radiance"},
             {{"make-scene", "furnace", "-o", folder("x.glb"), "--set", "rows=2.5"}, 2, "rows"}}) {
        expectRefused(wrong);
    }
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(RunErrors, FilesThatAreMissingOrBad) {
    const TestFolder folder;
    const std::string out = folder("out.png");
    writeText(folder("text.glb"), "this is no scene");
    writeText(folder("text.png"), "this is no picture");
    writeText(folder("text.hdr"), "this is no picture");
    writeTriangleScene(folder("triangle.gltf"));
    const std::string scene = folder("triangle.gltf");
    const std::size_t filesBefore = folder.fileCount();
    for (const WrongLine& wrong : std::vector<WrongLine>{
             {{"render", folder("none.glb"), "-o", out}, 1, "none.glb"},
             {{"render", folder("text.glb"), "-o", out}, 1, "text.glb"},
             {{"render", scene, "-o", folder("no/folder.png")}, 1, "no/folder.png"},
             {{"render", scene, "-o", out, "--json", folder("no/x.json")}, 1, "no/x.json"},
             {{"render", scene, "-o", out, "--env", folder("none.hdr")}, 1, "none.hdr"},
             {{"render", scene, "-o", out, "--env", folder("text.hdr")}, 1, "text.hdr"},
             {{"render", scene, "-o", out, "--camera", "front"}, 2, "no camera"},
             {{"info", folder("none.glb")}, 1, "none.glb"},
             {{"info", folder("text.glb")}, 1, "text.glb"},
             {{"compare", folder("none.png"), folder("none.png")}, 1, "none.png"},
             {{"compare", folder("text.png"), folder("text.png")}, 1, "text.png"},
             {{"make-scene", "cornell", "-o", folder("no/x.glb")}, 1, "no/x.glb"}}) {
        expectRefused(wrong);
    }
    EXPECT_EQ(folder.fileCount(), filesBefore);
}

}  // namespace
}  // namespace gp::test
