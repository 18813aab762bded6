// `glitterpath view` as a person meets it: the real command on a display without a screen, with a
// script in the place of hands, and once with events of the X server itself.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <tuple>

#include "window_fixture.h"

namespace gp::test {
namespace {

class ViewWindow : public WindowTest {
protected:
    // Runs a script in a small window on the given scene.
    ToolResult view(const std::string& scene, const std::string& script, const Words& more = {}) {
        Words words = {scene, "--size", "640x360", "--exposure", "0", "--live", "traced"};
        words.insert(words.end(), more.begin(), more.end());
        return viewWith(script, words);
    }
};

struct Picture {
    unsigned width = 0, height = 0;
    std::vector<float> rgba;
    // The root of the mean square of what they differ by.
    double distanceTo(const Picture& other) const {
        double sum = 0;
        for (std::size_t i = 0; i < rgba.size(); ++i) {
            if (i % 4 == 3) {
                continue;  // windows are opaque
            }
            sum += std::pow(static_cast<double>(rgba[i]) - static_cast<double>(other.rgba[i]), 2);
        }
        return std::sqrt(sum / (0.75 * static_cast<double>(rgba.size())));
    }
};

Picture load(const std::string& path) {
    Picture picture;
    picture.rgba = readPicture(path, picture.width, picture.height);
    return picture;
}

TEST_F(ViewWindow, ThePictureAtRestIsWhatRenderMakes) {
    // Without panels the picture fills the window.
    const ToolResult result = view(cornellPath(),
                                   "press Tab\nrelease Tab\nsettle 4\npicture " + file("v.png") +
                                       "\nwindow " + file("w.png") + "\n",
                                   {"--spp", "4"});
    VIEW_OR_SKIP(result);
    const ToolResult rendered = runTool({"render", cornellPath(), "-o", file("r.png"), "--size",
                                         "640x360", "--spp", "4", "--exposure", "0", "--quiet"});
    ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
    const Picture viewed = load(file("v.png"));
    const Picture window = load(file("w.png"));
    const Picture expected = load(file("r.png"));
    ASSERT_EQ(viewed.width, 640u);
    ASSERT_EQ(window.height, 360u);
    // The camera went through angles: rays differ in the last bits, and a few paths altogether.
    EXPECT_LT(viewed.distanceTo(expected), 0.01);
    // What stands in the window is what was saved, byte for byte.
    EXPECT_LT(window.distanceTo(viewed), 1.0e-6);
}

TEST_F(ViewWindow, HandsMoveTheCamera) {
    const ToolResult result = view(
        cornellPath(),
        "state " + file("0.json") + "\npress W\nwait 30\nrelease W\nwait 2\nstate " +
            file("1.json") + "\npress Shift\npress D\nwait 15\nrelease D\nrelease Shift\nwait 2\n" +
            "state " + file("2.json") + "\nmouse 500 200\ndown left\nmouse 560 200\nup left\n" +
            "wait 2\nstate " + file("3.json") + "\nwheel 4\nwait 2\nstate " + file("4.json") +
            "\nmouse 100 200\nwait 2\nwheel 4\ndown left\nmouse 50 200\nup left\nwait 2\nstate " +
            file("5.json") + "\npress R\nrelease R\nwait 2\nstate " + file("6.json") + "\n");
    VIEW_OR_SKIP(result);
    const auto position = [this](const char* name, int axis) {
        return state(name)["position"][axis].get<double>();
    };
    const double speed = state("0.json")["speed"];
    // Frames of a sixtieth of a second: `wait 30` with its key commands is 31 or 32 of them.
    EXPECT_NEAR(position("1.json", 2), position("0.json", 2) - speed * 32 / 60, speed * 2 / 60);
    EXPECT_NEAR(position("2.json", 0), position("1.json", 0) + 4 * speed * 17 / 60, speed / 3);
    EXPECT_NE(state("3.json")["target"], state("2.json")["target"]);
    EXPECT_EQ(state("3.json")["position"], state("2.json")["position"]);
    EXPECT_NEAR(state("4.json")["speed"].get<double>(), 2 * speed, 1.0e-3 * speed);
    // Over the panels neither wheel nor drag reach the camera.
    EXPECT_EQ(state("5.json")["speed"], state("4.json")["speed"]);
    EXPECT_EQ(state("5.json")["target"], state("4.json")["target"]);
    // Back to the first view; the library's camera went through angles once.
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(position("6.json", axis), position("0.json", axis), 1.0e-5);
    }
}

TEST_F(ViewWindow, TellsTheMaterialUnderTheCursor) {
    // Without panels: the left wall, the back wall, and what lies outside of the box.
    const ToolResult result =
        view(cornellPath(), "press Tab\nrelease Tab\nsettle 1\nmouse 175 180\nwait 2\nstate " +
                                file("a.json") + "\nmouse 330 110\nwait 2\nstate " +
                                file("b.json") +
                                "\ndown left\nup left\nmouse 20 20\nwait 2\nstate " +
                                file("c.json") + "\n");
    VIEW_OR_SKIP(result);
    const nlohmann::json a = state("a.json")["thing"];
    const nlohmann::json b = state("b.json")["thing"];
    const nlohmann::json c = state("c.json")["thing"];
    ASSERT_FALSE(a.is_null());
    ASSERT_FALSE(b.is_null());
    EXPECT_NE(a["material"], b["material"]);
    EXPECT_EQ(b["material"], "white");
    EXPECT_TRUE(a["parameters"].contains("baseColor"));
    EXPECT_EQ(c["material"], b["material"]);  // the click holds it
    EXPECT_EQ(c["pinned"], true);
}

TEST_F(ViewWindow, SurvivesEverySizeAndIconifying) {
    const ToolResult result = view(
        cornellPath(),
        "wait 5\nsize 200 150\nwait 5\nsize 1 1\nwait 5\nsize 900 500\nwait 1\nsize 500 300\n"
        "settle 1\niconify\nwait 20\npress W\nwait 5\nrelease W\nrestore\nsettle 2\nstate " +
            file("s.json") + "\nsize 341 200\nsettle 1\npress Tab\nrelease Tab\nsettle 1\n");
    VIEW_OR_SKIP(result);
    EXPECT_EQ(state("s.json")["render_size"], (nlohmann::json{160, 300}));  // beside the panels
    EXPECT_EQ(state("s.json")["at_rest"], true);
}

TEST_F(ViewWindow, ScenesWithoutCameraAndLightAndClosingWhileItRenders) {
    writeTriangleScene(file("triangle.gltf"));
    ToolResult result = view(file("triangle.gltf"), "settle 2\npress F\nrelease F\nsettle 1\n");
    VIEW_OR_SKIP(result);
    // An empty scene: nothing to frame, nothing to pick.
    writeText(file("empty.gltf"),
              R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}]})");
    result = view(file("empty.gltf"), "settle 1\npress W\nwait 5\nrelease W\nsettle 1\n");
    VIEW_OR_SKIP(result);
    // Long before the picture is done.
    result = view(cornellPath(), "size 1200 900\nwait 40\npress Escape\n", {"--spp", "4096"});
    VIEW_OR_SKIP(result);
}

