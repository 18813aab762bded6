// The line that moves while a render runs. Only people at a terminal see it.
#pragma once

#include <glitterpath/glitterpath.h>

#include <string>

namespace gp::tool {

class ProgressBar {
public:
    explicit ProgressBar(bool visible) : m_visible(visible) {}
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(const GpProgress& progress);
    // fraction: 0..1 of the whole; facts: what the line says behind the bar and the percentage.
    void show(double fraction, const std::string& facts);
    void clear();

    // What the line says, at most `columns` wide; apart from the terminal, for tests.
    static std::string text(const GpProgress& progress, int columns);
    static std::string text(double fraction, const std::string& facts, int columns);

private:
    bool m_visible = false;
    bool m_drawn = false;
};

// Whether stderr is a terminal.
bool stderrIsTerminal();

}  // namespace gp::tool
