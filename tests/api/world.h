// A small world on the null backend that every misuse row gets fresh: one living object of each
// kind, the same released, and the same left over from a released device.
#pragma once

#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glitterpath/glitterpath.h"

namespace gp::test {

// One handle of each kind.
struct Handles {
    GpDevice device = nullptr;
    GpTexture texture = nullptr;
    GpMaterial material = nullptr;
    GpMesh mesh = nullptr;  // movable
    GpScene scene = nullptr;
    GpInstance instance = nullptr;
    GpLight light = nullptr;
    GpFrame frame = nullptr;
    GpBsdf bsdf = nullptr;
    GpImmediate immediate = nullptr;  // holds one triangle

    GpDevice get(GpDevice) const { return device; }
    GpTexture get(GpTexture) const { return texture; }
    GpMaterial get(GpMaterial) const { return material; }
    GpMesh get(GpMesh) const { return mesh; }
    GpScene get(GpScene) const { return scene; }
    GpInstance get(GpInstance) const { return instance; }
    GpLight get(GpLight) const { return light; }
    GpFrame get(GpFrame) const { return frame; }
    GpBsdf get(GpBsdf) const { return bsdf; }
    GpImmediate get(GpImmediate) const { return immediate; }
};

GpDevice newNullDevice();
GpMeshDesc triangleDesc(GpMeshKind kind);        // points to static data
GpTextureDesc textureDesc();                     // 2 x 2, static data
GpRenderOptions fewSamples(uint32_t samples = 1);
extern const float trianglePositions[9];
extern const float identity[12];

struct World : Handles {
    Handles released;  // of the same device
    Handles orphaned;  // of a device that was released
    Handles foreign;   // of another living device
    GpMesh staticMesh = nullptr, dynamicMesh = nullptr;
    GpInstance staticInstance = nullptr;
    GpImmediate openImmediate = nullptr, emptyImmediate = nullptr;  // after gpBegin; nothing in it
    GpFrame emptyFrame = nullptr;  // nothing rendered yet; `frame` has 2 samples
    std::string folder;            // for files

    World();
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    // Everything about the world that calls could change, as text.
    std::string snapshot() const;
};

// A number in an enum of C, where C++ would not put it.
template <class E>
E anyEnum(int number) {
    E value;
    static_assert(sizeof value == sizeof number);
    std::memcpy(&value, &number, sizeof number);
    return value;
}

// What a call gave back: its code; nothing where it was a null handle or pointer.
using Outcome = std::optional<GpError>;
template <class T>
Outcome made(T* result) {
    return result ? Outcome(GP_SUCCESS) : std::nullopt;
}

// One misuse of one call, the code that it must give, and a part of the message.
struct Row {
    std::string call;
    std::string what;
    GpError expected;
    std::string message;
    std::function<Outcome(World&)> run;
    bool direct = false;  // the calls that note no error: only what they return counts
};
using Rows = std::vector<Row>;

// The five wrong values that a handle can have. `run` makes the call with the given handle.
template <class Handle>
void addHandleRows(Rows& rows, const char* call, const char* argument,
                   std::function<Outcome(World&, Handle)> run) {
    const auto add = [&](const char* what, const char* message,
                         std::function<Handle(World&)> handle) {
        rows.push_back({call, std::string(argument) + " " + what, GP_ERROR_INVALID_HANDLE,
                        std::string(argument) + " " + message,
                        [run, handle](World& w) { return run(w, handle(w)); }});
    };
    constexpr bool isDevice = std::is_same_v<Handle, GpDevice>;
    add("NULL", "is NULL", [](World&) { return Handle(nullptr); });
    add("released", "was released", [](World& w) { return w.released.get(Handle()); });
    add("of a released device", "was released", [](World& w) { return w.orphaned.get(Handle()); });
    add("of another type", "is a handle of another type", [](World& w) {
        void* other = isDevice ? static_cast<void*>(w.mesh) : static_cast<void*>(w.device);
        return reinterpret_cast<Handle>(other);
    });
    add("a pointer to memory", "is not a handle",
        [](World& w) { return reinterpret_cast<Handle>(static_cast<void*>(&w)); });
}

// The rows of each noun, in the files misuse_*.cpp.
Rows deviceRows();
Rows textureRows();
Rows materialRows();
Rows meshRows();
Rows instanceRows();
Rows sceneRows();
Rows lightRows();
Rows environmentRows();
Rows cameraRows();
Rows frameRows();
Rows renderRows();
Rows imageRows();
Rows bsdfRows();
Rows drawRows();
Rows immediateRows();
Rows changeRows();
Rows oceanRows();

}  // namespace gp::test
