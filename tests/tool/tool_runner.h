// Running the tool, and a folder for what it writes.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace gp::test {

struct ToolResult {
    int exitCode = -1;   // 128 + n when signal n ended it
    std::string out, err;
};

// Runs the tool with stdout and stderr in pipes. After `signalAfterSeconds` (none: < 0) it is sent
// SIGINT.
ToolResult runTool(const std::vector<std::string>& arguments, double signalAfterSeconds = -1);

std::vector<std::string> linesOf(const std::string& text);
// That it ended with this code, and one line that says so.
void expectRefusal(const ToolResult& result, int exitCode, const std::string& says);
bool exists(const std::string& path);
std::string readText(const std::string& path);
void writeText(const std::string& path, const std::string& text);
nlohmann::json readJson(const std::string& path);

// A folder of one test's own, empty at first, removed at its end.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    std::string operator()(const std::string& name) const { return m_path + "/" + name; }
    std::size_t fileCount() const;

private:
    std::string m_path;
};

// A linear picture, RGBA; `path` ends in .png, .exr or .hdr.
void writePicture(const std::string& path, unsigned width, unsigned height,
                  const std::vector<float>& rgba);
std::vector<float> uniformRgba(unsigned width, unsigned height, float r, float g, float b);
// The pixels of a picture file, RGBA, linear.
std::vector<float> readPicture(const std::string& path, unsigned& width, unsigned& height);

// A closed box to render: `make-scene cornell`, made once for all tests.
const std::string& cornellPath();
// One triangle of the test's own, without light and without a camera.
void writeTriangleScene(const std::string& path);

}  // namespace gp::test
