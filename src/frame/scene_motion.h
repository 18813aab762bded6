// What of a scene was where in the last frame: instances and lights matched by their ids, those
// without one by being the same object, in whatever order they come.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "scene/light_table.h"
#include "scene/scene.h"
#include "scene/sea.h"
#include "shared/realtime_structs.h"
#include "shared/scene_structs.h"

namespace gp {

class SceneMotion {
public:
    // Fills the tables below: `scene` against what remember() was given.
    void compare(const Scene& scene, const LightTable& lights);
    // Keeps what the next frame will ask about; copies the vertices of dynamic meshes.
    void remember(const Scene& scene, const LightTable& lights);
    void forget();

    const std::vector<shared::PreviousInstance>& instances() const { return instances_; }
    // For each instance the positions that its triangles' indices pointed to; null: not known.
    const std::vector<const glm::vec3*>& positions() const { return positions_; }
    // From an index of the last frame to one of this frame, or NO_INDEX.
    const std::vector<uint32_t>& currentOfPrevious() const { return currentOfPrevious_; }

    // The same for the numbers of lights; emissive triangles go with their instances.
    const std::vector<uint32_t>& currentLightOfPrevious() const { return currentLight_; }

    // The sea's triangles; its instance is NO_INDEX where nothing is known of before.
    const shared::SeaMotion& sea() const { return sea_; }

private:
    void compareSea(const Scene& scene);

    struct PastLight {
        std::shared_ptr<const Light> light;        // null: a triangle
        uint64_t id = 0;
        uint32_t instance = 0, primitive = 0;      // of a polygon: which of its triangles
    };
    bool sameLights(const Scene& scene, const LightTable& lights) const;
    void compareLights(const Scene& scene, const LightTable& lights);
    void rememberLights(const Scene& scene, const LightTable& lights);

    struct Snapshot {
        std::shared_ptr<const Instance> instance;  // kept, so that its address stays its own
        std::shared_ptr<const Mesh> mesh;
        glm::mat4x3 worldFromObject{1};
        uint64_t revision = 0, topology = 0;       // of the mesh
    };
    struct Vertices {
        uint64_t revision = 0;
        std::vector<glm::vec3> positions;
        bool used = false;
    };

    const glm::vec3* positionsOf(const Snapshot& past, const Mesh& mesh) const;

    std::vector<Snapshot> past_;
    std::unordered_map<uint64_t, uint32_t> byId_;
    std::unordered_map<const Instance*, uint32_t> byObject_;
    std::unordered_map<const Mesh*, Vertices> vertices_;  // of dynamic meshes

    std::vector<PastLight> pastLights_;
    bool sameLights_ = false;  // as pastLights_ has them; by compare()

    std::vector<shared::PreviousInstance> instances_;
    std::vector<const glm::vec3*> positions_;
    std::vector<uint32_t> currentOfPrevious_, currentLight_;
    SeaPlace pastSea_;
    shared::SeaMotion sea_{};
};

}  // namespace gp
