// What surrounds the scene of a frame where that is more than its environment: sky geometry, which
// all rays see from one point, and rasterised geometry that was drawn into the sky. Both end in one
// table, from which light is chosen as from an environment image.
#pragma once

#include <memory>
#include <vector>

#include "backend/backend.h"
#include "scene/cube_map.h"
#include "scene/environment_table.h"

namespace gp {

class FrameSky {
public:
    // Sets plan.sky and plan.skyDrawn: to null and false where the environment says all. Draws
    // count in real time only. `backendScene` shows `scene`. Throws std::bad_alloc; what was known
    // before is then forgotten.
    void update(Backend& backend, const BackendScene& backendScene, const Scene& scene,
                FramePlan& plan);
    void forget() { *this = {}; }

private:
    // What the background was made of.
    struct Source {
        uint32_t size = 0;
        bool geometry = false;
        uint64_t revision = 0;    // of the scene, where it has sky geometry
        glm::vec3 viewer{0};      // the same
        std::shared_ptr<const EnvironmentTable> image;
        glm::vec3 color{0};
        float rotation = 0;
        bool operator==(const Source&) const = default;
    };

    bool updateBackground(Backend& backend, const BackendScene& backendScene,
                          const Scene& scene, const FramePlan& plan, const Source& source);
    void drawFaces(Backend& backend, const std::vector<const DrawCommand*>& draws);
    void updateTable(const CubeMap& cube, float rotation);

    Source source_;
    CubeMap background_, drawn_;
    LatLongImage image_;
    std::shared_ptr<EnvironmentTable> table_;
};

}  // namespace gp
