// Everything that light meets, in no backend's terms.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/mesh.h"

namespace gp {

// What sees an instance, as bits.
enum VisibilityBits : uint32_t {
    visibleToCamera = 1,
    visibleToBounce = 2,
    visibleToShadow = 4,
    visibleToSky = 8  // alone: sky geometry, which only rays that leave the scene meet
};

struct Instance {
    uint64_t id = 0;
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Material> material;  // null: the mesh's own
    // A negative determinant mirrors the object: its front stays its front, so the
    // counter-clockwise rule is applied in object space, before the transform (glTF 2.0, 3.7.4).
    glm::mat4x3 worldFromObject{1};
    uint32_t visibility = visibleToCamera | visibleToBounce | visibleToShadow;
    glm::vec4 color{1};                        // multiplies base colour and alpha, linear, 0..1
    bool ofSea = false;                        // Sea's: in no bounds, and nobody's to change

    // What was given, which may be animated, and what shows of it.
    const std::shared_ptr<const Material>& given() const {
        return material ? material : mesh->material;
    }
    const Material& surface() const { return given()->shown(); }
    std::shared_ptr<const Material> surfacePtr() const {
        const Material& m = *given();
        return m.frames.empty() ? given() : m.frames[m.frame];
    }
};

class Sea;

struct Scene {
    std::vector<std::shared_ptr<Instance>> instances;
    std::vector<std::shared_ptr<Light>> lights;
    Environment environment;
    std::vector<Camera> cameras;      // what files bring; a frame names its own
    glm::vec3 worldUp{0, 1, 0};
    uint64_t revision = 0;            // grows with every change, so that backends know
    std::shared_ptr<Sea> sea;         // null: none; its instance is among the instances
    uint64_t seaPlacement = 0;        // grows where another camera moved the sea's triangles

    // What a person asks about: where it came from and what was used of it.
    std::vector<std::string> sources;
    std::vector<std::string> animations;
    std::vector<std::string> warnings;
};

struct Bounds {
    glm::vec3 lo{3.4e38f}, hi{-3.4e38f};
    bool empty() const { return lo.x > hi.x; }
};
Bounds worldBounds(const Scene& scene);

}  // namespace gp
