#include "frame/scene_motion.h"

namespace gp {

const glm::vec3* SceneMotion::positionsOf(const Snapshot& past, const Mesh& mesh) const {
    if (past.mesh.get() == &mesh) {
        if (past.revision == mesh.revision) return mesh.positions.data();
        if (mesh.wanders) {
            const bool known = !mesh.before.empty() && past.revision == mesh.beforeRevision;
            return known ? mesh.before.data() : nullptr;
        }
        // Other vertices since then: the copy, if the triangles still mean the same corners.
        const auto found = vertices_.find(&mesh);
        const bool same = past.topology == mesh.topologyRevision && found != vertices_.end() &&
                          found->second.positions.size() == mesh.positions.size();
        return same ? found->second.positions.data() : nullptr;
    }
    // Another mesh under the same id, as applications do that hand over everything each frame.
    const bool untouched = past.revision == past.mesh->revision;
    const bool same = untouched && past.mesh->positions.size() == mesh.positions.size() &&
                      past.mesh->triangles == mesh.triangles;
    return same ? past.mesh->positions.data() : nullptr;
}

void SceneMotion::compare(const Scene& scene, const LightTable& lights) {
    instances_.assign(scene.instances.size(), {});
    positions_.assign(scene.instances.size(), nullptr);
    currentOfPrevious_.assign(past_.size(), NO_INDEX);
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = *scene.instances[i];
        instances_[i].index = NO_INDEX;
        uint32_t index = NO_INDEX;
        if (instance.id != 0) {
            const auto found = byId_.find(instance.id);
            if (found != byId_.end()) index = found->second;
        } else {
            const auto found = byObject_.find(&instance);
            if (found != byObject_.end()) index = found->second;
        }
        if (index == NO_INDEX) continue;
        const Snapshot& past = past_[index];
        const glm::vec3* positions = positionsOf(past, *instance.mesh);
        if (!positions) continue;
        const glm::mat4x3& m = past.worldFromObject;
        for (int row = 0; row < 3; ++row)
            instances_[i].world_from_object[row] = {m[0][row], m[1][row], m[2][row], m[3][row]};
        instances_[i].index = index;
        positions_[i] = positions;
        currentOfPrevious_[index] = i;
    }
    compareSea(scene);
    compareLights(scene, lights);
}

void SceneMotion::compareSea(const Scene& scene) {
    sea_ = {};
    sea_.instance = NO_INDEX;
    if (!scene.sea) return;
    const Sea& sea = *scene.sea;
    for (uint32_t i = 0; i < scene.instances.size(); ++i)
        if (scene.instances[i] == sea.instance() && instances_[i].index != NO_INDEX)
            sea_.instance = i;
    sea_.sectors = sea.grid().sectors, sea_.rings = sea.grid().rings;
    sea_.centre = sea.placed().centre, sea_.height = sea.placed().height;
    sea_.previous_centre = pastSea_.centre, sea_.previous_height = pastSea_.height;
}

// Most frames have the lights of the last one in the same order, whatever else changed of them.
bool SceneMotion::sameLights(const Scene& scene, const LightTable& lights) const {
    if (pastLights_.size() != lights.lights.size()) return false;
    for (size_t i = 0; i < pastLights_.size(); ++i) {
        const PastLight& past = pastLights_[i];
        if (past.primitive != lights.lights[i].primitive) return false;
        if (i < lights.sources.size()) {
            if (past.light != scene.lights[lights.sources[i]]) return false;
        } else if (past.light || past.instance != lights.lights[i].instance ||
                   currentOfPrevious_[past.instance] != past.instance) {
            return false;
        }
    }
    return true;
}

void SceneMotion::compareLights(const Scene& scene, const LightTable& lights) {
    currentLight_.assign(pastLights_.size(), NO_INDEX);
    sameLights_ = sameLights(scene, lights);
    if (sameLights_) {
        for (uint32_t i = 0; i < currentLight_.size(); ++i) currentLight_[i] = i;
        return;
    }
    std::unordered_map<uint64_t, uint32_t> byId;
    std::unordered_map<const Light*, uint32_t> byObject;
    for (uint32_t i = 0; i < lights.sources.size(); ++i) {
        const Light& light = *scene.lights[lights.sources[i]];
        if (light.id != 0) byId.try_emplace(light.id, i);  // of a polygon its first triangle
        else byObject.try_emplace(&light, i);
    }
    const auto partOf = [&](uint32_t first, uint32_t part) {
        const size_t i = size_t(first) + part;
        const bool there = i < lights.sources.size() && lights.sources[i] == lights.sources[first];
        return there ? uint32_t(i) : NO_INDEX;
    };
    for (size_t i = 0; i < pastLights_.size(); ++i) {
        const PastLight& past = pastLights_[i];
        if (past.light && past.id != 0) {
            if (const auto found = byId.find(past.id); found != byId.end())
                currentLight_[i] = partOf(found->second, past.primitive);
        } else if (past.light) {
            if (const auto found = byObject.find(past.light.get()); found != byObject.end())
                currentLight_[i] = partOf(found->second, past.primitive);
        } else if (const uint32_t instance = currentOfPrevious_[past.instance];
                   instance != NO_INDEX && lights.lightMap[instance] != NO_INDEX) {
            currentLight_[i] = lights.lightOfTriangle[lights.lightMap[instance] + past.primitive];
        }
    }
}

void SceneMotion::rememberLights(const Scene& scene, const LightTable& lights) {
    if (sameLights_) return;
    pastLights_.assign(lights.lights.size(), {});
    for (size_t i = 0; i < pastLights_.size(); ++i) {
        PastLight& past = pastLights_[i];
        if (i < lights.sources.size()) {
            past.light = scene.lights[lights.sources[i]];
            past.id = past.light->id;
        } else {
            past.instance = lights.lights[i].instance;
        }
        past.primitive = lights.lights[i].primitive;
    }
}

void SceneMotion::remember(const Scene& scene, const LightTable& lights) {
    rememberLights(scene, lights);
    if (scene.sea) pastSea_ = scene.sea->placed();
    past_.clear(), byId_.clear(), byObject_.clear();
    past_.reserve(scene.instances.size());
    for (auto& [mesh, vertices] : vertices_) vertices.used = false;
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const auto& instance = scene.instances[i];
        const Mesh& mesh = *instance->mesh;
        past_.push_back({instance, instance->mesh, instance->worldFromObject, mesh.revision,
                         mesh.topologyRevision});
        if (instance->id != 0) byId_[instance->id] = i;
        else byObject_[instance.get()] = i;
        if (mesh.kind != MeshKind::dynamic || mesh.wanders) continue;
        Vertices& kept = vertices_[&mesh];
        kept.used = true;
        if (kept.revision == mesh.revision && !kept.positions.empty()) continue;
        kept.positions = mesh.positions;
        kept.revision = mesh.revision;
    }
    std::erase_if(vertices_, [](const auto& entry) { return !entry.second.used; });
}

void SceneMotion::forget() {
    past_.clear(), byId_.clear(), byObject_.clear(), vertices_.clear(), pastLights_.clear();
    sameLights_ = false;
}

}  // namespace gp
