#include "tool_runner.h"

#include <glitterpath/glitterpath.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gp::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (pipe(ends) != 0) {
            throw std::runtime_error("pipe failed");
        }
    }
};

[[noreturn]] void becomeTool(const std::vector<std::string>& arguments, const Pipe& out,
                             const Pipe& err) {
    dup2(out.ends[1], STDOUT_FILENO);
    dup2(err.ends[1], STDERR_FILENO);
    for (int end : {out.ends[0], out.ends[1], err.ends[0], err.ends[1]}) {
        close(end);
    }
    std::vector<char*> words = {const_cast<char*>(GP_TOOL)};
    for (const std::string& argument : arguments) {
        words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    execv(GP_TOOL, words.data());
    _exit(127);
}

// Reads both pipes to their ends, so that neither fills up, and sends the signal on the way.
void collect(pid_t child, const Pipe& out, const Pipe& err, ToolResult& result, double after) {
    const Clock::time_point start = Clock::now();
    bool signalLeft = after >= 0;
    pollfd files[2] = {{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}};
    std::string* texts[2] = {&result.out, &result.err};
    while (files[0].fd >= 0 || files[1].fd >= 0) {
        poll(files, 2, 5);
        for (int i = 0; i < 2; ++i) {
            if (files[i].fd < 0 || files[i].revents == 0) {
                continue;
            }
            char buffer[4096];
            const ssize_t count = read(files[i].fd, buffer, sizeof buffer);
            if (count > 0) {
                texts[i]->append(buffer, static_cast<std::size_t>(count));
            } else {
                files[i].fd = -1;  // poll passes over negative ones
            }
        }
        const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        if (signalLeft && elapsed >= after) {
            kill(child, SIGINT);
            signalLeft = false;
        }
    }
}

}  // namespace

ToolResult runTool(const std::vector<std::string>& arguments, double signalAfterSeconds) {
    const Pipe out;
    const Pipe err;
    const pid_t child = fork();
    if (child == 0) {
        becomeTool(arguments, out, err);
    }
    close(out.ends[1]);
    close(err.ends[1]);
    ToolResult result;
    collect(child, out, err, result, signalAfterSeconds);
    close(out.ends[0]);
    close(err.ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

void expectRefusal(const ToolResult& result, int exitCode, const std::string& says) {
    EXPECT_EQ(result.exitCode, exitCode) << says;
    EXPECT_EQ(linesOf(result.err).size(), 1u) << result.err;
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

bool exists(const std::string& path) {
    return fs::exists(path);
}

std::string readText(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void writeText(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

nlohmann::json readJson(const std::string& path) {
    return nlohmann::json::parse(readText(path));
}

TestFolder::TestFolder() {
    std::string pattern = fs::temp_directory_path() / "glitterpath-test-XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) {
        throw std::runtime_error("mkdtemp failed");
    }
    m_path = pattern;
}

TestFolder::~TestFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

std::size_t TestFolder::fileCount() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(m_path), fs::directory_iterator{}));
}

void writePicture(const std::string& path, unsigned width, unsigned height,
                  const std::vector<float>& rgba) {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    GpDevice device = gpNewDevice(&desc);
    std::vector<float> pixels = rgba;
    GpImage image{};
    image.width = width;
    image.height = height;
    image.pixels = pixels.data();
    ASSERT_EQ(gpSaveImage(device, path.c_str(), &image), GP_SUCCESS) << path;
    gpReleaseDevice(device);
}

std::vector<float> uniformRgba(unsigned width, unsigned height, float r, float g, float b) {
    std::vector<float> rgba;
    for (unsigned i = 0; i < width * height; ++i) {
        rgba.insert(rgba.end(), {r, g, b, 1.0f});
    }
    return rgba;
}

std::vector<float> readPicture(const std::string& path, unsigned& width, unsigned& height) {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    GpDevice device = gpNewDevice(&desc);
    GpImage image{};
    EXPECT_EQ(gpLoadImage(device, path.c_str(), &image), GP_SUCCESS) << path;
    width = image.width;
    height = image.height;
    std::vector<float> rgba(image.pixels,
                            image.pixels + 4 * std::size_t{image.width} * image.height);
    gpFreeImage(&image);
    gpReleaseDevice(device);
    return rgba;
}

const std::string& cornellPath() {
    static const TestFolder folder;
    static const std::string path = [] {
        const std::string file = folder("cornell.glb");
        const ToolResult result = runTool({"make-scene", "cornell", "-o", file});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return file;
    }();
    return path;
}

void writeTriangleScene(const std::string& path) {
    // Three positions: (0,0,0), (1,0,0), (0,1,0) as little-endian floats in base 64.
    writeText(path, R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
                    R"("}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
"min": [0, 0, 0], "max": [1, 1, 0]}]})");
}

}  // namespace gp::test
