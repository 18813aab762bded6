#include "api/handle.h"

#include <mutex>

#include "api/boundary.h"

namespace gp::api {

namespace {

// A handle from its top bit down: type (4), generation (30), slot (30).
constexpr uint32_t slotBits = 30;
constexpr uint32_t generationBits = 30;
constexpr uint32_t lastGeneration = (1u << generationBits) - 1;
constexpr uint32_t slotLimit = 1u << slotBits;

HandleBits encode(uint32_t slot, uint32_t generation, HandleType type) {
    return (HandleBits(type) << (slotBits + generationBits)) |
           (HandleBits(generation) << slotBits) | slot;
}
uint32_t slotOf(HandleBits bits) { return uint32_t(bits & (slotLimit - 1)); }
uint32_t generationOf(HandleBits bits) { return uint32_t(bits >> slotBits) & lastGeneration; }
uint32_t typeOf(HandleBits bits) { return uint32_t(bits >> (slotBits + generationBits)); }

}  // namespace

const char* handleTypeName(HandleType type) {
    switch (type) {
        case HandleType::device: return "device";
        case HandleType::texture: return "texture";
        case HandleType::material: return "material";
        case HandleType::mesh: return "mesh";
        case HandleType::scene: return "scene";
        case HandleType::instance: return "instance";
        case HandleType::light: return "light";
        case HandleType::frame: return "frame";
        case HandleType::bsdf: return "bsdf";
        case HandleType::immediate: return "immediate";
    }
    return "object";
}

HandleBits HandleTable::add(HandleType type, std::shared_ptr<Object> object) {
    std::unique_lock lock(mutex_);
    if (free_.empty()) {
        if (slots_.size() >= slotLimit) fail(GP_ERROR_TOO_LARGE, "2^30 handles are in use");
        slots_.emplace_back();
        // The new slot is on neither list until the next line succeeds; then it is free.
        try {
            free_.reserve(slots_.capacity());
        } catch (...) {
            slots_.pop_back();
            throw;
        }
        free_.push_back(uint32_t(slots_.size() - 1));
    }
    const uint32_t index = free_.back();
    free_.pop_back();
    Slot& slot = slots_[index];
    slot.object = std::move(object);
    slot.type = type;
    return encode(index, slot.generation, type);
}

const HandleTable::Slot* HandleTable::living(HandleBits bits) const {
    const uint32_t index = slotOf(bits);
    if (index >= slots_.size()) return nullptr;
    const Slot& slot = slots_[index];
    const bool same = slot.object && slot.generation == generationOf(bits) &&
                      uint32_t(slot.type) == typeOf(bits);
    return same ? &slot : nullptr;
}

std::shared_ptr<Object> HandleTable::find(HandleBits bits, HandleType type) const {
    std::shared_lock lock(mutex_);
    const Slot* slot = living(bits);
    return slot && slot->type == type ? slot->object : nullptr;
}

bool HandleTable::alive(HandleBits bits) const {
    std::shared_lock lock(mutex_);
    return living(bits) != nullptr;
}

std::shared_ptr<Object> HandleTable::empty(uint32_t index) {
    Slot& slot = slots_[index];
    std::shared_ptr<Object> object = std::move(slot.object);
    slot.object = nullptr;
    // A slot whose generations are used up is never used again: an old handle must not come to
    // mean a new object, however long a program runs.
    if (slot.generation < lastGeneration) {
        ++slot.generation;
        free_.push_back(index);
    }
    return object;
}

std::shared_ptr<Object> HandleTable::remove(HandleBits bits) {
    std::unique_lock lock(mutex_);
    return living(bits) ? empty(slotOf(bits)) : nullptr;
}

std::vector<std::shared_ptr<Object>> HandleTable::removeAllOf(const DeviceObject& device) {
    std::unique_lock lock(mutex_);
    std::vector<uint32_t> indices;
    for (uint32_t i = 0; i < slots_.size(); ++i)
        if (slots_[i].object && &slots_[i].object->owner() == &device) indices.push_back(i);
    std::vector<std::shared_ptr<Object>> removed;
    removed.reserve(indices.size());
    for (uint32_t i : indices) removed.push_back(empty(i));
    return removed;
}

const char* HandleTable::fault(HandleBits bits, HandleType type) const {
    if (bits == 0) return "is NULL";
    std::shared_lock lock(mutex_);
    const uint32_t index = slotOf(bits);
    const bool known = typeOf(bits) >= uint32_t(HandleType::device) &&
                       typeOf(bits) <= uint32_t(HandleType::immediate) && index < slots_.size() &&
                       generationOf(bits) >= 1 && generationOf(bits) <= slots_[index].generation;
    if (!known) return "is not a handle";
    if (typeOf(bits) != uint32_t(type)) return "is a handle of another type";
    return "was released";
}

HandleTable& handles() {
    static HandleTable& table = *new HandleTable;
    return table;
}

}  // namespace gp::api
