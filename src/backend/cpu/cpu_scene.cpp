#include "backend/cpu/cpu_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <tbb/parallel_for_each.h>

#include "scene/sea.h"
#include "shading/shading.h"

namespace gp::cpu {

using namespace gp::shared;

static_assert(sizeof(ShadingVertex) == 16, "isa/kernels.h reads it as PackedVertex");

void CpuScene::update(const Scene& scene) {
    if (built_ && revision_ == scene.revision && seaPlacement_ == scene.seaPlacement) return;
    arena_.execute([&] { rebuild(scene); });
    if (rtcGetDeviceError(device_) == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    revision_ = scene.revision, seaPlacement_ = scene.seaPlacement;
    built_ = true;
}

void CpuScene::rebuild(const Scene& scene) {
    updateMeshes(scene);
    materials_.fill(scene);
    fillLightTable(scene, lights_);
    fillInstances(scene);
    fillView(scene);
}

// ------------------------------------------------------------------------------- geometry

void CpuScene::updateMeshes(const Scene& scene) {
    for (auto& [key, s] : meshes_) s.used = false;
    geometries_.clear();
    for (const auto& instance : scene.instances) {
        MeshStructure& s = meshes_[instance->mesh.get()];
        if (!s.used) {
            s.used = true;
            s.index = uint32_t(geometries_.size());
            s.mesh = instance->mesh;
            const Mesh& m = *s.mesh;
            geometries_.push_back({m.triangles.data(), m.positions.data(), m.vertices.data(),
                                   m.uv1.empty() ? nullptr : m.uv1.data(),
                                   m.colors.empty() ? nullptr : m.colors.data(),
                                   m.lattice.columns, m.lattice.rows});
            s.stale |= !s.scene || s.revision != m.revision;
        }
        if (instance->given()->mayPass() && !s.filtered)
            s.filtered = s.stale = true;
    }
    std::erase_if(meshes_, [](const auto& entry) { return !entry.second.used; });
    std::vector<MeshStructure*> work;
    for (auto& [key, s] : meshes_)
        if (s.stale) work.push_back(&s);
    tbb::parallel_for_each(work, [&](MeshStructure* s) { buildMesh(*s); });
}

static void setTriangles(RTCGeometry geometry, const Mesh& m) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               m.triangles.data(), 0, sizeof(glm::uvec3), m.triangles.size());
}

// Blocks of 2 x 2 cells, row by row: what lattice_hit.h reads hits of.
static void setBlocks(RTCGeometry geometry, const Lattice& lattice) {
    const uint32_t across = lattice.columns / 2, along = lattice.rows / 2;
    auto* block = static_cast<RTCGrid*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid),
        size_t(across) * along));
    if (!block) throw std::bad_alloc();
    for (uint32_t row = 0; row < along; ++row)
        for (uint32_t column = 0; column < across; ++column)
            *block++ = {2 * (row * lattice.columns + column), lattice.columns,
                        uint16_t(std::min(3u, lattice.columns - 2 * column)),
                        uint16_t(std::min(3u, lattice.rows - 2 * row))};
}

