#include "api/boundary.h"

#include <algorithm>
#include <new>

#include "io/file_error.h"

namespace gp::api {

namespace {

struct ErrorRecord {
    HandleBits device = 0;  // 0: calls that had no valid device
    GpError code = GP_SUCCESS;
    std::string message;
};

// Each thread has its own errors: a thread never sees those of another.
thread_local std::vector<ErrorRecord> threadErrors;
thread_local std::string takenMessage;

// Errors that nobody asks for must not pile up in programs that make and release many devices.
constexpr size_t recordsBeforeSweep = 64;

void remember(HandleBits device, GpError code, const std::string& message) noexcept {
    try {
        auto same = [&](const ErrorRecord& r) { return r.device == device; };
        if (std::any_of(threadErrors.begin(), threadErrors.end(), same)) return;
        if (threadErrors.size() >= recordsBeforeSweep)
            std::erase_if(threadErrors, [](const ErrorRecord& r) {
                return r.device != 0 && !handles().alive(r.device);
            });
        threadErrors.push_back({device, code, message});
    } catch (...) {
        // Out of memory while noting an error: the code is still returned by the call itself.
    }
}

// `callback` is false in a call made from a callback, which must not be called again.
GpError report(DeviceObject* device, const char* call, GpError code, const char* what,
               bool callback) noexcept {
    std::string message;
    try {
        message = fmt::format("{}: {}", call, what);
        // One line, whatever a file or a library put into the text.
        std::replace_if(
            message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    } catch (...) {
        message.clear();
    }
    remember(device ? device->self : 0, code, message);
    if (device && device->errorCallback && callback) {
        try {
            const char* text = message.empty() ? call : message.c_str();
            device->errorCallback(device->errorUser, code, text);
        } catch (...) {
            // A C++ program's callback that throws must not unwind through C.
        }
    }
    return code;
}

GpError codeOf(io::FileError::Kind kind) {
    switch (kind) {
        case io::FileError::Kind::notFound: return GP_ERROR_FILE_NOT_FOUND;
        case io::FileError::Kind::invalid: return GP_ERROR_FILE_INVALID;
        case io::FileError::Kind::unsupported: return GP_ERROR_UNSUPPORTED;
        case io::FileError::Kind::writeFailed: return GP_ERROR_FILE_WRITE;
    }
    return GP_ERROR_UNKNOWN;
}

GpError reportCurrentException(DeviceObject* device, const char* call) noexcept {
    try {
        throw;
    } catch (const ApiError& e) {
        return report(device, call, e.code, e.what(), true);
    } catch (const io::FileError& e) {
        return report(device, call, codeOf(e.kind), e.what(), true);
    } catch (const std::bad_alloc&) {
        return report(device, call, GP_ERROR_OUT_OF_MEMORY, "out of memory", true);
    } catch (const std::length_error&) {
        return report(device, call, GP_ERROR_OUT_OF_MEMORY, "larger than memory can be", true);
    } catch (const std::exception& e) {
        return report(device, call, GP_ERROR_UNKNOWN, e.what(), true);
    } catch (...) {
        return report(device, call, GP_ERROR_UNKNOWN, "an unknown exception", true);
    }
}

class DeviceLock {
public:
    explicit DeviceLock(DeviceObject& device) : device_(device) {
        held_ = device.holder.load() != std::this_thread::get_id();
        if (!held_) return;
        device.mutex.lock();
        device.holder.store(std::this_thread::get_id());
    }
    ~DeviceLock() {
        if (!held_) return;
        device_.holder.store(std::thread::id{});
        device_.mutex.unlock();
    }
    DeviceLock(const DeviceLock&) = delete;
    DeviceLock& operator=(const DeviceLock&) = delete;
    bool held() const { return held_; }

private:
    DeviceObject& device_;
    bool held_ = false;
};

GpError reportBadHandle(const char* call, const char* argument, HandleBits bits,
                        HandleType type) noexcept {
    try {
        const std::string what = fmt::format("{} {}", argument, handles().fault(bits, type));
        return report(nullptr, call, GP_ERROR_INVALID_HANDLE, what.c_str(), true);
    } catch (...) {
        return report(nullptr, call, GP_ERROR_INVALID_HANDLE, "invalid handle", true);
    }
}

}  // namespace

GpError enterObject(const char* call, const char* argument, HandleBits bits, HandleType type,
                    BodyRef body) noexcept {
    // Declared before the lock: the last reference to a device must end after its mutex is free.
    const std::shared_ptr<Object> object = handles().find(bits, type);
    if (!object) return reportBadHandle(call, argument, bits, type);
    DeviceObject& device = object->owner();
    DeviceLock lock(device);
    if (!lock.held())
        return report(&device, call, GP_ERROR_INVALID_OPERATION, "called from a callback", false);
    // Another thread may have released it while this one waited for the lock.
    if (!handles().find(bits, type)) return reportBadHandle(call, argument, bits, type);
    try {
        body(object.get());
        return GP_SUCCESS;
    } catch (...) {
        return reportCurrentException(&device, call);
    }
}

GpError enterFree(const char* call, BodyRef body) noexcept {
    try {
        body(nullptr);
        return GP_SUCCESS;
    } catch (...) {
        return reportCurrentException(nullptr, call);
    }
}

GpError takeError(HandleBits device, const char** message) noexcept {
    if (message) *message = "";
    if (device != 0 && !handles().find(device, HandleType::device)) {
        if (message) *message = "gpGetError: device is not a living device";
        return GP_ERROR_INVALID_HANDLE;
    }
    for (ErrorRecord& record : threadErrors) {
        if (record.device != device) continue;
        const GpError code = record.code;
        takenMessage = std::move(record.message);
        if (message) *message = takenMessage.c_str();
        if (&record != &threadErrors.back()) record = std::move(threadErrors.back());
        threadErrors.pop_back();
        return code;
    }
    return GP_SUCCESS;
}

}  // namespace gp::api