TEST_F(ViewWindow, LowersTheSizeToHoldTheTime) {
    // A sixtieth of a second and two seconds a frame; the script flies, so that frames come.
    const std::string fly = "press W\nlive 25\nrelease W\nwait 1\nstate ";
    const ToolResult result = view(cornellPath(), "set reference off\nset fps 240\n" + fly +
                                                      file("a.json") + "\nset fps 1\npress S\n" +
                                                      "live 40\nrelease S\nwait 1\nstate " +
                                                      file("b.json") + "\n");
    VIEW_OR_SKIP(result);
    EXPECT_LT(state("a.json")["scale"].get<double>(), state("b.json")["scale"].get<double>());
    EXPECT_LT(state("a.json")["render_size"][0], state("b.json")["render_size"][0]);
}

TEST_F(ViewWindow, RealTimeIsTheDefault) {
    const ToolResult result = viewWith(
        "press W\nlive 10\nrelease W\nlive 10\nset image motion\nlive 2\nwindow " +
            file("m.png") + "\nset image display\nset reference on\nsettle 2\n" +
            "set reference off\nlive 5\nstate " + file("s.json") + "\n",
        {cornellPath(), "--size", "640x360"});
    VIEW_OR_SKIP(result);
    const nlohmann::json json = state("s.json");
    EXPECT_EQ(json["live"], "realtime");
    EXPECT_EQ(json["at_rest"], false);
    EXPECT_FALSE(json["passes"].empty());
    EXPECT_EQ(json["note"], "");
    EXPECT_TRUE(exists(file("m.png")));
}

