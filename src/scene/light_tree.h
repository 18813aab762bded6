// A tree over lights, by which one is chosen in proportion to what it may give to a point.
// Based on: Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting", HPG; the walk through it is src/kernels/light_choice.glsl.
#pragma once

#include <vector>

#include "shared/scene_structs.h"

namespace gp {

// What the tree knows of one light.
struct LightBounds {
    glm::vec3 lo{0}, hi{0};
    glm::vec3 axis{0, 0, 1};  // mean direction of emission
    float cosThetaO = 1;      // spread of the normals around the axis
    float cosThetaE = 0;      // spread of emission around each normal
    float thetaO = 0, thetaE = 0;  // the same in radians, by makeLightTree
    float phi = 0;            // power, as luminance in W; > 0
    bool twoSided = false;
    uint32_t light = 0;       // index into the light table
};

// Nodes in depth-first order, the first child right after its parent; empty for no lights.
// Writes each light's LightRecord::trail.
std::vector<shared::LightTreeNode> makeLightTree(std::vector<LightBounds> bounds,
                                                 std::vector<shared::LightRecord>& lights);

}  // namespace gp
