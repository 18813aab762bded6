#include "scene/light_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <tbb/parallel_invoke.h>

namespace gp {
namespace {

using shared::LightTreeNode;

constexpr int binCount = 12;
constexpr uint32_t maxDepth = 31;  // LightRecord::trail has 32 bits

// A cone of directions around an axis.
struct Cone {
    glm::vec3 axis{0, 0, 1};
    float theta = -1;  // radians; negative: empty
};

// The smallest cone, with its axis in the plane of both, that holds a and b.
// [Conty Estevez and Kulla 2018, algorithm 1]
Cone unite(Cone a, Cone b) {
    if (a.theta < 0) return b;
    if (b.theta < 0) return a;
    if (b.theta > a.theta) std::swap(a, b);
    if (a.theta >= 3.14159265f) return a;  // all around, as spheres shine
    const float between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0f, 1.0f));
    constexpr float pi = 3.14159265f;
    if (std::min(between + b.theta, pi) <= a.theta) return a;
    const float theta = 0.5f * (a.theta + between + b.theta);
    if (theta >= pi) return {a.axis, pi};
    const float turn = theta - a.theta;
    const glm::vec3 pivot = glm::cross(a.axis, b.axis);
    const float length = glm::length(pivot);
    if (!(length > 1e-6f)) return {a.axis, pi};  // opposite axes: no plane to turn in
    const glm::vec3 k = pivot / length;
    // Rodrigues' rotation; k is perpendicular to the axis.
    return {glm::normalize(a.axis * std::cos(turn) + glm::cross(k, a.axis) * std::sin(turn)),
            theta};
}

// Bounds of several lights.
struct Cluster {
    glm::vec3 lo{std::numeric_limits<float>::max()}, hi{-std::numeric_limits<float>::max()};
    Cone cone;
    float thetaE = 0;
    float phi = 0;
    bool twoSided = false;
    int count = 0;

    void add(const LightBounds& b) {
        lo = glm::min(lo, b.lo), hi = glm::max(hi, b.hi);
        cone = unite(cone, {b.axis, b.thetaO});
        thetaE = std::max(thetaE, b.thetaE);
        phi += b.phi, twoSided |= b.twoSided, ++count;
    }
    void add(const Cluster& c) {
        if (c.count == 0) return;
        lo = glm::min(lo, c.lo), hi = glm::max(hi, c.hi);
        cone = unite(cone, c.cone);
        thetaE = std::max(thetaE, c.thetaE);
        phi += c.phi, twoSided |= c.twoSided, count += c.count;
    }

    // The surface area orientation heuristic's measure of a cluster.
    // [Conty Estevez and Kulla 2018, equation 1]
    float cost(float regularisation) const {
        const float o = cone.theta;
        const float w = std::min(o + thetaE, 3.14159265f);
        const float orientation = 6.2831853f * (1 - std::cos(o)) +
                                  1.5707963f * (2 * w * std::sin(o) - std::cos(o - 2 * w) -
                                                2 * o * std::sin(o) + std::cos(o));
        const glm::vec3 d = hi - lo;
        const float area = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
        return phi * orientation * regularisation * area;
    }
};

class Builder {
public:
    Builder(std::vector<LightBounds>& bounds, std::vector<shared::LightRecord>& lights)
        : bounds_(bounds), lights_(lights) {}

    std::vector<LightTreeNode> run() {
        if (bounds_.empty()) return {};
        for (LightBounds& b : bounds_) {
            b.thetaO = std::acos(std::clamp(b.cosThetaO, -1.0f, 1.0f));
            b.thetaE = std::acos(std::clamp(b.cosThetaE, -1.0f, 1.0f));
        }
        nodes_.resize(2 * bounds_.size() - 1);
        build(0, bounds_.size(), 0, 0, 0);
        return std::move(nodes_);
    }

private:
    // A tree over n lights has 2 n - 1 nodes: both halves know where theirs begin, and can be made
    // at the same time. Which comes first changes nothing.
    void build(size_t begin, size_t end, size_t index, uint32_t depth, uint32_t trail) {
        LightTreeNode& node = nodes_[index];
        node = nodeOf(begin, end);
        if (end - begin == 1) {
            node.is_leaf = 1;
            node.child_or_light = bounds_[begin].light;
            lights_[bounds_[begin].light].trail = trail;
            return;
        }
        const size_t middle = split(begin, end, depth);
        const size_t second = index + 2 * (middle - begin);
        node.child_or_light = uint32_t(second);
        const auto buildFirst = [&] { build(begin, middle, index + 1, depth + 1, trail); };
        const auto buildSecond = [&] {
            build(middle, end, second, depth + 1, trail | (1u << depth));
        };
        constexpr size_t enough = 512;  // lights, for a task to be worth its cost
        if (end - begin > enough) tbb::parallel_invoke(buildFirst, buildSecond);
        else buildFirst(), buildSecond();
    }

