// `glitterpath info` and `glitterpath make-scene`.
#include <gtest/gtest.h>

#include "tool_runner.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;

TEST(Info, TableForPeople) {
    const ToolResult result = runTool({"info", cornellPath()});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    for (const char* word : {"cornell.glb", "triangles", "instances", "materials", "bounds",
                             "cameras", "emissive triangles"}) {
        EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.out;
    }
}

TEST(Info, JsonHasTheTotalsAndTheLists) {
    const TestFolder folder;
    const std::string scene = folder("triangle.gltf");
    writeTriangleScene(scene);
    const ToolResult result = runTool({"info", scene, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["file"], scene);
    const Json& totals = json["totals"];
    EXPECT_EQ(totals["meshes"], 1);
    EXPECT_EQ(totals["triangles"], 1);
    EXPECT_EQ(totals["instances"], 1);
    EXPECT_EQ(totals["instanced_triangles"], 1);
    EXPECT_EQ(totals["lights"], 0);
    EXPECT_EQ(totals["cameras"], 0);
    EXPECT_EQ(totals["has_environment"], false);
    EXPECT_EQ(totals["bounds_max"], Json::array({1.0, 1.0, 0.0}));
    for (const char* key : {"instances", "meshes", "materials", "textures", "lights", "cameras",
                            "animations", "warnings"}) {
        EXPECT_TRUE(json[key].is_array()) << key;
    }
}

TEST(Info, JsonBeforeTheSceneOrIntoAFile) {
    const TestFolder folder;
    const ToolResult before = runTool({"info", "--json", cornellPath()});
    const ToolResult after = runTool({"info", cornellPath(), "--json", "-"});
    EXPECT_EQ(before.exitCode, 0) << before.err;
    EXPECT_EQ(before.out, after.out);
    const ToolResult file = runTool({"info", cornellPath(), "--json", folder("i.json")});
    EXPECT_EQ(file.out, "");
    EXPECT_EQ(readText(folder("i.json")), after.out);
}

TEST(MakeScene, ListsItsScenes) {
    const ToolResult result = runTool({"make-scene", "--list"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    for (const char* name : {"still-life", "room", "corridor", "furnace", "cornell", "stress",
                             "closed-sphere", "--set albedo=0.5"}) {
        EXPECT_NE(result.out.find(name), std::string::npos) << name;
    }
}

TEST(MakeScene, ParametersReachTheScene) {
    const TestFolder folder;
    const auto instances = [&](const std::vector<std::string>& set) {
        std::vector<std::string> words = {"make-scene", "furnace", "-o", folder("f.glb")};
        words.insert(words.end(), set.begin(), set.end());
        const ToolResult made = runTool(words);
        EXPECT_EQ(made.exitCode, 0) << made.err;
        EXPECT_EQ(made.err, "");
        const Json json = Json::parse(runTool({"info", folder("f.glb"), "--json"}).out);
        return json["totals"]["instances"].get<int>();
    };
    EXPECT_EQ(instances({"--set", "rows=2", "--set", "columns=3"}), 6);
    EXPECT_EQ(instances({"--set", "rows=4", "--set", "columns=5"}), 20);
    EXPECT_EQ(folder.fileCount(), 1u);
}

}  // namespace
}  // namespace gp::test
