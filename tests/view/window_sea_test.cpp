// `glitterpath view --ocean` with its window, on a display without a screen.
#include "window_fixture.h"

namespace gp::test {
namespace {

class SeaWindow : public WindowTest {
protected:
    ToolResult view(const std::string& script, const Words& more = {}) {
        Words words = {"--ocean", "--cascades", "1", "--resolution", "32", "--size", "480x200",
                       "--exposure", "-4"};
        words.insert(words.end(), more.begin(), more.end());
        return viewWith(script, words);
    }
    nlohmann::json seaOf(const std::string& name) const { return state(name)["sea"]; }
};

TEST_F(SeaWindow, MovesUntilItIsPausedWithoutAFile) {
    const ToolResult result = view("state " + file("0.json") + "\nwait 30\nstate " +
                                       file("1.json") + "\npress Space\nrelease Space\nstate " +
                                       file("2.json") + "\nwait 30\nstate " + file("3.json") +
                                       "\npress .\nrelease .\nset sea-speed 2\nstate " +
                                       file("4.json") + "\nlive 2\n",
                                   {"--time", "10", "--wind", "7"});
    VIEW_OR_SKIP(result);
    const auto seconds = [this](const char* name) { return seaOf(name)["seconds"].get<double>(); };
    EXPECT_NEAR(seconds("0.json"), 10, 0.05);
    EXPECT_NEAR(seconds("1.json"), seconds("0.json") + 31.0 / 60, 2.0 / 60);
    EXPECT_EQ(seconds("3.json"), seconds("2.json"));
    EXPECT_EQ(seaOf("3.json")["paused"], true);
    EXPECT_NEAR(seconds("4.json"), seconds("3.json") + 1.0 / 24, 1e-9);
    EXPECT_EQ(seaOf("4.json")["speed"], 2);
    EXPECT_EQ(seaOf("4.json")["wind"], 7);
    EXPECT_EQ(seaOf("4.json")["depth"], "deep");
}

// A flight of the waves, and a picture at its end, with a file and without.
TEST_F(SeaWindow, TheSameScriptIsTheSamePicture) {
    for (const Words& scene : {Words{}, Words{cornellPath(), "--from", "0,2,7", "--sun", "0,30"}}) {
        Words more = scene;
        more.insert(more.end(), {"--live", "traced", "--spp", "2"});
        const auto picture = [&](const std::string& name) {
            const ToolResult result =
                view("wait 20\nset sea-pause on\nsettle 2\npicture " + file(name) + "\n", more);
            EXPECT_EQ(result.exitCode, 0) << result.err;
            return exists(file(name)) ? readText(file(name)) : name;
        };
        const std::string first = picture("a.png");
        if (!m_hasWindow) {
            GTEST_SKIP() << "this build has no window";
        }
        EXPECT_EQ(picture("b.png"), first);
        more.insert(more.end(), {"--time", "2"});
        EXPECT_NE(picture("c.png"), first);
    }
}

TEST_F(SeaWindow, AFileCanGetASeaAndLoseIt) {
    const ToolResult result =
        viewWith("state " + file("0.json") + "\nset sea on\nset resolution 32\nset cascades 1\n" +
                     "set wind 3\nset sea-level -1\nset water-absorption 1,0.5,0\nlive 2\nstate " +
                     file("1.json") + "\nset sea off\nlive 2\nstate " + file("2.json") + "\n",
                 {cornellPath(), "--size", "480x200"});
    VIEW_OR_SKIP(result);
    EXPECT_TRUE(seaOf("0.json").is_null());
    EXPECT_EQ(seaOf("1.json")["sea-level"], -1);
    EXPECT_EQ(seaOf("1.json")["water-absorption"], "1,0.5,0");
    EXPECT_EQ(seaOf("1.json")["moves"], true);
    EXPECT_TRUE(seaOf("2.json").is_null());
}

TEST_F(SeaWindow, WrongWordsOfScriptsAreOneLine) {
    ToolResult result = view("wait 1\nset wind 200\n");
    if (!m_hasWindow) {
        GTEST_SKIP() << "this build has no window";
    }
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("script.txt:2: wind: 200 is not in 0..100"), std::string::npos)
        << result.err;
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
    result = view("set spectrum tma\n");
    EXPECT_NE(result.err.find("script.txt:1: spectrum: tma needs depth"), std::string::npos)
        << result.err;
}

// Without a display: the command line is looked at first.
TEST(SeaOfView, WrongOptionsAreRefused) {
    const struct {
        Words words;
        const char* message;
    } rows[] = {
        {{"--ocean", "--wind", "200"}, "--wind: 200 is not in 0..100"},
        {{"--ocean", "--spectrum", "tma"}, "--spectrum: tma needs --depth"},
        {{"--ocean", "--transparent", "yes"}, "--transparent"},
        {{"--ocean", "--water-ior", "1"}, "--water-ior: 1 is not in 1.01..3"},
        {{"--ocean", "--water-absorption", "1,-1,1"}, "--water-absorption: -1 is not in 0..1000"},
        {{"--ocean", "--sea-speed", "-1"}, "--sea-speed"},
        {{"--ocean", "--time", "1e6"}, "--time"},
        {{"--ocean", "--camera", "0"}, "--camera: only with SCENE"},
        {{"--ocean", "--sun", "3"}, "AZ,EL"},
        {{"x.glb", "--wind", "5"}, "--wind: only with --ocean"},
        {{"x.glb", "--sea-level", "1"}, "--sea-level: only with --ocean"},
        {{"x.glb", "--ocean", "--pitch", "3"}, "--pitch: only with --ocean and without SCENE"},
        {{}, "SCENE is required"},
    };
    for (const auto& row : rows) {
        Words words = {"view"};
        words.insert(words.end(), row.words.begin(), row.words.end());
        expectRefusal(runTool(words), 2, row.message);
    }
}

}  // namespace
}  // namespace gp::test
