// The backend that renders nothing. Programs and tests use it to have every call checked on
// machines without anything: frames stay black, but samples are counted, so that everything after
// a render (reading back, statistics, saving) runs as it would with another backend.
#include <algorithm>

#include "backend/backend.h"

namespace gp {

namespace {

class NullScene final : public BackendScene {
public:
    void update(const Scene&) override {}
    uint64_t accelerationBytes() const override { return 0; }
    uint64_t emissiveTriangles() const override { return 0; }
    const LightTable& lights() const override { return none_; }
    bool hasSlopes() const override { return false; }

private:
    LightTable none_;
};

class NullBackend final : public Backend {
public:
    std::string name() const override { return "null (renders nothing)"; }
    std::unique_ptr<BackendScene> newScene() override { return std::make_unique<NullScene>(); }

    std::array<float, 3> estimateLightVisibility(const BackendScene&, const FramePlan&) override {
        return {1, 1, 1};
    }
    void traceSky(const BackendScene&, const FramePlan&, uint32_t, CubeMap& cube) override {
        std::fill(cube.texels.begin(), cube.texels.end(), glm::vec3(0));
    }
    RayCounts tracePaths(const BackendScene&, const FramePlan&, uint32_t, uint32_t count,
                         FrameImages& images, const std::atomic<bool>& cancel) override {
        for (PixelSums& sums : images.sums) {
            if (cancel.load(std::memory_order_relaxed)) break;
            sums.samples += count;
        }
        return {};
    }

    RayCounts runRealtimePass(const RealtimeJob&, RealtimePass) override { return {}; }
    void runDenoisePass(const RealtimeJob&, const DenoisePass&) override {}
    LuminanceHistogram luminanceHistogram(const RealtimeViews&) override { return {}; }
    void tonemapRealtime(const RealtimeViews&, float, Tonemap,
                         std::vector<glm::u8vec4>& display) override {
        std::fill(display.begin(), display.end(), glm::u8vec4(0, 0, 0, 255));
    }

    void tonemap(float, Tonemap, FrameImages& images) override {
        std::fill(images.display.begin(), images.display.end(), glm::u8vec4(0, 0, 0, 255));
    }
    void rasterize(const DrawImages&, const std::vector<PlacedDraw>&) override {}
};

}  // namespace

std::unique_ptr<Backend> newNullBackend() { return std::make_unique<NullBackend>(); }

}  // namespace gp
