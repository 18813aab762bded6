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
    void clear();

    // What the line says, at most `columns` wide; apart from the terminal, for tests.
    static std::string text(const GpProgress& progress, int columns);

private:
    bool m_visible = false;
    bool m_drawn = false;
};

// Whether stderr is a terminal.
bool stderrIsTerminal();

}  // namespace gp::tool
