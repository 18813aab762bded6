#include "shading/glsl_compiler.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

namespace gp::test {
namespace {

std::string readAll(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string shellQuoted(const std::filesystem::path& path) {
    std::string text(1, '\'');
    return text.append(path.string()).append(1, '\'');
}

}  // namespace

std::vector<uint32_t> compileCompute(const std::string& source, const std::string& name) {
    // A folder a process: ctest runs several at once.
    const std::filesystem::path folder = std::filesystem::path(GP_BINARY_DIR) / "differential" /
                                         (name + "." + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::filesystem::path text = folder / (name + ".comp");
    const std::filesystem::path spirv = folder / (name + ".spv");
    const std::filesystem::path messages = folder / (name + ".log");
    std::ofstream(text, std::ios::binary) << source;
    const std::string command =
        fmt::format("{} -V --target-env vulkan1.1 -I{} -o {} {} > {} 2>&1", shellQuoted(GP_GLSLANG),
                    shellQuoted(GP_SOURCE_DIR "/src"), shellQuoted(spirv), shellQuoted(text),
                    shellQuoted(messages));
    if (std::system(command.c_str()) != 0) {
        throw std::runtime_error(command + "\n" + readAll(messages));
    }
    const std::string bytes = readAll(spirv);
    std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
    std::filesystem::remove_all(folder);  // kept only when something went wrong
    return words;
}

}  // namespace gp::test
