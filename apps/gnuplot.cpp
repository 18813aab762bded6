#include "gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "output.h"
#include "temporary_folder.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kScript = "script.gp";
constexpr const char* kPicture = "picture";
constexpr const char* kMessages = "messages";

bool isSvg(const std::string& path) {
    return path.ends_with(".svg");
}

// Names in legends keep their underscores; axes may have subscripts (theta_h).
std::string headOf(const GnuplotJob& job, const std::string& path) {
    return fmt::format("set encoding utf8\nset terminal {} size {},{} enhanced font 'Sans,11' "
                       "background rgb 'white'\nset output '{}'\nset key noenhanced\n",
                       isSvg(path) ? "svg" : "pngcairo", job.width, job.height, kPicture);
}

std::string oneLineOf(const std::string& text) {
    std::istringstream words(text);
    std::string line;
    for (std::string word; words >> word;) {
        line += (line.empty() ? "" : " ") + word;
    }
    return line;
}

// The process runs in the folder, so that the script needs no paths; no shell is involved.
int runGnuplot(const TemporaryFolder& folder) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, kMessages,
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    std::string words[] = {"gnuplot", "--default-settings", kScript};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    pid_t child = 0;
    const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT) {
        throw RunError("drawing needs gnuplot on the PATH (Debian: gnuplot-nox)");
    }
    if (error != 0) {
        throw RunError(fmt::format("cannot start gnuplot: {}", std::strerror(error)));
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

std::string gnuplotText(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') {
            quoted += "''";
        } else {
            quoted += static_cast<unsigned char>(c) < 32 ? ' ' : c;  // a script is made of lines
        }
    }
    return quoted + "'";
}

void checkDrawable(const std::string& path) {
    if (!path.ends_with(".png") && !isSvg(path)) {
        throw UsageError(fmt::format("--output: '{}' must end in .png or .svg", path));
    }
    checkWritable(path);
}

void drawWithGnuplot(const GnuplotJob& job, const std::string& path) {
    checkDrawable(path);
    const TemporaryFolder folder;
    writeText(folder(kScript), headOf(job, path) + job.script);
    for (const GnuplotFile& file : job.files) {
        writeText(folder(file.name), file.bytes);
    }
    const int status = runGnuplot(folder);
    if (WIFSIGNALED(status)) {
        throw RunError(fmt::format("gnuplot was ended by signal {}", WTERMSIG(status)));
    }
    const std::string picture = bytesOfFile(folder(kPicture));
    if (WEXITSTATUS(status) != 0 || picture.empty()) {
        throw RunError(
            fmt::format("gnuplot failed: {}", oneLineOf(bytesOfFile(folder(kMessages)))));
    }
    writeText(path, picture);
}

}  // namespace gp::tool