void CpuScene::buildMesh(MeshStructure& s) {
    const Mesh& m = *s.mesh;
    const bool dynamic = m.kind == MeshKind::dynamic, isLattice = m.lattice.columns != 0;
    if (!s.scene) {
        s.scene.reset(rtcNewScene(device_));
        s.geometry = rtcNewGeometry(
            device_, isLattice ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
        if (!s.scene || !s.geometry) throw std::bad_alloc();
        if (isLattice) setBlocks(s.geometry, m.lattice);
        rtcSetSceneFlags(s.scene.get(), dynamic ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE);
        rtcAttachGeometryByID(s.scene.get(), s.geometry, 0);
        rtcReleaseGeometry(s.geometry);  // the scene keeps it
    }
    // Dynamic meshes are built anew: a refit took three to four times as long (ARCHITECTURE.md).
    const RTCBuildQuality quality = isLattice ? RTC_BUILD_QUALITY_MEDIUM
                                    : dynamic ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_HIGH;
    rtcSetSceneBuildQuality(s.scene.get(), quality);
    rtcSetGeometryBuildQuality(s.geometry, quality);
    rtcSetSharedGeometryBuffer(s.geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               m.positions.data(), 0, sizeof(glm::vec3), m.vertexCount());
    if (!isLattice) setTriangles(s.geometry, m);
    if (s.filtered) {
        rtcSetGeometryIntersectFilterFunction(s.geometry, kernels_.alphaFilter);
        rtcSetGeometryOccludedFilterFunction(s.geometry, kernels_.alphaFilter);
    }
    rtcCommitGeometry(s.geometry);
    rtcCommitScene(s.scene.get());
    s.revision = m.revision;
    s.stale = false;
}

ScenePtr CpuScene::newTop() const {
    ScenePtr top(rtcNewScene(device_));
    if (!top) throw std::bad_alloc();
    rtcSetSceneFlags(top.get(), RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(top.get(), RTC_BUILD_QUALITY_MEDIUM);
    return top;
}

void CpuScene::fillInstances(const Scene& scene) {
    top_ = newTop();
    sky_.reset();
    instances_.assign(scene.instances.size(), {});
    for (uint32_t i = 0; i < instances_.size(); ++i) {
        const Instance& source = *scene.instances[i];
        const glm::mat4x3& m = source.worldFromObject;
        const MeshStructure& s = meshes_.at(source.mesh.get());
        InstanceRecord& r = instances_[i];
        // Columns of the cofactor matrix: cross products of the columns of the linear part.
        const glm::vec3 cx = glm::cross(m[1], m[2]), cy = glm::cross(m[2], m[0]),
                        cz = glm::cross(m[0], m[1]);
        const float sign = glm::dot(m[0], cx) < 0 ? -1.0f : 1.0f;
        for (int row = 0; row < 3; ++row) {
            r.world_from_object[row] = {m[0][row], m[1][row], m[2][row], m[3][row]};
            r.normal_from_object[row] = sign * glm::vec4(cx[row], cy[row], cz[row], 0);
        }
        r.mirrored = sign < 0;
        r.material = materials_.indexOf(source);
        r.geometry = s.index;
        r.light_map = lights_.lightMap[i];
        if (source.mesh->triangles.empty()) continue;
        RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(g, s.scene.get());
        rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &m[0][0]);
        rtcSetGeometryMask(g, source.visibility);
        rtcCommitGeometry(g);
        const bool ofSky = source.visibility == visibleToSky;
        if (ofSky && !sky_) sky_ = newTop();
        rtcAttachGeometryByID(ofSky ? sky_.get() : top_.get(), g, i);
        rtcReleaseGeometry(g);
    }
    attachLights(scene);
    // Many lamps whose scene has changed before may do so in every frame: then building takes
    // longer than their better structure saves.
    constexpr size_t many = 4096;
    size_t shapes = 0;
    for (const auto& table : lightOfPrimitive_) shapes += table.size();
    if (built_ && shapes > many) rtcSetSceneBuildQuality(top_.get(), RTC_BUILD_QUALITY_LOW);
    rtcCommitScene(top_.get());
    if (sky_) rtcCommitScene(sky_.get());
}

// ------------------------------------------------------------------------------- lights

// Sphere, rectangle and polygon lights are shapes that rays meet: four geometries after the
// instances, those that the camera sees and those that it does not.
void CpuScene::attachLights(const Scene& scene) {
    std::vector<glm::vec4> spheres[2];
    std::vector<glm::vec3> corners[2];
    for (auto& table : lightOfPrimitive_) table.clear();
    uint32_t index = lights_.directionalCount;
    for (const auto& light : scene.lights) {
        if (light->kind == LightKind::directional || !(shading::luminance(light->emission) > 0))
            continue;
        const int hidden = light->visible ? 0 : 1;
        if (light->kind == LightKind::rectangle) {
            const glm::vec3 p = light->position, u = light->edgeU, v = light->edgeV;
            for (glm::vec3 corner : {p, p + u, p + u + v, p, p + u + v, p + v})
                corners[hidden].push_back(corner);
            lightOfPrimitive_[2 + hidden].insert(lightOfPrimitive_[2 + hidden].end(), 2, index);
        } else if (light->kind == LightKind::polygon) {
            const std::vector<glm::vec3>& p = light->corners;
            for (size_t i = 1; i + 1 < p.size(); ++i) {
                for (glm::vec3 corner : {p[0], p[i], p[i + 1]}) corners[hidden].push_back(corner);
                lightOfPrimitive_[2 + hidden].push_back(index++);
            }
            continue;
        } else if (light->radius > 0) {
            spheres[hidden].emplace_back(light->position, light->radius);
            lightOfPrimitive_[hidden].push_back(index);
        }
        ++index;
    }
    const uint32_t first = uint32_t(instances_.size());
    const auto attach = [&](RTCGeometry g, uint32_t id, int hidden) {
        rtcSetGeometryMask(g, (hidden ? 0u : visibleToCamera) | visibleToBounce | visibleToShadow);
        rtcCommitGeometry(g);
        rtcAttachGeometryByID(top_.get(), g, first + id);
        rtcReleaseGeometry(g);
    };
    const auto fill = [](RTCGeometry g, RTCBufferType type, RTCFormat format, size_t stride,
                         size_t count, const void* source) {
        void* buffer = rtcSetNewGeometryBuffer(g, type, 0, format, stride, count);
        if (!buffer) throw std::bad_alloc();
        std::memcpy(buffer, source, stride * count);
    };
    for (int hidden = 0; hidden < 2; ++hidden) {
        if (!spheres[hidden].empty()) {
            RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
            fill(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, sizeof(glm::vec4),
                 spheres[hidden].size(), spheres[hidden].data());
            attach(g, uint32_t(hidden), hidden);
        }
        if (!corners[hidden].empty()) {
            RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
            std::vector<uint32_t> order(corners[hidden].size());
            for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
            fill(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), order.size(),
                 corners[hidden].data());
            fill(g, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, sizeof(glm::uvec3), order.size() / 3,
                 order.data());
            attach(g, uint32_t(2 + hidden), hidden);
        }
    }
}

