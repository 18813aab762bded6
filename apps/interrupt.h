// Ctrl-C: the first one ends the render and keeps what there is, a second one kills.
#pragma once

#include <glitterpath/glitterpath.h>

namespace gp::tool {

// While it lives, SIGINT and SIGTERM cancel renders of the device; NULL: they cancel nothing, and
// interrupted() alone tells. One at a time.
class InterruptGuard {
public:
    explicit InterruptGuard(GpDevice device);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

// Whether one of the signals has come.
bool interrupted();

}  // namespace gp::tool
