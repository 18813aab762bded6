// A tree over lights, by which one is chosen in proportion to what it may give to a point.
// Based on: Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting", HPG; here with eight children a node. The walk through it is
// src/kernels/light_choice.glsl.
#pragma once

#include <vector>

#include "scene/large_pages.h"
#include "scene/light_cluster.h"
#include "shared/scene_structs.h"

namespace gp {

// Makes the tree anew in `nodes`, the root first; empty for no lights. `lights[i].child` is
// LIGHT_TREE_LEAF and the light's index in `records`, where its LightRecord::leaf is written. The
// order of `lights` is lost. Uses the threads of the arena that it is called in.
void makeLightTree(std::vector<LightCluster>& lights, std::vector<shared::LightRecord>& records,
                   LargeVector<shared::LightTreeNode>& nodes);
// The same with every cut weighed by the surface area orientation heuristic, however many lights
// there are; above a few thousand makeLightTree takes the quicker way of light_runs.h. For tests.
void makeWeighedLightTree(std::vector<LightCluster>& lights,
                          std::vector<shared::LightRecord>& records,
                          LargeVector<shared::LightTreeNode>& nodes);

}  // namespace gp
