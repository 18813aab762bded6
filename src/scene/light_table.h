// Every light of a scene that can be chosen for a shadow ray, emissive triangles included.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/large_pages.h"
#include "scene/light_cluster.h"
#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace gp {

struct LightTable {
    std::vector<shared::LightRecord> lights;    // directional ones first
    uint32_t directionalCount = 0;
    LargeVector<shared::LightTreeNode> tree;    // over all others
    std::vector<uint32_t> lightMap;  // instance -> offset in lightOfTriangle, or NO_INDEX
    std::vector<uint32_t> lightOfTriangle;      // NO_INDEX: that triangle is dark
    std::vector<uint32_t> sources;  // into Scene::lights, before the first emissive triangle
    uint64_t emissiveTriangles = 0;
    std::vector<LightCluster> clusters;         // what the tree was made from, out of order
};

// Makes the table anew. One that was filled before keeps its memory: applications may change
// 100,000 lights in every frame. Uses the threads of the arena that it is called in.
void fillLightTable(const Scene& scene, LightTable& table);
LightTable makeLightTable(const Scene& scene);

}  // namespace gp
