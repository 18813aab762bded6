#include "io/gltf_player.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "io/gltf.h"
#include "io/gltf_light.h"

namespace gp::io {

namespace {

// Squares of lengths must fit in a float, with room for what a tracer adds.
constexpr float farthest = 1e18f;

glm::vec3 reachOf(const Mesh& mesh) {
    glm::vec3 most(0);
    for (size_t v = 0; v < mesh.vertexCount(); ++v)
        most = glm::max(most, glm::abs(mesh.positions[v]));
    return most;
}

// Is the object, transformed, within the bounds of all scenes? False for NaN.
bool isWithinReach(const glm::mat4x3& m, glm::vec3 reach) {
    const glm::vec3 most = glm::abs(m[0]) * reach.x + glm::abs(m[1]) * reach.y +
                           glm::abs(m[2]) * reach.z + glm::abs(m[3]);
    return most.x <= farthest && most.y <= farthest && most.z <= farthest;
}

}  // namespace

void requireAnimation(const std::string& path, int animation, size_t count) {
    if (animation >= 0 && size_t(animation) >= count)
        throw FileError(FileError::Kind::invalid, path,
                        "there is no animation " + std::to_string(animation) +
                            "; the file has " + std::to_string(count));
}

GltfPlayer::GltfPlayer(Parts&& parts)
    : m_parts(std::move(parts)), m_order(parentsFirst(m_parts.restNodes)) {
    for (const Parts::Placed& placed : m_parts.instances) {
        const Mesh* mesh = placed.instance->mesh.get();
        const auto [it, isNew] = m_reach.try_emplace(mesh);
        if (isNew) it->second = reachOf(*mesh);
    }
}

void GltfPlayer::prepare(const GltfMoment& moment) {
    m_shapes.clear();
    m_transforms.clear();
    poseAt(moment);
    placeNodes(m_parts.path, m_order, m_nodes);
    prepareMeshes();
    prepareInstances();
}

// What the animation does not move is where the file has it, whatever was shown before.
void GltfPlayer::poseAt(const GltfMoment& moment) {
    requireAnimation(m_parts.path, moment.animation, animationCount());
    m_nodes = m_parts.restNodes;
    const size_t count = animationCount();
    size_t first = size_t(std::max(moment.animation, 0)), last = std::min(first + 1, count);
    if (moment.animation == allAnimations) last = count;
    for (size_t i = first; i < last; ++i) {
        const Animation& a = m_parts.animations[i];
        poseNodes(a, moment.loop ? loopedTime(moment.time, a.length) : moment.time, m_nodes);
    }
}

void GltfPlayer::prepareMeshes() {
    for (size_t i = 0; i < m_parts.deformables.size(); ++i) {
        const Deformable& d = m_parts.deformables[i];
        Deformation now = deformationOf(m_nodes[d.node], d.meshWeights, d.skin.get(), m_nodes);
        if (now != d.deformation) m_shapes.push_back({i, std::move(now), {}, {}});
    }
    tbb::parallel_for(size_t(0), m_shapes.size(), [&](size_t i) {
        NewShape& s = m_shapes[i];
        const Deformable& d = m_parts.deformables[s.deformable];
        MeshData data = d.shape.rest;
        deform(d.shape, s.deformation, data);
        fillMesh(s.vertices, std::move(data), d.options);
        s.reach = reachOf(s.vertices);
    });
    for (const NewShape& s : m_shapes)
        if (!isWithinReach(glm::mat4x3(1), s.reach))
            throw FileError(FileError::Kind::invalid, m_parts.path,
                            "nodes[" + std::to_string(m_parts.deformables[s.deformable].node) +
                                "]: its mesh reaches beyond 1e18 m at that time");
}

void GltfPlayer::prepareInstances() {
    std::unordered_map<const Mesh*, glm::vec3> fresh;
    for (const NewShape& s : m_shapes)
        fresh[m_parts.deformables[s.deformable].mesh.get()] = s.reach;
    for (const Parts::Placed& placed : m_parts.instances) {
        const Mesh* mesh = placed.instance->mesh.get();
        const auto found = fresh.find(mesh);
        const glm::vec3 reach = found != fresh.end() ? found->second : m_reach.at(mesh);
        const glm::mat4x3 m(m_nodes[placed.node].worldFromNode * placed.nodeFromCopy);
        if (!isWithinReach(m, reach))
            throw FileError(FileError::Kind::invalid, m_parts.path,
                            "nodes[" + std::to_string(placed.node) +
                                "]: it reaches beyond 1e18 m at that time");
        m_transforms.push_back(m);
    }
}

bool GltfPlayer::apply(Scene& scene) noexcept {
    bool changed = !m_shapes.empty();
    for (NewShape& s : m_shapes) {
        Deformable& d = m_parts.deformables[s.deformable];
        exchangeVertices(*d.mesh, s.vertices);
        if (const auto reach = m_reach.find(d.mesh.get()); reach != m_reach.end())
            reach->second = s.reach;
        d.deformation = std::move(s.deformation);
    }
    for (size_t i = 0; i < m_transforms.size(); ++i) {
        glm::mat4x3& m = m_parts.instances[i].instance->worldFromObject;
        changed |= m != m_transforms[i];
        m = m_transforms[i];
    }
    for (const auto& [node, light] : m_parts.lights) {
        const glm::vec3 position = light->position, direction = light->direction;
        placeLight(m_nodes[node], *light);
        changed |= position != light->position || direction != light->direction;
    }
    for (const auto& [node, index] : m_parts.cameras)
        placeCamera(m_nodes[node], scene.cameras[index]);
    m_shapes.clear();
    m_transforms.clear();
    return changed;
}

}  // namespace gp::io