// ------------------------------------------------------------------------------- the view

void showEnvironment(SceneView& view, const EnvironmentTable* t, glm::vec3 color) {
    view.environmentColor = t && t->black() ? glm::vec3(0) : color;
    const float mean = t ? float(t->meanLuminance) : 1.0f;
    view.environmentMean = view.environmentColor * (t ? glm::vec3(t->mean) : glm::vec3(1));
    view.environmentPower = 3.14159265f * mean * shading::luminance(view.environmentColor);
    view.environment = {};
    if (t && !t->black())
        view.environment = {t->texels.data(), t->cells.data(), t->densities.data(), t->width,
                            t->height, t->side, t->texelScale, t->densityScale,
                            t->rowMeans.data()};
}

static SeaSlopes seaSlopes(const Sea& sea, glm::vec2 rest, glm::vec2 d0, glm::vec2 d1) {
    const OceanSlopes s = sea.slopes(rest, d0, d1);
    return {s.mean, s.varX, s.varY, s.cov, s.foam};
}

void CpuScene::fillView(const Scene& scene) {
    view_ = {};
    view_.scene = top_.get();
    view_.sky = sky_.get();
    view_.instances = instances_.data();
    view_.geometries = geometries_.data();
    materials_.show(view_);
    view_.lights = lights_.lights.data();
    view_.lightTree = lights_.tree.data();
    view_.lightOfTriangle = lights_.lightOfTriangle.data();
    for (size_t i = 0; i < std::size(lightOfPrimitive_); ++i)
        view_.lightOfPrimitive[i] = lightOfPrimitive_[i].data();
    view_.instanceCount = uint32_t(instances_.size());
    view_.lightCount = uint32_t(lights_.lights.size());
    view_.lightTreeNodes = uint32_t(lights_.tree.size());
    view_.directionalLights = lights_.directionalCount;
    const Environment& e = scene.environment;
    view_.environmentCos = std::cos(e.rotation), view_.environmentSin = std::sin(e.rotation);
    showEnvironment(view_, e.table.get(), e.color);
    sea_ = scene.sea;
    view_.sea = sea_.get(), view_.seaSlopes = seaSlopes;
    view_.background = view_.environment, view_.backgroundColor = view_.environmentColor;
    environment_ = e.table;
}

}  // namespace gp::cpu
