// Meshes of a glTF file: each primitive becomes a gp::Mesh, shared by the nodes that show it as
// it is; where a skin or morph targets deform it, a node has its own.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "io/gltf_accessor.h"
#include "io/gltf_material.h"
#include "io/gltf_nodes.h"
#include "scene/mesh.h"

namespace gp::io {

// How a node deforms its mesh.
struct Deformation {
    std::vector<float> weights;                // of morph targets; empty: none
    std::vector<glm::mat4> worldFromJointRest; // of a skin, for each joint; empty: no skin
};

// One primitive as triangles, in arrays of equal length; nothing where it has no triangles.
std::optional<MeshData> readPrimitive(Document& document, Accessors& accessors,
                                      const Value& primitive, const Deformation& deformation);

// The joint matrices of a skin at the nodes' present places.
std::vector<glm::mat4> jointMatrices(Document& document, Accessors& accessors, uint32_t skin,
                                     const std::vector<Node>& nodes);

// Does an animation move a joint of this skin?
bool skinMoves(const Document& document, uint32_t skin, const std::vector<Node>& nodes);

// base + sum of weight * target. [glTF 2.0, 3.7.2.2]
void applyMorph(Accessors& accessors, const Value& primitive, std::span<const float> weights,
                MeshData& data);
// Linear blend skinning with every set of JOINTS_n and WEIGHTS_n. [glTF 2.0, 3.7.3.3]
void applySkin(Accessors& accessors, const Value& primitive,
               const std::vector<glm::mat4>& worldFromJointRest, MeshData& data);

class Meshes {
public:
    Meshes(Document& document, Accessors& accessors, Materials& materials, uint64_t seed)
        : m_document(document), m_accessors(accessors), m_materials(materials), m_seed(seed) {}

    // The meshes of the node's primitives; a skinned one's vertices are in world space.
    // `primitives` receives the number of each in the file.
    struct Shown {
        uint32_t primitive = 0;
        std::shared_ptr<const Mesh> mesh;
    };
    std::vector<Shown> show(uint32_t node, const std::vector<Node>& nodes);

private:
    std::shared_ptr<const Mesh> build(const Node& node, uint32_t primitive,
                                      const Deformation& deformation, MeshKind kind,
                                      uint64_t owner);
    Deformation deformationOf(const Node& node, const std::vector<Node>& nodes);
    bool anyNodeMoves(uint32_t mesh, const std::vector<Node>& nodes);

    Document& m_document;
    Accessors& m_accessors;
    Materials& m_materials;
    uint64_t m_seed;
    std::map<std::pair<uint32_t, uint32_t>, std::shared_ptr<const Mesh>> m_shared;
    std::vector<bool> m_moves;  // by mesh; empty: not yet known
};

}  // namespace gp::io
