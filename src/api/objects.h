// What the handles of the C interface stand for.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "api/handle.h"
#include "backend/backend.h"
#include "frame/draw.h"
#include "frame/frame_images.h"
#include "frame/frame_sky.h"
#include "frame/frame_surroundings.h"
#include "frame/realtime.h"
#include "glitterpath/glitterpath.h"
#include "io/gltf.h"
#include "scene/bsdf_evaluate.h"
#include "scene/bsdf_registry.h"
#include "scene/scene.h"

namespace gp::api {

struct SceneObject;

// gpSetTextureOverrides.
struct TextureOverrides {
    std::string folder;
    std::string albedo, rme, normal;  // postfixes
};

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
    std::optional<TextureOverrides> overrides;       // for textures yet to be made
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
    std::shared_ptr<Texture> texture;
    // Files of gpSetTextureOverrides: the one in its place, and the maps for materials beside it.
    std::string replacedBy;
    std::shared_ptr<const Texture> metallicRoughness, emission, normal;
};

struct MaterialObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<const Material> material;
    std::shared_ptr<Material> animated;  // the same, where its frame may be switched; else null
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
    // Where in scene.lights those of gpNewLight were last seen: hints, not promises.
    std::unordered_map<const Light*, size_t> lightPlaces;
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
    glm::vec3 skyViewer{0};
    bool backgroundHidden = false;
    float shownEv = 0;               // of images.display, as the next
    Tonemap shownTonemap = Tonemap::agx;
    FrameSky sky;                    // of other modes than FrameMode::realtime
    FrameSurroundings surroundings;  // of FrameMode::local
    DrawList draws;                  // wait for the next render
    uint64_t drawElements = 0;       // their vertices and indices
    DrawList overlay;                // that the last render drew: gpTonemapFrame draws it again
};

struct BsdfObject final : ChildObject {
    using ChildObject::ChildObject;
    std::shared_ptr<const BsdfSettings> settings;
    std::unique_ptr<const PreparedBsdf> prepared;  // made by the first value or sample
};

struct ImmediateVertex {
    glm::vec3 position{0}, normal{0, 0, 1};
    glm::vec2 texCoord{0};
    glm::vec4 color{1};
};

struct ImmediateObject final : ChildObject {
    using ChildObject::ChildObject;
    ImmediateVertex current;         // what the next vertex has
    bool hasColors = false, hasNormals = false, hasTexCoords = false;  // ever set
    GpShadeModel shadeModel = GP_SHADE_SMOOTH;
    GpPrimitive primitive = GP_TRIANGLES;
    bool open = false;               // between gpBegin and gpEnd
    uint32_t firstVertex = 0;        // of the open primitive
    std::vector<ImmediateVertex> vertices;
    std::vector<uint32_t> indices;
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
GP_HANDLE(GpImmediate, ImmediateObject, immediate)
#undef GP_HANDLE

}  // namespace gp::api