TEST_F(ViewWindow, TheReferenceStandsBesideRealTimeAndItsLineIsDragged) {
    // Without panels the line is at 320 of 640.
    const ToolResult result = view(
        cornellPath(),
        "set live realtime\nset denoiser svgf\nset tune resolve_share=0.2\nset light-reuse biased\n"
        "set fps 1\npress Tab\nrelease Tab\nlive 3\npress B\nrelease B\nsettle 4\nmouse 320 100\n"
        "down left\nmouse 400 100\nmouse 480 100\nup left\nwait 3\nstate " + file("s.json") +
            "\nsettle 8\npicture " + file("p.png") + "\nwindow " + file("w.png") + "\n");
    VIEW_OR_SKIP(result);
    const nlohmann::json json = state("s.json");
    EXPECT_NEAR(json["divider"].get<double>(), 0.75, 1e-6);
    EXPECT_GE(json["samples_beside"].get<int>(), 1);  // they start anew if the picture grows
    EXPECT_EQ(json["denoiser"], "svgf");
    EXPECT_EQ(json["tuned"], (nlohmann::json{{"resolve_share", json["tuned"]["resolve_share"]}}));
    EXPECT_EQ(json["at_rest"], false);
    const ToolResult start = view(cornellPath(), "state " + file("0.json") + "\n");
    EXPECT_EQ(json["target"], state("0.json")["target"]) << "the drag turned the camera";
    // A white line stands there, in the file as in the window.
    const Picture window = load(file("w.png"));
    const Picture picture = load(file("p.png"));
    EXPECT_EQ(window.width, 640u);
    EXPECT_EQ(window.rgba[4 * (50 * 640 + 480)], 1.0f);
    const std::size_t column = picture.width * 3 / 4;
    EXPECT_EQ(picture.rgba[4 * (5 * std::size_t{picture.width} + column)], 1.0f);
}

TEST_F(ViewWindow, FailuresAreOneLine) {
    ToolResult result = view(cornellPath(), "set exposure bright\n");
    if (!m_hasWindow) {
        GTEST_SKIP() << "this build has no window";
    }
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("script.txt:1: exposure: 'bright' is not a number"),
              std::string::npos) << result.err;
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
    result = view(cornellPath(), "press F99\n");
    EXPECT_NE(result.err.find("script.txt:1: there is no key 'F99'"), std::string::npos);
    EXPECT_EQ(result.exitCode, 1);
    result = view(cornellPath(), "settle 1\npicture " + file("nowhere/a.png") + "\nwait 100\n");
    EXPECT_EQ(result.exitCode, 1);
    result = runTool({"view", cornellPath(), "--script", file("none.txt")});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
    result = runTool({"view", cornellPath(), "--fps", "0"});
    EXPECT_EQ(result.exitCode, 2);
}

TEST_F(ViewWindow, WithoutADisplayItSaysSo) {
    const std::string display = std::getenv("DISPLAY");
    unsetenv("DISPLAY");
    const ToolResult result = runTool({"view", cornellPath(), "--quiet"});
    setenv("DISPLAY", display.c_str(), 1);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.err.rfind("glitterpath: error: view:", 0), 0u) << result.err;
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
}

// Not our script: keys and mouse of the X server, as a person's would come.
TEST_F(ViewWindow, ObeysTheXServer) {
    if (std::system("command -v xdotool >/dev/null") != 0) {
        GTEST_SKIP() << "xdotool is not here (scripts/bootstrap installs it)";
    }
    ToolResult result;
    const std::string report = file("report.json");
    std::atomic<bool> isOver{false};
    std::thread person([&isOver] {
        const auto pause = [](int ms) {
            std::this_thread::sleep_for(std::chrono::milliseconds(ms));
        };
        // Until the window is there. Without a window manager keys go to what is under the mouse.
        std::ignore = std::system(
            "timeout 60 xdotool search --sync --onlyvisible --name Glitterpath >/dev/null");
        pause(1500);
        for (const char* words : {"mousemove 500 200", "keydown w", "sleep 1", "keyup w",
                                  "mousedown 1", "mousemove_relative 40 0", "mouseup 1",
                                  "click 4"}) {
            std::ignore = std::system((std::string("xdotool ") + words).c_str());
            pause(200);
        }
        pause(1000);
        for (int i = 0; i < 100 && !isOver; ++i) {  // should one be missed
            std::ignore = std::system("xdotool key Escape");
            pause(500);
        }
    });
    result = runTool({"view", cornellPath(), "--size", "640x360", "--quiet", "--json", report});
    isOver = true;
    person.join();
    if (result.err.find("this build has no window") != std::string::npos) {
        GTEST_SKIP() << "this build has no window";
    }
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const nlohmann::json json = readJson(report);
    const ToolResult start = view(cornellPath(), "state " + file("0.json") + "\n");
    ASSERT_EQ(start.exitCode, 0) << start.err;
    const nlohmann::json before = state("0.json");
    EXPECT_LT(json["position"][2].get<double>(),
              before["position"][2].get<double>() - 0.3 * before["speed"].get<double>());
    EXPECT_GT(json["speed"].get<double>(), before["speed"].get<double>());
    // The drag to the right turned it to +X.
    EXPECT_GT(json["target"][0].get<double>() - json["position"][0].get<double>(), 0.01);
    EXPECT_GT(json["live_frames"], 5);
}

}  // namespace
}  // namespace gp::test
