#include "frame/heat_maps.h"

#include <algorithm>

namespace gp {
namespace {

constexpr HeatLayerInfo infos[heatLayerCount] = {
    {"heat_rays", "rays traced for the pixel in this frame"},
    {"heat_time", "microseconds of tracing and shading"},
    {"heat_variance", "of luminance, before denoising; G, B, A: direct, indirect, specular"}};

}  // namespace

const HeatLayerInfo& heatLayerInfo(HeatLayer layer) { return infos[size_t(layer)]; }

void HeatMaps::begin(bool wanted, glm::ivec2 size) {
    const size_t count = wanted ? size_t(size.x) * size_t(size.y) : 0;
    for (std::vector<float>* map : {&rays_, &microseconds_}) {
        if (count == 0) *map = {};  // its memory too
        map->assign(count, 0.0f);
    }
}

bool hasHeatLayer(const HeatMaps& heat, const RealtimeImages& images, HeatLayer layer) {
    return layer == HeatLayer::variance ? images.filtered : heat.isMade();
}

}  // namespace gp
