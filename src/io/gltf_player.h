// A glTF file that plays on after it has been loaded: keys, hierarchy and shapes in memory, and
// links to what they move in the scene. The objects stay the same; only where they are, and the
// vertices of deformed meshes, change.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "io/gltf_animation.h"
#include "io/gltf_mesh.h"
#include "scene/scene.h"

namespace gp::io {

// Which moment of a file is meant.
struct GltfMoment {
    double time = 0;     // seconds
    bool loop = false;   // animations start again when they are over
    int animation = -1;  // as GltfOptions::animation
};

// Checks the number of an animation, -1 and allAnimations included; throws FileError.
void requireAnimation(const std::string& path, int animation, size_t count);

class GltfPlayer {
public:
    struct Parts {
        std::string path;                // for messages
        std::vector<Node> restNodes;     // identified, not posed
        std::vector<Animation> animations;
        std::vector<Deformable> deformables;
        struct Placed {                  // a copy of a mesh at a node that moves
            uint32_t node = 0;
            glm::mat4 nodeFromCopy{1};
            std::shared_ptr<Instance> instance;
        };
        std::vector<Placed> instances;
        std::vector<std::pair<uint32_t, std::shared_ptr<Light>>> lights;  // and their nodes
        std::vector<std::pair<uint32_t, size_t>> cameras;  // nodes; index into Scene::cameras
    };
    explicit GltfPlayer(Parts&& parts);

    size_t animationCount() const { return m_parts.animations.size(); }

    // Works out where everything is then; nothing changes yet. Throws FileError, std::bad_alloc.
    void prepare(const GltfMoment& moment);
    // Puts it there. Returns whether anything that rays meet has changed, which cameras are not.
    bool apply(Scene& scene) noexcept;

private:
    void poseAt(const GltfMoment& moment);
    void prepareMeshes();
    void prepareInstances();

    Parts m_parts;
    std::vector<uint32_t> m_order;      // nodes, parents first
    // How far the vertices of the meshes of moving instances are from the origin, metres.
    std::unordered_map<const Mesh*, glm::vec3> m_reach;

    // What prepare() found.
    std::vector<Node> m_nodes;
    struct NewShape {
        size_t deformable = 0;
        Deformation deformation;
        Mesh vertices;
        glm::vec3 reach{0};
    };
    std::vector<NewShape> m_shapes;
    std::vector<glm::mat4x3> m_transforms;  // by instance
};

}  // namespace gp::io
