// Handles: what the C interface hands out instead of pointers. A handle is a number, the index of
// a slot with the slot's generation and the type of its object, so that any value whatsoever can
// be checked without touching memory that it might point to.
#pragma once

#include <cstdint>
#include <memory>
#include <shared_mutex>
#include <vector>

namespace gp::api {

struct DeviceObject;

// From 1, so that the top four bits of a handle are never all zero, as those of real addresses are.
enum class HandleType : uint32_t {
    device = 1, texture, material, mesh, scene, instance, light, frame, bsdf, immediate
};
const char* handleTypeName(HandleType type);

// What a handle stands for. Lives on while a call or another object uses it.
struct Object : std::enable_shared_from_this<Object> {
    virtual ~Object() = default;
    virtual DeviceObject& owner() = 0;
};

using HandleBits = uint64_t;
static_assert(sizeof(void*) == sizeof(HandleBits), "handles are 64-bit numbers");

inline HandleBits bitsOf(const void* handle) { return reinterpret_cast<HandleBits>(handle); }

class HandleTable {
public:
    // Throws std::bad_alloc, and ApiError when 2^30 objects live.
    HandleBits add(HandleType type, std::shared_ptr<Object> object);
    // Null unless `bits` is a living handle of this type.
    std::shared_ptr<Object> find(HandleBits bits, HandleType type) const;
    // Takes a living handle out; the object is returned so that it ends outside of the lock.
    std::shared_ptr<Object> remove(HandleBits bits);
    // Takes out everything that belongs to a device, the device's own handle included.
    std::vector<std::shared_ptr<Object>> removeAllOf(const DeviceObject& device);
    // Why find() gave null, as the end of a sentence: "is NULL", "was released", ...
    const char* fault(HandleBits bits, HandleType type) const;
    bool alive(HandleBits bits) const;

private:
    struct Slot {
        std::shared_ptr<Object> object;  // null: free
        uint32_t generation = 1;
        HandleType type = HandleType::device;
    };
    const Slot* living(HandleBits bits) const;  // call with the lock held
    std::shared_ptr<Object> empty(uint32_t index);

    mutable std::shared_mutex mutex_;
    std::vector<Slot> slots_;
    std::vector<uint32_t> free_;  // has room for every slot, so that removing never throws
};

// The one table of the process; never destroyed, because calls may come from exit handlers.
HandleTable& handles();

}  // namespace gp::api
