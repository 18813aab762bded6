#include "backend/cpu/rasterizer.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "backend/cpu/raster_setup.h"

namespace gp::cpu {
namespace {

constexpr uint32_t bandRows = 16;
constexpr size_t sliceTriangles = 256;    // set up by one task
constexpr size_t groupTriangles = 32768;  // drawn before more are set up: bounds the memory

struct Slice {
    uint32_t draw;
    size_t first, count;
    std::vector<RasterTriangle> triangles;
};

class Rasterizer {
public:
    Rasterizer(const RasterKernels& kernels, const DrawImages& images,
               const std::vector<PlacedDraw>& draws)
        : kernels_(kernels),
          images_(images),
          draws_(draws),
          bands_((images.height + bandRows - 1) / bandRows) {
        for (const PlacedDraw& d : draws)
            states_.push_back(rasterDraw(d, images.display != nullptr));
    }

    void run() {
        size_t waiting = 0;
        for (uint32_t i = 0; i < draws_.size(); ++i) {
            const size_t count = draws_[i].draw->triangleCount();
            for (size_t first = 0; first < count; first += sliceTriangles) {
                slices_.push_back({i, first, std::min(sliceTriangles, count - first), {}});
                waiting += slices_.back().count;
                if (waiting >= groupTriangles) drawGroup(), waiting = 0;
            }
        }
        drawGroup();
    }

private:
    void drawGroup() {
        const auto setUp = [&](size_t i) {
            Slice& s = slices_[i];
            s.triangles.reserve(s.count);
            setUpTriangles(draws_[s.draw], s.draw, s.first, s.count, s.triangles);
        };
        if (slices_.size() > 1)
            tbb::parallel_for(size_t(0), slices_.size(), setUp);
        else if (!slices_.empty())
            setUp(0);
        triangles_.clear();
        for (const Slice& s : slices_)
            triangles_.insert(triangles_.end(), s.triangles.begin(), s.triangles.end());
        slices_.clear();
        sortIntoBands();
        tbb::parallel_for(size_t(0), bands_.size(), [&](size_t i) { drawBand(i); },
                          tbb::simple_partitioner());
    }

    void sortIntoBands() {
        for (std::vector<uint32_t>& band : bands_) band.clear();
        for (uint32_t i = 0; i < triangles_.size(); ++i) {
            const uint32_t last = (triangles_[i].y1 - 1) / bandRows;
            for (uint32_t b = triangles_[i].y0 / bandRows; b <= last; ++b) bands_[b].push_back(i);
        }
    }

    void drawBand(size_t i) const {
        if (bands_[i].empty()) return;
        RasterBand band{};
        band.draws = states_.data();
        band.triangles = triangles_.data();
        band.indices = bands_[i].data();
        band.count = bands_[i].size();
        band.y0 = uint32_t(i) * bandRows;
        band.y1 = std::min(band.y0 + bandRows, images_.height);
        band.width = images_.width;
        band.color = images_.color, band.display = images_.display, band.depth = images_.depth;
        kernels_.drawBand(band);
    }

    const RasterKernels& kernels_;
    const DrawImages& images_;
    const std::vector<PlacedDraw>& draws_;
    std::vector<RasterDraw> states_;
    std::vector<Slice> slices_;
    std::vector<RasterTriangle> triangles_;
    std::vector<std::vector<uint32_t>> bands_;  // indices of triangles
};

}  // namespace

void rasterizeDraws(const RasterKernels& kernels, tbb::task_arena& arena, const DrawImages& images,
                    const std::vector<PlacedDraw>& draws) {
    arena.execute([&] { Rasterizer(kernels, images, draws).run(); });
}

}  // namespace gp::cpu
