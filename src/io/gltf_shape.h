// One primitive of a glTF file as triangles, and what deforms it: enough to make its vertices for
// any moment without the file.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "io/gltf_accessor.h"
#include "io/gltf_nodes.h"
#include "scene/mesh.h"

namespace gp::io {

struct Skin {
    std::vector<uint32_t> joints;          // nodes; at least one
    std::vector<glm::mat4> jointFromRest;  // inverse bind matrices, one a joint
};

// How a node deforms its mesh at one moment.
struct Deformation {
    std::vector<float> weights;                // of morph targets; empty: all zero
    std::vector<glm::mat4> worldFromJointRest; // of a skin, for each joint; empty: no skin
    bool operator==(const Deformation&) const = default;
};

// All arrays have one element a vertex, or none.
struct Shape {
    MeshData rest;
    struct Target {
        std::vector<glm::vec3> positions, normals, tangents;
    };
    std::vector<Target> targets;
    struct Influences {  // one set of JOINTS_n and WEIGHTS_n
        std::vector<glm::u32vec4> joints;
        std::vector<glm::vec4> weights;
    };
    std::vector<Influences> influences;

    uint64_t bytes() const;
};

struct ShapeRequest {
    std::span<const float> weights;  // targets of weight 0 are not read ...
    bool allTargets = false;         // ... unless all are wanted
    size_t joints = 0;               // of the skin; 0: none
};

// Tangents where the material needs them and the file has none, at rest: the deformation then
// carries them along, and the triangles have the same vertices at every moment.
void completeTangents(Shape& shape, const MeshOptions& options);

Skin readSkin(Document& document, Accessors& accessors, uint32_t skin);

// Nothing where the primitive has no triangles.
std::optional<Shape> readShape(Document& document, Accessors& accessors, const Value& primitive,
                               const ShapeRequest& request);

// The weights come from the node (where an animation may have put them) or, if it has none, from
// the mesh; the matrices from the present places of the joints.
Deformation deformationOf(const Node& node, std::span<const float> meshWeights, const Skin* skin,
                          const std::vector<Node>& nodes);

// `data` holds the shape's vertices at rest, and then those of the deformation.
void deform(const Shape& shape, const Deformation& deformation, MeshData& data);

}  // namespace gp::io
