#include "frame/scene_motion.h"

namespace gp {

const glm::vec3* SceneMotion::positionsOf(const Snapshot& past, const Mesh& mesh) const {
    if (past.mesh.get() == &mesh) {
        if (past.revision == mesh.revision) return mesh.positions.data();
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

void SceneMotion::compare(const Scene& scene) {
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
}

void SceneMotion::remember(const Scene& scene) {
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
        if (mesh.kind != MeshKind::dynamic) continue;
        Vertices& kept = vertices_[&mesh];
        kept.used = true;
        if (kept.revision == mesh.revision && !kept.positions.empty()) continue;
        kept.positions = mesh.positions;
        kept.revision = mesh.revision;
    }
    std::erase_if(vertices_, [](const auto& entry) { return !entry.second.used; });
}

void SceneMotion::forget() {
    past_.clear(), byId_.clear(), byObject_.clear(), vertices_.clear();
}

}  // namespace gp