    LightTreeNode nodeOf(size_t begin, size_t end) const {
        Cluster all;
        for (size_t i = begin; i < end; ++i) all.add(bounds_[i]);
        LightTreeNode n{};
        n.lo = all.lo, n.hi = all.hi, n.phi = all.phi, n.w = all.cone.axis;
        n.cos_theta_o = std::cos(all.cone.theta), n.cos_theta_e = std::cos(all.thetaE);
        n.two_sided = all.twoSided;
        return n;
    }

    static glm::vec3 centre(const LightBounds& b) { return 0.5f * (b.lo + b.hi); }

    // Reorders [begin, end) and returns where the second child begins.
    size_t split(size_t begin, size_t end, uint32_t depth) {
        glm::vec3 lo{std::numeric_limits<float>::max()}, hi = -lo;
        for (size_t i = begin; i < end; ++i)
            lo = glm::min(lo, centre(bounds_[i])), hi = glm::max(hi, centre(bounds_[i]));
        const glm::vec3 extent = hi - lo;
        float bestCost = std::numeric_limits<float>::max(), bestEdge = 0;
        int bestAxis = -1;
        // Once only halving keeps the depth within the trail's bits, the median splits.
        if (depth + uint32_t(std::bit_width(end - begin)) < maxDepth)
            for (int axis = 0; axis < 3; ++axis)
                trySplits(begin, end, axis, lo[axis], extent, bestCost, bestEdge, bestAxis);
        const auto first = bounds_.begin() + ptrdiff_t(begin),
                   last = bounds_.begin() + ptrdiff_t(end);
        if (bestAxis >= 0) {
            const auto middle = std::partition(first, last, [&](const LightBounds& b) {
                return binOf(b, bestAxis, lo[bestAxis], extent[bestAxis]) < int(bestEdge);
            });
            if (middle != first && middle != last) return size_t(middle - bounds_.begin());
        }
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const auto middle = first + (last - first) / 2;
        std::nth_element(first, middle, last, [&](const LightBounds& a, const LightBounds& b) {
            return centre(a)[axis] < centre(b)[axis];
        });
        return size_t(middle - bounds_.begin());
    }

    static int binOf(const LightBounds& b, int axis, float lo, float extent) {
        return std::clamp(int(float(binCount) * (centre(b)[axis] - lo) / extent), 0, binCount - 1);
    }

    void trySplits(size_t begin, size_t end, int axis, float lo, glm::vec3 extent, float& bestCost,
                   float& bestEdge, int& bestAxis) const {
        if (!(extent[axis] > 0)) return;
        std::array<Cluster, binCount> bins;
        for (size_t i = begin; i < end; ++i)
            bins[size_t(binOf(bounds_[i], axis, lo, extent[axis]))].add(bounds_[i]);
        // Long thin clusters are split across their length.
        const float longest = std::max({extent.x, extent.y, extent.z});
        const float regularisation = longest / extent[axis];
        std::array<Cluster, binCount> above;
        for (int i = binCount - 2; i >= 0; --i) {
            above[size_t(i)] = above[size_t(i) + 1];
            above[size_t(i)].add(bins[size_t(i) + 1]);
        }
        Cluster below;
        for (int edge = 1; edge < binCount; ++edge) {
            below.add(bins[size_t(edge) - 1]);
            const Cluster& rest = above[size_t(edge) - 1];
            if (below.count == 0 || rest.count == 0) continue;
            const float cost = below.cost(regularisation) + rest.cost(regularisation);
            if (cost < bestCost) bestCost = cost, bestEdge = float(edge), bestAxis = axis;
        }
    }

    std::vector<LightBounds>& bounds_;
    std::vector<shared::LightRecord>& lights_;
    std::vector<LightTreeNode> nodes_;
};

}  // namespace

std::vector<LightTreeNode> makeLightTree(std::vector<LightBounds> bounds,
                                         std::vector<shared::LightRecord>& lights) {
    return Builder(bounds, lights).run();
}

}  // namespace gp
