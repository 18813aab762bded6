// `render --material` and `brdf presets`: materials by name, of our own files too.
#include <gtest/gtest.h>

#include <algorithm>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Words = std::vector<std::string>;

// The box's picture by direct light, its first pixel row's means: what the walls' colours decide.
std::vector<float> render(const TestFolder& folder, const Words& more, int exitCode = 0,
                          const std::string& says = {}) {
    const std::string out = folder("out.exr");
    Words words = {"render", cornellPath(), "-o", out,       "--size",
                   "32x32",  "--spp",       "8",  "--quiet", "--bounces",
                   "1"};
    words.insert(words.end(), more.begin(), more.end());
    const ToolResult result = runTool(words);
    EXPECT_EQ(result.exitCode, exitCode) << result.err;
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
    unsigned width = 0, height = 0;
    return exitCode == 0 ? readPicture(out, width, height) : std::vector<float>{};
}

// Of walls: the lamp, which goes on shining, is several times as bright as any.
double sumOf(const std::vector<float>& rgba, std::size_t channel) {
    constexpr float brightestWall = 4;
    double sum = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        if (rgba[i] < brightestWall) sum += rgba[i + channel];
    }
    return sum;
}

TEST(Material, ReplacesAllOrByName) {
    const TestFolder folder;
    const std::vector<float> plain = render(folder, {});
    const std::vector<float> blue =
        render(folder, {"--material", "lambert:base_color=0.01,0.01,0.7"});
    // The lamp has four times as much red as blue, and its edges count.
    EXPECT_LT(sumOf(blue, 0), 0.2 * sumOf(blue, 2));
    EXPECT_GT(sumOf(plain, 0), sumOf(plain, 2));
    const ToolResult info = runTool({"info", cornellPath(), "--json"});
    const nlohmann::json materials = nlohmann::json::parse(info.out).at("materials");
    ASSERT_FALSE(materials.empty());
    std::string name;
    for (const auto& m : materials)
        if (m.at("emission")[0] == 0) name = m.at("name").get<std::string>();
    const std::vector<float> one = render(folder, {"--material", name + "=charcoal"});
    EXPECT_NE(one, plain);
    EXPECT_NE(one, blue);
}

// A square whose material has a base colour, a roughness and a normal map; the pixels are linear.
void writeMappedScene(const TestFolder& folder) {
    writePicture(folder("green.png"), 1, 1, {0.1f, 0.8f, 0.1f, 1});
    writePicture(folder("rough.png"), 1, 1, {0, 0.2f, 0, 1});
    writePicture(folder("flat.png"), 1, 1, {0.2140f, 0.2140f, 1, 1});
    const float corners[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const float uv[] = {0, 1, 1, 1, 1, 0, 0, 0};
    const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
    std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
    bytes.append(reinterpret_cast<const char*>(uv), sizeof uv);
    bytes.append(reinterpret_cast<const char*>(indices), sizeof indices);
    writeText(folder("mapped.bin"), bytes);
    writeText(folder("mapped.gltf"), R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],"buffers":[{"uri":"mapped.bin","byteLength":92}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32},
{"buffer":0,"byteOffset":80,"byteLength":12}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],
"max":[1,1,0]},{"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},
{"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],
"images":[{"uri":"green.png"},{"uri":"rough.png"},{"uri":"flat.png"}],
"textures":[{"source":0},{"source":1},{"source":2}],
"materials":[{"name":"leaf","pbrMetallicRoughness":{"baseColorTexture":{"index":0},
"metallicRoughnessTexture":{"index":1},"metallicFactor":0},"normalTexture":{"index":2}}]})");
}

