// What each pixel of a real-time frame costs, for people to look at: made only where it is asked
// for (GpRealtimeOptions::heatMaps).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "frame/realtime_images.h"

namespace gp {

enum class HeatLayer : uint32_t { rays, time, variance, count };
constexpr size_t heatLayerCount = size_t(HeatLayer::count);

struct HeatLayerInfo {
    const char* name;
    const char* meaning;
};
const HeatLayerInfo& heatLayerInfo(HeatLayer layer);

// Where passes add what a pixel costs, row after row of the size of rays; null: nobody asked.
struct HeatViews {
    float* rays = nullptr;
    float* microseconds = nullptr;
};

class HeatMaps {
public:
    // A frame begins: all zeros, or no memory where nobody asks. Throws std::bad_alloc.
    void begin(bool wanted, glm::ivec2 size);
    bool isMade() const { return !rays_.empty(); }
    HeatViews views() { return {rays_.data(), microseconds_.data()}; }
    const std::vector<float>& rays() const { return rays_; }
    const std::vector<float>& microseconds() const { return microseconds_; }
    uint64_t bytes() const { return (rays_.size() + microseconds_.size()) * sizeof(float); }

private:
    std::vector<float> rays_, microseconds_;
};

// Whether a frame has the layer: `heat` are its maps, `images` what its denoiser left.
bool hasHeatLayer(const HeatMaps& heat, const RealtimeImages& images, HeatLayer layer);

// RGBA for each pixel of the picture. The frame has the layer.
void readHeatLayer(const HeatMaps& heat, const RealtimeImages& images, HeatLayer layer,
                   glm::vec4* pixels);

}  // namespace gp
