#include "io/gltf_mesh.h"

#include <algorithm>

#include "scene/hash.h"

namespace gp::io {

bool Meshes::anyNodeMoves(uint32_t mesh, const std::vector<Node>& nodes) {
    if (m_moves.empty()) {
        m_moves.resize(m_document.size("meshes"));
        for (const Node& n : nodes)
            if (n.mesh && n.moves) m_moves[*n.mesh] = true;
    }
    return m_moves[mesh];
}

const std::shared_ptr<const Skin>& Meshes::skin(uint32_t index) {
    std::shared_ptr<const Skin>& s = m_skins[index];
    if (!s) s = std::make_shared<Skin>(readSkin(m_document, m_accessors, index));
    return s;
}

Meshes::Deformer Meshes::deformerOf(uint32_t index, const std::vector<Node>& nodes) {
    const Node& node = nodes[index];
    Deformer d;
    d.node = index;
    const auto w = m_document.element("meshes", *node.mesh).find("weights");
    if (w && w->size() > 0) {
        d.meshWeights.resize(w->size());
        w->reals(d.meshWeights.data(), d.meshWeights.size());
    }
    if (node.skin) d.skin = skin(*node.skin);
    d.deformation = deformationOf(node, d.meshWeights, d.skin.get(), nodes);
    const auto jointMoves = [&](uint32_t joint) { return nodes[joint].moves; };
    d.changes = node.morphs ||
                (d.skin && std::any_of(d.skin->joints.begin(), d.skin->joints.end(), jointMoves));
    return d;
}

// deformer null: the primitive is shown as it is.
std::shared_ptr<Mesh> Meshes::build(uint32_t meshIndex, uint32_t primitive,
                                    const Deformer* deformer, MeshKind kind, uint64_t owner) {
    const Value mesh = m_document.element("meshes", meshIndex);
    const Value value = mesh["primitives"].at(primitive);
    const bool keep = m_keepDeformables && deformer && deformer->changes;
    ShapeRequest request;
    if (deformer) request.weights = deformer->deformation.weights;
    if (deformer && deformer->skin) request.joints = deformer->skin->joints.size();
    request.allTargets = keep;
    std::optional<Shape> shape = readShape(m_document, m_accessors, value, request);
    if (!shape) return nullptr;
    const auto material = value.index("material", "materials");
    const MeshOptions options = m_materials.meshOptions(material);
    if (deformer) completeTangents(*shape, options);
    m_document.budget().spend(shape->rest.positions.size() * sizeof(glm::vec3) * 4 +
                                  shape->rest.indices.size() * sizeof(uint32_t),
                              value);
    auto out = std::make_shared<Mesh>();
    const uint32_t key[2] = {meshIndex, primitive};
    out->id = hashBytes(key, sizeof key, owner);
    out->name = mesh.text("name", "mesh " + std::to_string(meshIndex));
    out->kind = kind;
    out->material = m_materials.get(material);
    if (!keep) {
        if (deformer) deform(*shape, deformer->deformation, shape->rest);
        fillMesh(*out, std::move(shape->rest), options);
        return out;
    }
    m_document.budget().spend(shape->bytes(), value);
    MeshData data = shape->rest;
    deform(*shape, deformer->deformation, data);
    fillMesh(*out, std::move(data), options);
    m_deformables.push_back({deformer->node, std::move(*shape), deformer->meshWeights,
                             deformer->skin, options, out, deformer->deformation});
    return out;
}

std::vector<Meshes::Shown> Meshes::show(uint32_t index, const std::vector<Node>& nodes) {
    const Node& node = nodes[index];
    const uint32_t mesh = *node.mesh;
    const uint32_t count =
        static_cast<uint32_t>(m_document.element("meshes", mesh)["primitives"].size());
    const Deformer deformer = deformerOf(index, nodes);
    const bool own = deformer.changes || node.skin || !deformer.deformation.weights.empty();
    const bool moves = own ? node.moves && !node.skin : anyNodeMoves(mesh, nodes);
    const MeshKind kind = deformer.changes ? MeshKind::dynamic
                          : moves          ? MeshKind::movable
                                           : MeshKind::staticMesh;
    std::vector<Shown> shown;
    for (uint32_t p = 0; p < count; ++p) {
        if (own) {
            shown.push_back({p, build(mesh, p, &deformer, kind, node.pathHash)});
            continue;
        }
        const auto [it, isNew] = m_shared.try_emplace({mesh, p});
        if (isNew) it->second = build(mesh, p, nullptr, kind, m_seed);
        shown.push_back({p, it->second});
    }
    std::erase_if(shown, [](const Shown& s) { return !s.mesh; });
    return shown;
}

}  // namespace gp::io
