// The real-time frame: a few rays a pixel, and what is remembered from frame to frame.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "backend/backend.h"
#include "frame/frame_sky.h"
#include "frame/heat_maps.h"
#include "frame/realtime_images.h"
#include "frame/realtime_plan.h"
#include "frame/scene_motion.h"
#include "shared/realtime_structs.h"

namespace gp {

struct PassTime {
    const char* name;
    double milliseconds;
};

struct RealtimeResult {
    RayCounts rays;
    std::vector<PassTime> passes;
    double secondsRender = 0;
    float exposureEv = 0;  // that the picture was tone mapped with
    bool cancelled = false;
};

// What a frame of the application's remembers.
class RealtimeFrame {
public:
    // Does nothing where sizes and images are as they were. Another size of rays alone keeps
    // history, on other pixels; all else forgets it. Returns whether pixels are others.
    bool resize(glm::ivec2 full, glm::ivec2 output, ReuseImages reuse);
    // The next frame knows nothing of the ones before.
    void cut() { previousCamera_.reset(), eye_.reset(), sky_.forget(); }
    const RealtimeImages& images() const { return images_; }
    const HeatMaps& heat() const { return heat_; }
    uint64_t bytes() const { return images_.bytes() + heat_.bytes(); }

    // One frame, into images() and `picture`. When cancelled or failing, history is forgotten.
    RealtimeResult render(Backend& backend, const BackendScene& backendScene, const Scene& scene,
                          const RealtimePlan& plan, FrameImages& picture,
                          std::atomic<bool>& cancel);

private:
    shared::RealtimeConstants constants(const RealtimePlan& plan, bool hasPrevious,
                                        bool sceneChanged) const;

    RealtimeImages images_;
    HeatMaps heat_;
    SceneMotion motion_;
    std::optional<Camera> previousCamera_;
    std::array<float, 3> lightVisibility_{1, 1, 1};
    glm::vec2 jitter_{0};
    uint32_t index_ = 0;
    Denoiser denoiser_ = Denoiser::none;      // of the last frame
    LightReuse lightReuse_ = LightReuse::none, indirectReuse_ = LightReuse::none;
    uint64_t sceneRevision_ = 0;
    Eye eye_;
    FrameSky sky_;
};

}  // namespace gp
