// The border between C and C++. Every entry point is one call of enter(): it finds the object,
// locks its device, runs the body and turns whatever the body throws into an error code and a
// message. Nothing throws across it.
#pragma once

#include <exception>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "api/handle.h"
#include "api/objects.h"
#include "glitterpath/glitterpath.h"

namespace gp::api {

// What bodies throw: a code, and a message without the name of the call, which report() puts first.
struct ApiError : std::exception {
    GpError code;
    std::string message;
    ApiError(GpError c, std::string m) : code(c), message(std::move(m)) {}
    const char* what() const noexcept override { return message.c_str(); }
};

template <class... Args>
[[noreturn]] void fail(GpError code, fmt::format_string<Args...> format, Args&&... args) {
    throw ApiError(code, fmt::format(format, std::forward<Args>(args)...));
}

// A body, without owning it; a std::function could throw while it is made.
class BodyRef {
public:
    template <class F>
    explicit BodyRef(F& f)
        : target_(&f), run_([](void* t, Object* o) { (*static_cast<F*>(t))(o); }) {}
    void operator()(Object* object) const { run_(target_, object); }

private:
    void* target_;
    void (*run_)(void*, Object*);
};

GpError enterObject(const char* call, const char* argument, HandleBits bits, HandleType type,
                    BodyRef body) noexcept;
// For the few calls that have no object: gpNewDevice, gpGetImageInfo.
GpError enterFree(const char* call, BodyRef body) noexcept;

// The code and message of the calling thread's first error on a device, which is then forgotten.
GpError takeError(HandleBits device, const char** message) noexcept;

// body(object) returning nothing makes a GpError; returning a handle or pointer makes that, and
// null on failure.
template <class Handle, class Body>
auto enter(const char* call, const char* argument, Handle handle, Body&& body) noexcept {
    using Target = typename HandleTraits<Handle>::Object;
    using Result = std::invoke_result_t<Body&, Target&>;
    constexpr HandleType type = HandleTraits<Handle>::type;
    if constexpr (std::is_void_v<Result>) {
        auto run = [&](Object* object) { body(static_cast<Target&>(*object)); };
        return enterObject(call, argument, bitsOf(handle), type, BodyRef(run));
    } else {
        Result result = nullptr;
        auto run = [&](Object* object) { result = body(static_cast<Target&>(*object)); };
        enterObject(call, argument, bitsOf(handle), type, BodyRef(run));
        return result;
    }
}

// A second object of the same device, named by a field or an argument. Throws ApiError.
template <class Handle>
std::shared_ptr<typename HandleTraits<Handle>::Object> resolve(DeviceObject& device, Handle handle,
                                                               const std::string& field) {
    using Target = typename HandleTraits<Handle>::Object;
    constexpr HandleType type = HandleTraits<Handle>::type;
    std::shared_ptr<Object> object = handles().find(bitsOf(handle), type);
    if (!object)
        fail(GP_ERROR_INVALID_HANDLE, "{} {}", field, handles().fault(bitsOf(handle), type));
    if (&object->owner() != &device)
        fail(GP_ERROR_INVALID_HANDLE, "{} belongs to another device", field);
    return std::static_pointer_cast<Target>(object);
}

// Makes an object public. Throws std::bad_alloc, and then nothing has happened.
template <class Handle>
Handle publish(std::shared_ptr<typename HandleTraits<Handle>::Object> object) {
    return reinterpret_cast<Handle>(handles().add(HandleTraits<Handle>::type, std::move(object)));
}

}  // namespace gp::api
