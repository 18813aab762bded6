#include "scene/light_tree.h"

#include <algorithm>
#include <array>

#include <tbb/parallel_for.h>

#include "scene/light_runs.h"

namespace gp {
namespace {

using shared::LightTreeNode;

constexpr int binCount = 12;
constexpr size_t width = LIGHT_TREE_WIDTH;
// Clusters that cuts are weighed over. More hardly make the tree better, but slower to make.
constexpr size_t weighedClusters = 4096;
// Cuts may peel off one cluster at a time; below this many levels the median cuts.
constexpr uint32_t weighedDepth = 12;

// A range of clusters that becomes a child, with what bounds it.
struct Part {
    size_t begin = 0, end = 0;
    LightCluster bounds;
    float cost = 0;
    size_t size() const { return end - begin; }
};

// The best cut so far.
struct Cut {
    float cost = std::numeric_limits<float>::max();
    int axis = -1, edge = 0;
    LightCluster below, above;
};

class Builder {
public:
    Builder(std::vector<LightCluster>& clusters, LightTreeWriter& writer)
        : clusters_(clusters), writer_(writer) {}

    // Every node below another has its number before its children are made.
    LightCluster build(size_t begin, size_t end, uint32_t node, uint32_t depth) {
        std::array<Part, width> parts;
        const size_t count = divide(begin, end, depth, parts);
        std::array<LightCluster, width> children;
        const auto make = [&](size_t i) {
            const Part& part = parts[i];
            children[i] = part.size() == 1
                ? clusters_[part.begin]
                : build(part.begin, part.end, writer_.newNode(), depth + 1);
        };
        constexpr size_t enough = 512;  // clusters, for a task to be worth its cost
        if (end - begin > enough) tbb::parallel_for(size_t(0), count, make);
        else for (size_t i = 0; i < count; ++i) make(i);
        return writer_.fill(node, {children.data(), count});
    }

private:
    // Cuts the part that costs most until there are as many as a node has children.
    size_t divide(size_t begin, size_t end, uint32_t depth, std::array<Part, width>& parts) {
        parts[0].begin = begin, parts[0].end = end, parts[0].cost = 0;
        size_t count = 1;
        while (count < width) {
            Part* worst = nullptr;
            for (size_t i = 0; i < count; ++i)
                if (parts[i].size() > 1 && (!worst || parts[i].cost > worst->cost))
                    worst = &parts[i];
            if (!worst) break;
            split(*worst, parts[count++], depth);
        }
        return count;
    }

    // Reorders the clusters of `part`; the second half of them goes to `rest`.
    void split(Part& part, Part& rest, uint32_t depth) {
        glm::vec3 lo{std::numeric_limits<float>::max()}, hi = -lo;
        for (size_t i = part.begin; i < part.end; ++i)
            lo = glm::min(lo, clusters_[i].centre()), hi = glm::max(hi, clusters_[i].centre());
        const glm::vec3 extent = hi - lo;
        Cut best;
        if (depth < weighedDepth && part.size() > 2)
            for (int axis = 0; axis < 3; ++axis)
                if (extent[axis] > 0) tryCuts(part, axis, lo[axis], extent, best);
        const auto first = clusters_.begin() + ptrdiff_t(part.begin),
                   last = clusters_.begin() + ptrdiff_t(part.end);
        rest.end = part.end;
        if (best.axis >= 0) {
            const auto middle = std::partition(first, last, [&](const LightCluster& c) {
                return binOf(c, best.axis, lo[best.axis], extent[best.axis]) < best.edge;
            });
            rest.begin = part.end = size_t(middle - clusters_.begin());
            part.bounds = best.below, rest.bounds = best.above;
        } else {
            halve(part, rest, extent);
        }
        part.cost = part.bounds.cost(1), rest.cost = rest.bounds.cost(1);
    }

    void halve(Part& part, Part& rest, glm::vec3 extent) {
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const auto first = clusters_.begin() + ptrdiff_t(part.begin),
                   last = clusters_.begin() + ptrdiff_t(part.end);
        std::nth_element(first, first + (last - first) / 2, last,
                         [&](const LightCluster& a, const LightCluster& b) {
                             return a.centre()[axis] < b.centre()[axis];
                         });
        rest.begin = part.end = part.begin + part.size() / 2;
        part.bounds = rest.bounds = {};
        for (size_t i = part.begin; i < part.end; ++i) part.bounds.add(clusters_[i]);
        for (size_t i = rest.begin; i < rest.end; ++i) rest.bounds.add(clusters_[i]);
    }

    static int binOf(const LightCluster& c, int axis, float lo, float extent) {
        const float place = (c.centre()[axis] - lo) / extent;
        return std::clamp(int(float(binCount) * place), 0, binCount - 1);
    }

    void tryCuts(const Part& part, int axis, float lo, glm::vec3 extent, Cut& best) const {
        std::array<LightCluster, binCount> bins, above;
        for (size_t i = part.begin; i < part.end; ++i)
            bins[size_t(binOf(clusters_[i], axis, lo, extent[axis]))].add(clusters_[i]);
        // Long thin clusters are split across their length.
        const float longest = std::max({extent.x, extent.y, extent.z});
        const float regularisation = longest / extent[axis];
        for (size_t i = binCount - 1; i-- > 0;) {
            above[i] = above[i + 1];
            if (bins[i + 1].count != 0) above[i].add(bins[i + 1]);
        }
        LightCluster below;
        for (int edge = 1; edge < binCount; ++edge) {
            const LightCluster& bin = bins[size_t(edge) - 1];
            const LightCluster& rest = above[size_t(edge) - 1];
            if (bin.count == 0) continue;  // the cut before is the same
            below.add(bin);
            if (rest.count == 0) break;
            const float cost = below.cost(regularisation) + rest.cost(regularisation);
            if (cost < best.cost) best = {cost, axis, edge, below, rest};
        }
    }

    std::vector<LightCluster>& clusters_;
    LightTreeWriter& writer_;
};

void makeTree(std::vector<LightCluster>& lights, std::vector<shared::LightRecord>& records,
              LargeVector<LightTreeNode>& nodes, bool quick) {
    nodes.resize(0);
    if (lights.empty()) return;
    // Every node has two children or more, but the root of a single light.
    nodes.resize(std::max<size_t>(1, lights.size() - 1));
    LightTreeWriter writer(nodes, records);
    const uint32_t root = writer.newNode();
    if (quick) {
        std::vector<LightCluster> runs = makeLightRuns(lights, weighedClusters / 2, writer);
        Builder(runs, writer).build(0, runs.size(), root, 0);
    } else {
        Builder(lights, writer).build(0, lights.size(), root, 0);
    }
    nodes.resize(writer.count());
}

}  // namespace

void makeLightTree(std::vector<LightCluster>& lights, std::vector<shared::LightRecord>& records,
                   LargeVector<LightTreeNode>& nodes) {
    makeTree(lights, records, nodes, lights.size() > weighedClusters);
}

void makeWeighedLightTree(std::vector<LightCluster>& lights,
                          std::vector<shared::LightRecord>& records,
                          LargeVector<LightTreeNode>& nodes) {
    makeTree(lights, records, nodes, false);
}

}  // namespace gp
