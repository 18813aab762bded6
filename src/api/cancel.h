// Cancelling must work from a signal handler: no locks, no memory, only lock-free atomics in a
// table that lives as long as the process.
#pragma once

#include <atomic>

#include "api/handle.h"

namespace gp::api {

constexpr uint32_t mostDevices = 256;  // that live at one time

// Takes a free entry; null when there is none.
std::atomic<bool>* takeCancelFlag();
// From now on requestCancel(device) reaches the flag.
void nameCancelFlag(std::atomic<bool>* flag, HandleBits device);
void returnCancelFlag(std::atomic<bool>* flag);
void requestCancel(HandleBits device);

}  // namespace gp::api
