#include "interrupt.h"

#include <atomic>
#include <csignal>

namespace gp::tool {
namespace {

// Signal handlers may touch lock-free atomics only.
std::atomic<GpDevice> g_device{nullptr};
std::atomic<bool> g_interrupted{false};
static_assert(std::atomic<GpDevice>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void setHandlers(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;  // writing the file must not fail with EINTR
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

extern "C" void onInterrupt(int) {
    // From here on the signals kill: whoever presses twice means it.
    setHandlers(SIG_DFL);
    g_interrupted = true;
    if (GpDevice device = g_device) {
        gpCancelRender(device);
    }
}

}  // namespace

InterruptGuard::InterruptGuard(GpDevice device) {
    g_device = device;
    setHandlers(&onInterrupt);
}

InterruptGuard::~InterruptGuard() {
    setHandlers(SIG_DFL);
    g_device = nullptr;
}

bool interrupted() {
    return g_interrupted;
}

}  // namespace gp::tool
