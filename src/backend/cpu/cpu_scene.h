// A scene in the CPU backend's form: Embree's structures, and the flat tables of SceneView.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include <tbb/task_arena.h>

#include "backend/backend.h"
#include "backend/cpu/material_table.h"
#include "backend/cpu/scene_view.h"
#include "scene/environment_table.h"
#include "scene/light_table.h"

namespace gp::cpu {

// Owners of Embree's handles.
struct DeviceDeleter { void operator()(RTCDevice d) const { rtcReleaseDevice(d); } };
struct SceneDeleter { void operator()(RTCScene s) const { rtcReleaseScene(s); } };
using DevicePtr = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
using ScenePtr = std::unique_ptr<RTCSceneTy, SceneDeleter>;

// Light that is chosen from a table and a colour, or from a colour alone.
void showEnvironment(SceneView& view, const EnvironmentTable* table, glm::vec3 color);

class CpuScene final : public BackendScene {
public:
    // `embreeBytes` counts the memory of the device's structures. All must outlive the scene.
    CpuScene(RTCDevice device, const IsaKernels& kernels, const std::atomic<int64_t>& embreeBytes,
             tbb::task_arena& arena)
        : device_(device), kernels_(kernels), embreeBytes_(embreeBytes), arena_(arena) {}

    void update(const Scene& scene) override;
    uint64_t accelerationBytes() const override { return uint64_t(embreeBytes_.load()); }
    uint64_t emissiveTriangles() const override { return lights_.emissiveTriangles; }
    const LightTable& lights() const override { return lights_; }
    bool hasSlopes() const override { return materials_.hasSlopes(); }
    const SceneView& view() const { return view_; }

private:
    // The bottom-level structure of one mesh.
    struct MeshStructure {
        std::shared_ptr<const Mesh> mesh;  // keeps the vertices alive: Embree reads them in place
        ScenePtr scene;
        RTCGeometry geometry = nullptr;    // owned by `scene`
        uint64_t revision = 0;
        uint32_t index = 0;                // into geometries_
        bool filtered = false;             // some instance lets rays pass by alpha
        bool used = false, stale = false;
    };

    void rebuild(const Scene& scene);
    void updateMeshes(const Scene& scene);
    void buildMesh(MeshStructure& s);
    ScenePtr newTop() const;
    void fillInstances(const Scene& scene);
    void attachLights(const Scene& scene);
    void fillView(const Scene& scene);

    RTCDevice device_;
    const IsaKernels& kernels_;
    const std::atomic<int64_t>& embreeBytes_;
    tbb::task_arena& arena_;  // builds use its threads
    uint64_t revision_ = 0, seaPlacement_ = 0;
    bool built_ = false;

    std::unordered_map<const Mesh*, MeshStructure> meshes_;
    ScenePtr top_, sky_;  // sky geometry apart, so that no other ray comes near it
    std::vector<shared::InstanceRecord> instances_;
    std::vector<GeometryView> geometries_;
    MaterialTable materials_;
    LightTable lights_;
    std::vector<uint32_t> lightOfPrimitive_[4];  // spheres, rectangles; seen by the camera, or not
    std::shared_ptr<const EnvironmentTable> environment_;
    std::shared_ptr<const Sea> sea_;
    SceneView view_{};
};

}  // namespace gp::cpu
