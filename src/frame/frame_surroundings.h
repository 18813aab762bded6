// The light of all sides for GP_MODE_LOCAL: what surrounds a frame's scene, filtered for the solid
// angles of facets, and as irradiance (GpLocalLighting::environmentFacets).
#pragma once

#include <memory>

#include "frame/frame_sky.h"
#include "scene/sky_pyramid.h"

namespace gp {

class FrameSurroundings {
public:
    // Sets plan.surroundings: null where the plan asks for none, or where all around is black.
    // Made anew only where what surrounds the scene has changed. Throws std::bad_alloc; what was
    // known before is then forgotten.
    void update(Backend& backend, const BackendScene& backendScene, const Scene& scene,
                FramePlan& plan);
    void forget() { *this = {}; }

private:
    SkySource source_;
    std::shared_ptr<const SkyPyramid> pyramid_;
};

}  // namespace gp
