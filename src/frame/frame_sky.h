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

// What a cube of all directions was made of.
struct SkySource {
    uint32_t size = 0;
    bool geometry = false;
    uint64_t revision = 0;    // of the scene, where it has sky geometry
    glm::vec3 viewer{0};      // the same
    std::shared_ptr<const EnvironmentTable> image;
    glm::vec3 color{0};
    float rotation = 0;
    bool operator==(const SkySource&) const = default;
};

// Of environment and sky geometry; `size`, of the cube's faces, is left to the caller.
SkySource skySourceOf(const Scene& scene, const FramePlan& plan);
// How many rays along each side of a texel of a cube of that size, so that no texel of the image
// behind is left out.
uint32_t skySamples(const SkySource& source);

class FrameSky {
public:
    // Sets plan.sky and plan.skyDrawn: to null and false where the environment says all. Draws
    // count in real time only. `backendScene` shows `scene`. Throws std::bad_alloc; what was known
    // before is then forgotten.
    void update(Backend& backend, const BackendScene& backendScene, const Scene& scene,
                FramePlan& plan);
    void forget() { *this = {}; }

private:
    bool updateBackground(Backend& backend, const BackendScene& backendScene,
                          const FramePlan& plan, const SkySource& source);
    void drawFaces(Backend& backend, const std::vector<const DrawCommand*>& draws);
    void updateTable(const CubeMap& cube, float rotation);

    SkySource source_;
    CubeMap background_, drawn_;
    LatLongImage image_;
    std::shared_ptr<EnvironmentTable> table_;
};

}  // namespace gp
