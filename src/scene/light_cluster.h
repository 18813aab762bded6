// What bounds several lights: their positions, power, and where they shine.
// Based on: Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting", HPG.
#pragma once

#include <cstdint>
#include <limits>

#include <glm/glm.hpp>

namespace gp {

// A cone of directions around an axis, by its half angle; its cosine stands beside it.
struct LightCone {
    glm::vec3 axis{0, 0, 1};
    float theta = -1;  // radians; negative: empty
    float cosTheta = 1;
};

// One light, or all lights below a node of the tree. With everything as at first it bounds none.
struct LightCluster {
    glm::vec3 lo{std::numeric_limits<float>::max()}, hi{-std::numeric_limits<float>::max()};
    LightCone normals;
    float thetaE = 0, cosThetaE = 1;  // how far around its normal each of them shines
    float phi = 0;                    // power, as luminance in W
    bool twoSided = false;
    uint32_t count = 0;               // lights
    uint32_t child = 0;               // as LightTreeNode::child, without LIGHT_TREE_TWO_SIDED

    glm::vec3 centre() const { return 0.5f * (lo + hi); }
    void add(const LightCluster& c);
    // The surface area orientation heuristic's measure of a cluster.
    float cost(float regularisation) const;
};

}  // namespace gp
