// Every light of a scene that can be chosen for a shadow ray, emissive triangles included.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace gp {

struct LightTable {
    std::vector<shared::LightRecord> lights;    // directional ones first
    uint32_t directionalCount = 0;
    std::vector<shared::LightTreeNode> tree;    // over all others
    std::vector<uint32_t> lightMap;  // instance -> offset in lightOfTriangle, or NO_INDEX
    std::vector<uint32_t> lightOfTriangle;      // NO_INDEX: that triangle is dark
    std::vector<const Light*> sources;  // of all lights before the first emissive triangle
    uint64_t emissiveTriangles = 0;
};

LightTable makeLightTable(const Scene& scene);

}  // namespace gp
