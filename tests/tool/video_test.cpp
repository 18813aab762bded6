// Videos of `glitterpath animate`: through ffmpeg, without it, and with one that fails.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "tool_runner.h"

namespace gp::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// What a program of the machine prints; empty where it is not there.
std::string outputOf(const std::string& command) {
    std::FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
    std::string text;
    char buffer[256];
    while (pipe != nullptr && std::fgets(buffer, sizeof buffer, pipe) != nullptr) {
        text += buffer;
    }
    if (pipe != nullptr) {
        pclose(pipe);
    }
    return text;
}

bool hasFfmpeg() {
    return !outputOf("ffmpeg -version").empty();
}

ToolResult animate(const std::string& out, const Words& more, double signalAfter = -1) {
    Words words = {"animate", cornellPath(), "-o", out, "--size", "64x48", "--mode", "reference",
                   "--spp", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return runTool(words, signalAfter);
}

// PATH is another one while this lives.
class OtherPath {
public:
    explicit OtherPath(const std::string& path) : m_before(std::getenv("PATH")) {
        setenv("PATH", path.c_str(), 1);
    }
    ~OtherPath() { setenv("PATH", m_before.c_str(), 1); }

private:
    std::string m_before;
};

TEST(Video, HasTheFramesThatFilesHave) {
    if (!hasFfmpeg()) {
        GTEST_SKIP() << "ffmpeg is missing";
    }
    const TestFolder folder;
    const Words motion = {"--frames", "5", "--fps", "12.5", "--path", "orbit", "--exposure", "-2"};
    ASSERT_EQ(animate(folder("%d.png"), motion).exitCode, 0);
    for (const std::string ending : {"mp4", "mkv", "webm"}) {
        const std::string video = folder("a." + ending);
        const ToolResult result = animate(video, motion);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(outputOf("ffprobe -v error -count_frames -select_streams v -of csv=p=0 "
                           "-show_entries stream=width,height,color_space,r_frame_rate,"
                           "nb_read_frames " + video),
                  "64,48,bt709,25/2,5\n") << ending;
        outputOf("ffmpeg -v error -i " + video + " -start_number 0 " + folder("back%d.png"));
        for (int i = 0; i < 5; ++i) {
            unsigned width = 0;
            unsigned height = 0;
            const auto a = readPicture(folder(std::to_string(i) + ".png"), width, height);
            const auto b = readPicture(folder("back" + std::to_string(i) + ".png"), width, height);
            ASSERT_EQ(a.size(), b.size());
            double square = 0;
            double mean = 0;
            for (std::size_t k = 0; k < a.size(); ++k) {
                if (k % 4 == 3) {
                    continue;  // videos have no coverage
                }
                square += std::pow(a[k] - b[k], 2) / static_cast<double>(a.size());
                mean += (b[k] - a[k]) / static_cast<double>(a.size());
            }
            // Noise is what codecs are bad at, and 4 samples leave much; a wrong matrix or range
            // would show in the mean.
            EXPECT_LT(std::sqrt(square), 0.08) << ending << " " << i;
            EXPECT_LT(std::abs(mean), 0.006) << ending << " " << i;
        }
    }
    EXPECT_EQ(folder.fileCount(), 5u + 3u + 5u);  // nothing temporary
}

TEST(Video, NeedsFfmpegAndSaysSoBeforeTheFirstFrame) {
    const TestFolder folder;
    const std::string scene = cornellPath();  // made while there still is a PATH
    const OtherPath nothing(folder("nowhere"));
    const ToolResult result = animate(folder("a.mp4"), {"--frames", "100000"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(linesOf(result.err).size(), 1u);
    EXPECT_NE(result.err.find("ffmpeg on the PATH"), std::string::npos) << result.err;
    EXPECT_EQ(folder.fileCount(), 0u);
}

// One that cannot write, and tells why in its last line.
TEST(Video, FailuresOfFfmpegAreTold) {
    const TestFolder folder;
    const std::string scene = cornellPath();
    fs::create_directory(folder("bin"));
    writeText(folder("bin/ffmpeg"),
              "#!/bin/sh\necho first words >&2\necho no room on the disk >&2\nexit 3\n");
    fs::permissions(folder("bin/ffmpeg"), fs::perms::owner_all);
    const OtherPath other(folder("bin"));
    const ToolResult result = animate(folder("a.mp4"), {"--frames", "40"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("ffmpeg failed (3): no room on the disk"), std::string::npos)
        << result.err;
    EXPECT_EQ(folder.fileCount(), 1u);  // its folder
}

TEST(Video, CtrlCLeavesAWholeOne) {
    if (!hasFfmpeg()) {
        GTEST_SKIP() << "ffmpeg is missing";
    }
    const TestFolder folder;
    const ToolResult result = animate(folder("a.mp4"), {"--frames", "100000"}, 4.0);
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_EQ(folder.fileCount(), 1u);
    const std::string frames = outputOf("ffprobe -v error -count_frames -select_streams v -of "
                                        "csv=p=0 -show_entries stream=nb_read_frames " +
                                        folder("a.mp4"));
    const std::string count = frames.substr(0, frames.find('\n'));
    EXPECT_NE(result.err.find("a.mp4: " + count + " frames"), std::string::npos)
        << result.err << frames;
}

// A scene that cannot be loaded is found after the program was started: nothing may stay.
TEST(Video, OtherFailuresLeaveNothing) {
    const TestFolder folder;
    writeText(folder("bad.gltf"), "{}");
    const ToolResult result = runTool({"animate", folder("bad.gltf"), "-o", folder("a.mp4"),
                                       "--frames", "3", "--mode", "reference"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
    EXPECT_EQ(folder.fileCount(), 1u);
}

}  // namespace
}  // namespace gp::test
