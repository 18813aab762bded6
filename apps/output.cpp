#include "output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "tool_error.h"

namespace gp::tool {
namespace {

namespace fs = std::filesystem;

void writeAll(std::FILE* file, const std::string& text, const std::string& label) {
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if (!written || std::fflush(file) != 0) {
        throw RunError(fmt::format("{}: cannot write: {}", label, std::strerror(errno)));
    }
}

}  // namespace

void checkWritable(const std::string& path) {
    if (path == "-") {
        return;
    }
    std::error_code ignored;
    const fs::path target(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored)) {
        throw RunError(fmt::format("{}: there is no folder {}", path, folder.string()));
    }
    if (fs::is_directory(target, ignored)) {
        throw RunError(fmt::format("{}: is a folder", path));
    }
    if (::access(folder.c_str(), W_OK) != 0) {
        throw RunError(fmt::format("{}: cannot write there: {}", path, std::strerror(errno)));
    }
}

void writeText(const std::string& path, const std::string& text) {
    if (path == "-") {
        writeAll(stdout, text, "stdout");
        return;
    }
    const std::string temporary = fmt::format("{}.part{}", path, ::getpid());
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (file == nullptr) {
        throw RunError(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
    }
    try {
        writeAll(file, text, path);
    } catch (...) {
        std::fclose(file);
        std::remove(temporary.c_str());
        throw;
    }
    if (std::fclose(file) != 0 || std::rename(temporary.c_str(), path.c_str()) != 0) {
        const std::string reason = std::strerror(errno);
        std::remove(temporary.c_str());
        throw RunError(fmt::format("{}: cannot write: {}", path, reason));
    }
}

void writeJson(const std::string& path, const nlohmann::ordered_json& json) {
    // Names in a scene file may not be valid UTF-8; they must not stop us here.
    using Json = nlohmann::ordered_json;
    writeText(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string clockText(double seconds) {
    const auto whole = static_cast<long long>(std::llround(std::max(0.0, seconds)));
    if (whole < 3600) {
        return fmt::format("{}:{:02}", whole / 60, whole % 60);
    }
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string bytesText(double bytes) {
    const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    while (bytes >= 1000.0 && unit < 4) {
        bytes /= 1000.0;
        ++unit;
    }
    return fmt::format("{:.{}f} {}", bytes, unit == 0 ? 0 : 1, units[unit]);
}

}  // namespace gp::tool
