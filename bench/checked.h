// Calls of the public interface whose failure ends a benchmark with the library's own message.
#pragma once

#include <stdexcept>

#include <glitterpath/glitterpath.h>

namespace gp::bench {

inline void check(GpDevice device, GpError error) {
    if (error == GP_SUCCESS) return;
    const char* message = "";
    gpGetError(device, &message);
    throw std::runtime_error(message);
}

template <class T>
T made(GpDevice device, T handle) {
    if (!handle) check(device, GP_ERROR_UNKNOWN);
    return handle;
}

}  // namespace gp::bench
