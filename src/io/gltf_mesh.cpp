#include "io/gltf_mesh.h"

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

// Weights come from the animation, the node or the mesh, in this order.
Deformation Meshes::deformationOf(const Node& node, const std::vector<Node>& nodes) {
    Deformation d;
    d.weights = node.weights;
    if (const auto w = m_document.element("meshes", *node.mesh).find("weights");
        d.weights.empty() && w && w->size() > 0) {
        d.weights.resize(w->size());
        w->reals(d.weights.data(), d.weights.size());
    }
    const bool allZero = std::all_of(d.weights.begin(), d.weights.end(),
                                     [](float w) { return w == 0; });
    if (allZero) d.weights.clear();
    if (node.skin) d.worldFromJointRest = jointMatrices(m_document, m_accessors, *node.skin, nodes);
    return d;
}

std::shared_ptr<const Mesh> Meshes::build(const Node& node, uint32_t primitive,
                                          const Deformation& deformation, MeshKind kind,
                                          uint64_t owner) {
    const Value mesh = m_document.element("meshes", *node.mesh);
    const Value value = mesh["primitives"].at(primitive);
    std::optional<MeshData> data = readPrimitive(m_document, m_accessors, value, deformation);
    if (!data) return nullptr;
    m_document.budget().spend(data->positions.size() * sizeof(MeshData::positions[0]) * 4 +
                                  data->indices.size() * sizeof(uint32_t),
                              value);
    auto out = std::make_shared<Mesh>();
    const uint32_t key[2] = {*node.mesh, primitive};
    out->id = hashBytes(key, sizeof key, owner);
    out->name = mesh.text("name", "mesh " + std::to_string(*node.mesh));
    out->kind = kind;
    const auto material = value.index("material", "materials");
    out->material = m_materials.get(material);
    fillMesh(*out, std::move(*data), m_materials.meshOptions(material));
    return out;
}

std::vector<Meshes::Shown> Meshes::show(uint32_t index, const std::vector<Node>& nodes) {
    const Node& node = nodes[index];
    const uint32_t count = static_cast<uint32_t>(
        m_document.element("meshes", *node.mesh)["primitives"].size());
    const Deformation deformation = deformationOf(node, nodes);
    const bool dynamic = node.morphs ||
                         (node.skin && skinMoves(m_document, *node.skin, nodes));
    const bool own = dynamic || node.skin || !deformation.weights.empty();
    const MeshKind kind = dynamic                                ? MeshKind::dynamic
                          : own ? (node.moves && !node.skin ? MeshKind::movable
                                                            : MeshKind::staticMesh)
                          : anyNodeMoves(*node.mesh, nodes)      ? MeshKind::movable
                                                                 : MeshKind::staticMesh;
    std::vector<Shown> shown;
    for (uint32_t p = 0; p < count; ++p) {
        if (own) {
            shown.push_back({p, build(node, p, deformation, kind, node.pathHash)});
            continue;
        }
        const auto [it, isNew] = m_shared.try_emplace({*node.mesh, p});
        if (isNew) it->second = build(node, p, {}, kind, m_seed);
        shown.push_back({p, it->second});
    }
    std::erase_if(shown, [](const Shown& s) { return !s.mesh; });
    return shown;
}

}  // namespace gp::io
