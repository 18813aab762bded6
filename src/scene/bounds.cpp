#include <unordered_map>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "scene/scene.h"

namespace gp {

namespace {

// Above this many vertices in all instances together, boxes stand for meshes.
constexpr size_t mostVertices = size_t(1) << 25;

void add(Bounds& b, glm::vec3 p) {
    b.lo = glm::min(b.lo, p);
    b.hi = glm::max(b.hi, p);
}

Bounds merged(Bounds a, const Bounds& b) {
    a.lo = glm::min(a.lo, b.lo);
    a.hi = glm::max(a.hi, b.hi);
    return a;
}

bool hasNoBounds(const Instance& instance) {
    return instance.visibility == visibleToSky || instance.ofSea;
}

Bounds exactBounds(const Instance& instance, Bounds b) {
    if (hasNoBounds(instance)) return b;
    const Mesh& mesh = *instance.mesh;
    for (size_t v = 0; v < mesh.vertexCount(); ++v)
        add(b, instance.worldFromObject * glm::vec4(mesh.positions[v], 1));
    return b;
}

Bounds boxBounds(const Scene& scene) {
    std::unordered_map<const Mesh*, Bounds> boxes;
    Bounds all;
    for (const auto& instance : scene.instances) {
        if (hasNoBounds(*instance)) continue;
        const auto [it, isNew] = boxes.try_emplace(instance->mesh.get());
        if (isNew)
            for (size_t v = 0; v < instance->mesh->vertexCount(); ++v)
                add(it->second, instance->mesh->positions[v]);
        if (it->second.empty()) continue;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 pick(corner & 1, corner >> 1 & 1, corner >> 2);
            add(all, instance->worldFromObject *
                         glm::vec4(glm::mix(it->second.lo, it->second.hi, pick), 1));
        }
    }
    return all;
}

}  // namespace

Bounds worldBounds(const Scene& scene) {
    size_t vertices = 0;
    for (const auto& instance : scene.instances) vertices += instance->mesh->vertexCount();
    if (vertices > mostVertices) return boxBounds(scene);
    return tbb::parallel_reduce(
        tbb::blocked_range<size_t>(0, scene.instances.size()), Bounds{},
        [&](const tbb::blocked_range<size_t>& range, Bounds b) {
            for (size_t i = range.begin(); i != range.end(); ++i)
                b = exactBounds(*scene.instances[i], b);
            return b;
        },
        merged);
}

}  // namespace gp
