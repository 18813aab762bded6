// Where the nodes of a light tree are put together, by several threads at a time.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <span>

#include "scene/large_pages.h"
#include "scene/light_cluster.h"
#include "shared/scene_structs.h"

namespace gp {

class LightTreeWriter {
public:
    LightTreeWriter(LargeVector<shared::LightTreeNode>& nodes,
                    std::vector<shared::LightRecord>& records)
        : nodes_(nodes), records_(records) {}

    uint32_t newNode() { return next_.fetch_add(1, std::memory_order_relaxed); }
    uint32_t count() const { return next_.load(); }

    // Fills a node, tells its children where they are, and returns what bounds them all.
    LightCluster fill(uint32_t index, std::span<const LightCluster> children) {
        shared::LightTreeNode& n = nodes_[index];
        n = {};
        LightCluster all;
        for (uint32_t i = 0; i < children.size(); ++i) {
            const LightCluster& c = children[i];
            const glm::vec3 centre = c.centre(), half = 0.5f * (c.hi - c.lo);
            n.centre_x[i] = centre.x, n.centre_y[i] = centre.y, n.centre_z[i] = centre.z;
            n.radius2[i] = glm::dot(half, half), n.phi[i] = c.phi;
            const glm::vec3 axis = c.normals.axis;
            n.axis_x[i] = axis.x, n.axis_y[i] = axis.y, n.axis_z[i] = axis.z;
            n.cos_theta_o[i] = c.normals.cosTheta, n.cos_theta_e[i] = c.cosThetaE;
            n.child[i] = c.child | (c.twoSided ? LIGHT_TREE_TWO_SIDED : 0);
            const uint32_t place = index * LIGHT_TREE_WIDTH + i;
            if ((c.child & LIGHT_TREE_LEAF) != 0) records_[c.child & LIGHT_TREE_INDEX].leaf = place;
            else nodes_[c.child].parent = place;
            all.add(c);
        }
        all.child = index;
        return all;
    }

private:
    LargeVector<shared::LightTreeNode>& nodes_;
    std::vector<shared::LightRecord>& records_;
    std::atomic<uint32_t> next_{0};
};

}  // namespace gp
