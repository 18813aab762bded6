// Meshes of a glTF file: each primitive becomes a gp::Mesh, shared by the nodes that show it as
// it is; where a skin or morph targets deform it, a node has its own.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "io/gltf_material.h"
#include "io/gltf_shape.h"

namespace gp::io {

// A mesh whose vertices animations change, with all that is needed to make them again.
struct Deformable {
    uint32_t node = 0;
    Shape shape;
    std::vector<float> meshWeights;    // where the node has none
    std::shared_ptr<const Skin> skin;  // may be null
    MeshOptions options;
    std::shared_ptr<Mesh> mesh;
    Deformation deformation;           // what the mesh shows now
};

class Meshes {
public:
    // keepDeformables: takeDeformables() will be asked for.
    Meshes(Document& document, Accessors& accessors, Materials& materials, uint64_t seed,
           bool keepDeformables)
        : m_document(document), m_accessors(accessors), m_materials(materials), m_seed(seed),
          m_keepDeformables(keepDeformables) {}

    // The meshes of the node's primitives; a skinned one's vertices are in world space.
    // `primitives` receives the number of each in the file.
    struct Shown {
        uint32_t primitive = 0;
        std::shared_ptr<const Mesh> mesh;
    };
    std::vector<Shown> show(uint32_t node, const std::vector<Node>& nodes);

    std::vector<Deformable> takeDeformables() { return std::move(m_deformables); }

private:
    // What a node does to the primitives of its mesh.
    struct Deformer {
        uint32_t node = 0;
        std::vector<float> meshWeights;
        std::shared_ptr<const Skin> skin;
        Deformation deformation;
        bool changes = false;  // animations change it
    };

    std::shared_ptr<Mesh> build(uint32_t mesh, uint32_t primitive, const Deformer* deformer,
                                MeshKind kind, uint64_t owner);
    Deformer deformerOf(uint32_t node, const std::vector<Node>& nodes);
    const std::shared_ptr<const Skin>& skin(uint32_t index);
    bool anyNodeMoves(uint32_t mesh, const std::vector<Node>& nodes);

    Document& m_document;
    Accessors& m_accessors;
    Materials& m_materials;
    uint64_t m_seed;
    bool m_keepDeformables;
    std::map<std::pair<uint32_t, uint32_t>, std::shared_ptr<const Mesh>> m_shared;
    std::map<uint32_t, std::shared_ptr<const Skin>> m_skins;
    std::vector<Deformable> m_deformables;
    std::vector<bool> m_moves;  // by mesh; empty: not yet known
};

}  // namespace gp::io
