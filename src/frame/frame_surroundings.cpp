#include "frame/frame_surroundings.h"

#include <algorithm>
#include <bit>

namespace gp {
namespace {

// Faces as sharp as the image, up to 25 MB; those of sky geometry, whose sharpness nobody knows,
// at least as sharp as 0.35 degrees. 16 are enough where all directions are the same.
constexpr uint32_t leastSize = 16, leastOfGeometry = 256, mostSize = 512;

uint32_t sizeOf(const SkySource& source) {
    const uint32_t width = source.image ? source.image->width : 0;
    return std::clamp(std::bit_ceil(width / 4), source.geometry ? leastOfGeometry : leastSize,
                      mostSize);
}

}  // namespace

void FrameSurroundings::update(Backend& backend, const BackendScene& backendScene,
                               const Scene& scene, FramePlan& plan) {
    plan.surroundings = nullptr;
    if (plan.mode != FrameMode::local || plan.local.environmentNodes == 0) return forget();
    SkySource source = skySourceOf(scene, plan);
    if (!source.geometry && source.color == glm::vec3(0)) return forget();
    source.size = sizeOf(source);
    if (!(source == source_)) {
        forget();
        CubeMap cube;
        cube.size = source.size;
        cube.texels.assign(size_t(6) * cube.size * cube.size, glm::vec3(0));
        backend.traceSky(backendScene, plan, skySamples(source), cube);
        pyramid_ = std::make_shared<const SkyPyramid>(makeSkyPyramid(cube));
        source_ = source;
    }
    plan.surroundings = pyramid_;
}

}  // namespace gp
