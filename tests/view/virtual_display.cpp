#include "virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace gp::test {
namespace {

constexpr int kLongestStartMs = 20000;

// The server writes its number when it is ready; nothing comes where there is no Xvfb.
std::string readNumber(int file) {
    std::string text;
    pollfd waiting{file, POLLIN, 0};
    while (text.find('\n') == std::string::npos && poll(&waiting, 1, kLongestStartMs) > 0) {
        char buffer[32];
        const ssize_t count = read(file, buffer, sizeof buffer);
        if (count <= 0) {
            return "";
        }
        text.append(buffer, static_cast<std::size_t>(count));
    }
    return text.substr(0, text.find('\n'));
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
    int ends[2];
    if (pipe(ends) != 0) {
        return;
    }
    const std::string number = std::to_string(ends[1]);
    m_child = fork();
    if (m_child == 0) {
        close(ends[0]);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24",
               "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    const std::string display = readNumber(ends[0]);
    close(ends[0]);
    if (!display.empty()) {
        m_name = ":" + display;
        const char* before = std::getenv("DISPLAY");
        m_before = before == nullptr ? "" : before;
        setenv("DISPLAY", m_name.c_str(), 1);
    }
}

VirtualDisplay::~VirtualDisplay() {
    if (m_child > 0) {
        kill(m_child, SIGTERM);
        waitpid(m_child, nullptr, 0);
    }
    if (m_before.empty()) {
        unsetenv("DISPLAY");
    } else {
        setenv("DISPLAY", m_before.c_str(), 1);
    }
}

}  // namespace gp::test
