#include "scene/light_runs.h"

#include <algorithm>
#include <bit>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace gp {
namespace {

constexpr size_t width = LIGHT_TREE_WIDTH;

// The lowest 10 bits of x, two zeros after each.
uint32_t spreadBits(uint32_t x) {
    x = (x | (x << 16)) & 0x030000FFu;
    x = (x | (x << 8)) & 0x0300F00Fu;
    x = (x | (x << 4)) & 0x030C30C3u;
    return (x | (x << 2)) & 0x09249249u;
}

struct Run {
    size_t begin = 0, end = 0;
    size_t size() const { return end - begin; }
};

class Runs {
public:
    Runs(const std::vector<LightCluster>& lights, LightTreeWriter& writer)
        : lights_(lights), writer_(writer), keys_(lights.size()) {}

    std::vector<LightCluster> run(size_t least) {
        sort();
        std::vector<Run> runs;
        cut({0, lights_.size()}, std::max(width, lights_.size() / least), runs);
        std::vector<LightCluster> clusters(runs.size());
        tbb::parallel_for(size_t(0), runs.size(),
                          [&](size_t i) { clusters[i] = subtree(runs[i]); });
        return clusters;
    }

private:
    void sort() {
        glm::vec3 lo{std::numeric_limits<float>::max()}, hi = -lo;
        for (const LightCluster& c : lights_)
            lo = glm::min(lo, c.centre()), hi = glm::max(hi, c.centre());
        const glm::vec3 scale = 1023.0f / glm::max(hi - lo, glm::vec3(1e-30f));
        tbb::parallel_for(size_t(0), keys_.size(), [&](size_t i) {
            const glm::uvec3 cell(glm::clamp((lights_[i].centre() - lo) * scale, 0.0f, 1023.0f));
            const uint32_t code =
                spreadBits(cell.x) | spreadBits(cell.y) << 1 | spreadBits(cell.z) << 2;
            keys_[i] = uint64_t(code) << 32 | i;
        });
        tbb::parallel_sort(keys_);
    }

    // Where the highest bit that differs changes; of equal codes the middle.
    size_t middle(Run run) const {
        const uint64_t first = keys_[run.begin] >> 32, last = keys_[run.end - 1] >> 32;
        if (first == last) return run.begin + run.size() / 2;
        const uint64_t bit = std::bit_floor(first ^ last);
        const uint64_t edge = (last & ~(bit - 1)) << 32;
        return size_t(std::lower_bound(keys_.begin() + ptrdiff_t(run.begin),
                                       keys_.begin() + ptrdiff_t(run.end), edge) -
                      keys_.begin());
    }

    void cut(Run run, size_t most, std::vector<Run>& runs) const {
        if (run.size() <= most) {
            runs.push_back(run);
            return;
        }
        const size_t m = middle(run);
        cut({run.begin, m}, most, runs);
        cut({m, run.end}, most, runs);
    }

    LightCluster subtree(Run run) {
        if (run.size() == 1) return lights_[keys_[run.begin] & 0xFFFFFFFFu];
        Run parts[width] = {run};
        size_t count = 1;
        while (count < width) {
            Run* largest = std::max_element(
                parts, parts + count, [](Run a, Run b) { return a.size() < b.size(); });
            if (largest->size() == 1) break;
            const size_t m = middle(*largest);
            parts[count++] = {m, largest->end};
            largest->end = m;
        }
        const uint32_t node = writer_.newNode();
        LightCluster children[width];
        for (size_t i = 0; i < count; ++i) children[i] = subtree(parts[i]);
        return writer_.fill(node, {children, count});
    }

    const std::vector<LightCluster>& lights_;
    LightTreeWriter& writer_;
    std::vector<uint64_t> keys_;  // Morton code, then the light
};

}  // namespace

std::vector<LightCluster> makeLightRuns(const std::vector<LightCluster>& lights, size_t least,
                                        LightTreeWriter& writer) {
    return Runs(lights, writer).run(least);
}

}  // namespace gp
