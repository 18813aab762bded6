// The node hierarchy of a glTF file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "io/gltf_accessor.h"

namespace gp::io {

struct Node {
    std::string name;
    std::optional<uint32_t> parent, mesh, skin, camera, light;
    std::vector<uint32_t> children;

    glm::vec3 translation{0}, scale{1};
    glm::quat rotation{1, 0, 0, 0};
    std::optional<glm::mat4> matrix;  // instead of the three
    std::vector<float> weights;       // of morph targets; empty: the mesh's

    bool moves = false;   // an animation moves it or one of its ancestors
    bool morphs = false;  // an animation changes its weights
    glm::mat4 worldFromNode{1};
    uint64_t pathHash = 0;  // of the names and indices from the root to here
};

// Reads all nodes and checks that they form trees.
std::vector<Node> readNodes(Document& document);

// All nodes, parents first.
std::vector<uint32_t> parentsFirst(const std::vector<Node>& nodes);

// Once listAnimations has marked them: `moves` and `pathHash` of every one, `seed` being the hash
// of the file.
void identifyNodes(std::vector<Node>& nodes, uint64_t seed);

// After animations have moved the nodes: worldFromNode of every one. `order` is parentsFirst().
// Throws FileError of the file at `path` where a transform is not finite.
void placeNodes(const std::string& path, const std::vector<uint32_t>& order,
                std::vector<Node>& nodes);

// The nodes of a scene and everything below them, parents first. scene < 0: the file's default;
// a file without scenes shows all of its roots.
std::vector<uint32_t> nodesOfScene(const Document& document, const std::vector<Node>& nodes,
                                   int scene);

}  // namespace gp::io
