// A display without a screen: Xvfb, for as long as a test needs it.
#pragma once

#include <sys/types.h>

#include <string>

namespace gp::test {

class VirtualDisplay {
public:
    // Starts Xvfb on a number of its own choice and sets DISPLAY; isThere() tells whether it could.
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    bool isThere() const { return !m_name.empty(); }

private:
    pid_t m_child = -1;
    std::string m_name, m_before;
};

}  // namespace gp::test
