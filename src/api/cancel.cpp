#include "api/cancel.h"

#include <array>

namespace gp::api {

namespace {

static_assert(std::atomic<bool>::is_always_lock_free &&
                  std::atomic<HandleBits>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

struct Entry {
    std::atomic<HandleBits> device{0};
    std::atomic<bool> taken{false};
    std::atomic<bool> flag{false};
};

// Initialised by the compiler, so that it is there before every other code.
constinit std::array<Entry, mostDevices> entries;

}  // namespace

std::atomic<bool>* takeCancelFlag() {
    for (Entry& entry : entries)
        if (!entry.taken.exchange(true)) return &entry.flag;
    return nullptr;
}

void nameCancelFlag(std::atomic<bool>* flag, HandleBits device) {
    for (Entry& entry : entries)
        if (&entry.flag == flag) entry.device.store(device);
}

void returnCancelFlag(std::atomic<bool>* flag) {
    for (Entry& entry : entries) {
        if (&entry.flag != flag) continue;
        entry.device.store(0);
        entry.flag.store(false);
        entry.taken.store(false);
    }
}

void requestCancel(HandleBits device) {
    if (device == 0) return;
    for (Entry& entry : entries)
        if (entry.device.load() == device) entry.flag.store(true);
}

}  // namespace gp::api