// What the word says nothing of stays as the file has it, and a line tells.
TEST(Material, MapsOfTheFileStay) {
    const TestFolder folder;
    writeMappedScene(folder);
    const struct {
        const char* word;
        const char* says;
        bool green;
    } rows[] = {
        {"disney", "of the file base colour, normals, roughness kept, nothing left out", true},
        {"leaf=ggx_conductor:alpha_x=0.4,alpha_y=0.4",
         "of the file base colour, normals kept, roughness left out", true},
        {"disney:base_color=0.8,0.1,0.1",
         "of the file normals, roughness kept, base colour left out", false},
        {"charcoal", "of the file normals kept, base colour, roughness left out", false},
    };
    for (const auto& row : rows) {
        const std::string out = folder("out.exr");
        const ToolResult result =
            runTool({"render", folder("mapped.gltf"), "-o", out, "--size", "16x16", "--spp", "4",
                     "--env-color", "1,1,1", "--material", row.word});
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_NE(result.err.find(row.says), std::string::npos) << result.err;
        unsigned width = 0, height = 0;
        const std::vector<float> rgba = readPicture(out, width, height);
        const std::size_t middle = 4 * (8 * 16 + 8);
        EXPECT_EQ(rgba[middle + 1] > 2 * rgba[middle], row.green) << row.word;
    }
    // Materials keep their names, so that all and one can be replaced in turn.
    const ToolResult both =
        runTool({"render", folder("mapped.gltf"), "-o", folder("out.exr"), "--size", "16x16",
                 "--spp", "1", "--material", "gold", "--material", "leaf=velvet"});
    EXPECT_EQ(both.exitCode, 0) << both.err;
}

TEST(Material, PresetsOfAFile) {
    const TestFolder folder;
    const std::vector<float> mask = {0, 0, 1, 1};  // blue: the second layer, in channel b
    writePicture(folder("mask.png"), 1, 1, mask);
    writeText(folder("mine.toml"),
              "[red]\nmodel = \"disney\"\nset = { base_color = [0.8, 0.01, 0.01] }\n"
              "[green]\npreset = \"red\"\nset = { base_color = [0.01, 0.8, 0.01] }\n"
              "[both]\nlayers = [{ preset = \"red\" }, { preset = \"green\", mask = \"mask.png\", "
              "channel = \"b\" }]\n"
              "[broken]\nlayers = [{ preset = \"red\" },\n"
              " { preset = \"red\", mask = \"no.png\" }]\n");
    const std::string file = folder("mine.toml");
    const auto red = render(folder, {"--material", file + "#red"});
    const auto green = render(folder, {"--material", file + "#green"});
    const auto both = render(folder, {"--material", file + "#both"});
    EXPECT_GT(sumOf(red, 0), 4 * sumOf(red, 1));
    EXPECT_NEAR(sumOf(both, 1), sumOf(green, 1), 0.01 * sumOf(green, 1));
    render(folder, {"--material", file + "#broken"}, 2, "no.png");
    const ToolResult list = runTool({"brdf", "presets", file});
    EXPECT_EQ(list.exitCode, 0) << list.err;
    EXPECT_NE(list.out.find("[disney, 2 layers]"), std::string::npos) << list.out;
    const ToolResult masked =
        runTool({"brdf", "eval", file + "#both", "--wi", "0,0,1", "--wo", "0,0,1"});
    EXPECT_EQ(masked.exitCode, 2);
    EXPECT_NE(masked.err.find("it is a material of scenes"), std::string::npos) << masked.err;
}

TEST(Material, RefusesWords) {
    const TestFolder folder;
    render(folder, {"--material", "golt"}, 2, "did you mean gold?");
    render(folder, {"--material", "wal=gold"}, 2, "the scene has no material 'wal'");
    render(folder, {"--material", "lambert:colour=1"}, 2, "unknown parameter of lambert 'colour'");
    render(folder, {"--material", folder("none.toml") + "#a"}, 2, "none.toml");
}

TEST(Material, PresetsAreListed) {
    const ToolResult result = runTool({"brdf", "presets"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    for (const char* word : {"metal\n", "gold", "velvet", "water", "[disney, 3 layers]"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
    const nlohmann::json json = nlohmann::json::parse(runTool({"brdf", "presets", "--json"}).out);
    const auto rusty = std::find_if(json.begin(), json.end(), [](const auto& preset) {
        return preset.at("name") == "rusty_iron";
    });
    ASSERT_NE(rusty, json.end());
    EXPECT_EQ(rusty->at("layers").size(), 2u);
    EXPECT_NEAR(rusty->at("layers")[1].at("weight").get<double>(), 0.55, 1e-6);
}

}  // namespace
}  // namespace gp::test
