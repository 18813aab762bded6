// The slope maps of a scene's materials as the kernels read them (kernels/material_slopes.glsl):
// records, and images of moments that are made of textures, once for all materials and again when
// the pixels change.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "backend/cpu/scene_view.h"
#include "scene/material.h"
#include "scene/slope_map.h"

namespace gp::cpu {

class SlopeTable {
public:
    void beginFill();
    // A record of the map, but for its `slot`. Turned: a normal map's slopes follow the rotation
    // of its texture coordinates, as those of heights do by themselves.
    shared::MaterialSlopes& add(const SlopeMapUse& use, bool turned);
    // Gives up images that nobody has used since beginFill.
    void endFill();

    std::vector<shared::MaterialSlopes>& records() { return records_; }
    const std::vector<shared::MaterialSlopes>& records() const { return records_; }
    const SlopeMapView* views() const { return views_.data(); }

private:
    // Slopes of a displacement map depend on its lengths as well, which are 0 for other kinds.
    using Key = std::tuple<const Texture*, SlopeMapKind, float, float, float>;
    struct Image {
        std::shared_ptr<const Texture> texture;
        uint64_t revision = 0;
        SlopeMap map;
        uint32_t index = NO_INDEX;  // into views_; NO_INDEX: not used since beginFill
    };
    const Image& imageOf(const SlopeMapUse& use);

    std::map<Key, Image> images_;
    std::vector<SlopeMapView> views_;
    std::vector<shared::MaterialSlopes> records_;
};

}  // namespace gp::cpu
