#include "progress_bar.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "output.h"

namespace gp::tool {
namespace {

int terminalColumns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
        return 80;
    }
    return size.ws_col;
}

std::string factsOf(const GpProgress& progress) {
    std::string facts = fmt::format("{} spp  {:.2f} Mrays/s", progress.samplesPerPixel,
                                    progress.raysPerSecond * 1.0e-6);
    if (progress.noise >= 0) {
        facts += fmt::format("  noise {:.2f} %", 100 * progress.noise);
    }
    if (progress.secondsRemaining >= 0) {
        facts += fmt::format("  {} left", clockText(progress.secondsRemaining));
    }
    return facts;
}

}  // namespace

bool stderrIsTerminal() {
    return isatty(STDERR_FILENO) == 1;
}

std::string ProgressBar::text(const GpProgress& progress, int columns) {
    return text(progress.fraction, factsOf(progress), columns);
}

std::string ProgressBar::text(double part, const std::string& what, int columns) {
    const double fraction = std::clamp(part, 0.0, 1.0);
    const std::string facts = fmt::format(" {:3.0f} %  {}", std::floor(100 * fraction), what);
    const int room = std::clamp(columns - static_cast<int>(facts.size()) - 3, 0, 40);
    if (room < 4) {
        return facts.substr(0, static_cast<std::size_t>(std::max(columns, 0)));
    }
    const auto filled = static_cast<std::size_t>(std::lround(fraction * room));
    const auto open = static_cast<std::size_t>(room) - filled;
    return fmt::format("[{}{}]{}", std::string(filled, '#'), std::string(open, '.'), facts);
}

void ProgressBar::show(const GpProgress& progress) {
    show(progress.fraction, factsOf(progress));
}

void ProgressBar::show(double fraction, const std::string& facts) {
    if (!m_visible) {
        return;
    }
    // Carriage return, the text, erase to the end of the line.
    fmt::print(stderr, "\r{}\x1b[K", text(fraction, facts, terminalColumns()));
    std::fflush(stderr);
    m_drawn = true;
}

void ProgressBar::clear() {
    if (m_drawn) {
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
        m_drawn = false;
    }
}

}  // namespace gp::tool
