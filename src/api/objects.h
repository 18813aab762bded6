// What the handles of the C interface stand for.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "api/handle.h"
#include "backend/backend.h"
#include "frame/frame_images.h"
#include "frame/realtime.h"
#include "glitterpath/glitterpath.h"
#include "io/gltf.h"
#include "scene/bsdf_evaluate.h"
#include "scene/bsdf_registry.h"
#include "scene/scene.h"

namespace gp::api {

struct SceneObject;

// A file that plays on (gpSetSceneTime).
struct PlayingFile {
    std::shared_ptr<io::GltfPlayer> player;
    size_t firstAnimation = 0;  // where its animations begin in Scene::animations
    int animation = -1;         // what plays, as GltfOptions::animation
};

struct DeviceObject final : Object {
    std::unique_ptr<Backend> backend;
    std::string name;
    uint32_t threads = 0;                 // 0: all processors
    HandleBits self = 0;
    GpErrorCallback errorCallback = nullptr;
    void* errorUser = nullptr;
    std::atomic<bool>* cancel = nullptr;  // its slot of the cancel table (api/cancel.h)
    std::shared_ptr<const Material> defaultMaterial;
    std::vector<std::weak_ptr<SceneObject>> scenes;  // so that changed meshes reach them

    std::mutex mutex;                       // held by every call on the device
    std::atomic<std::thread::id> holder{};  // who holds it: a callback that calls back is an error

    DeviceObject() = default;
    ~DeviceObject() override;
    DeviceObject& owner() override { return *this; }
};

struct ChildObject : Object {
    std::shared_ptr<DeviceObject> device;  // outlives every member of the derived objects
    explicit ChildObject(DeviceObject& d);
    DeviceObject& owner() override { return *device; }
};

struct TextureObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<const Texture> texture;
};

struct MaterialObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<const Material> material;
};

struct MeshObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<Mesh> mesh;
};

struct SceneObject final : ChildObject {
    using ChildObject::ChildObject;
    Scene scene;
    std::unique_ptr<BackendScene> backendScene;   // made by the first gpRender
    std::unordered_set<uint64_t> instanceIds, lightIds;
    std::unordered_map<const Mesh*, uint32_t> dynamicUses;  // instances a dynamic mesh has here
    std::set<std::string> cameraNames;            // keeps the pointers given out where they are
    std::vector<PlayingFile> playing;
};

struct InstanceObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<SceneObject> scene;
    std::shared_ptr<Instance> instance;
};

struct LightObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<SceneObject> scene;
    std::shared_ptr<Light> light;
};

struct FrameObject final : ChildObject {
    using ChildObject::ChildObject;
    FrameImages images;
    FrameMode mode = FrameMode::reference;
    std::unique_ptr<RealtimeFrame> realtime;  // FrameMode::realtime
    std::vector<PassTime> passes;             // of its last frame
    bool rendered = false;           // there is something to read
    GpFrameStatistics statistics{};
    // What the samples show, so that accumulating something else is noticed.
    std::weak_ptr<const SceneObject> scene;
    uint64_t sceneRevision = 0;
    Camera camera;
};

struct BsdfObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<const BsdfSettings> settings;
    std::unique_ptr<const PreparedBsdf> prepared;  // made by the first value or sample
};

template <class Handle> struct HandleTraits;
#define GP_HANDLE(Handle, Target, name)                              \
    template <> struct HandleTraits<Handle> {                        \
        using Object = Target;                                       \
        static constexpr HandleType type = HandleType::name;         \
    };
GP_HANDLE(GpDevice, DeviceObject, device)
GP_HANDLE(GpTexture, TextureObject, texture)
GP_HANDLE(GpMaterial, MaterialObject, material)
GP_HANDLE(GpMesh, MeshObject, mesh)
GP_HANDLE(GpScene, SceneObject, scene)
GP_HANDLE(GpInstance, InstanceObject, instance)
GP_HANDLE(GpLight, LightObject, light)
GP_HANDLE(GpFrame, FrameObject, frame)
GP_HANDLE(GpBsdf, BsdfObject, bsdf)
#undef GP_HANDLE

}  // namespace gp::api
