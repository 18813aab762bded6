#include "frame/compose.h"

#include <algorithm>
#include <limits>

#include "shading/shading.h"

namespace gp {
namespace {

// What lies in a traced surface shows: rounding would make it come and go (GpDrawDesc::depthBias).
constexpr float tracedDepthBias = 1e-4f;

std::vector<PlacedDraw> drawsOf(const DrawList& draws, DrawTarget target, const Camera& camera,
                                uint32_t width, uint32_t height) {
    std::vector<PlacedDraw> placed;
    for (const DrawCommand& draw : draws)
        if (draw.target == target)
            placed.push_back({&draw, placeDraw(draw, camera, width, height)});
    return placed;
}

// Sums of ones that were divided by their number: less than this is an edge, not rounding.
constexpr float wholeCoverage = 0.99999f;

// A pixel at the edge of a surface, and what its rays that met nothing saw.
struct EdgePixel {
    size_t index;
    glm::vec4 background;
};

// The frame does not keep what a pixel shows behind an edge; the nearest pixels without an edge
// tell. Edges are as wide as the pixel filter is: farther away there is no need to look.
glm::vec4 backgroundNear(const glm::vec4* color, uint32_t width, uint32_t height, uint32_t x,
                         uint32_t y) {
    constexpr uint32_t farthest = 4;
    for (uint32_t reach = 1; reach <= farthest; ++reach) {
        glm::vec4 sum(0);
        float count = 0;
        for (uint32_t j = y - std::min(y, reach); j <= std::min(y + reach, height - 1); ++j)
            for (uint32_t i = x - std::min(x, reach); i <= std::min(x + reach, width - 1); ++i) {
                const glm::vec4& c = color[size_t(j) * width + i];
                if (c.w == 0) sum += c, count += 1;
            }
        if (count > 0) return sum / count;
    }
    return glm::vec4(0);
}

// The sky is drawn over an image of the background alone, whose change each pixel then gets a share
// of.
void composeSky(Backend& backend, const std::vector<PlacedDraw>& draws, uint32_t width,
                uint32_t height, glm::vec4* color) {
    const size_t pixels = size_t(width) * height;
    std::vector<glm::vec4> sky(color, color + pixels);
    std::vector<EdgePixel> edges;
    for (size_t i = 0; i < pixels; ++i) {
        if (color[i].w == 0 || color[i].w >= wholeCoverage) continue;
        sky[i] = backgroundNear(color, width, height, uint32_t(i % width), uint32_t(i / width));
        edges.push_back({i, sky[i]});
    }
    std::vector<float> depth(usesDepth(draws) ? pixels : 0,
                             std::numeric_limits<float>::infinity());
    backend.rasterize({width, height, sky.data(), nullptr, depth.empty() ? nullptr : depth.data()},
                      draws);
    for (const EdgePixel& e : edges) {
        const glm::vec4 c = color[e.index] + (1 - color[e.index].w) * (sky[e.index] - e.background);
        // The surface adds to its share of sky. Anti-aliasing over time bounds colours, but not
        // coverage by the same amount: where the traced sky was bright, c would be below that.
        sky[e.index] = glm::max(c, (1 - color[e.index].w) * sky[e.index]);
    }
    for (size_t i = 0; i < pixels; ++i)
        if (color[i].w < wholeCoverage) color[i] = sky[i];
}

}  // namespace

bool usesDepth(const std::vector<PlacedDraw>& draws) {
    return std::any_of(draws.begin(), draws.end(), [](const PlacedDraw& d) {
        return d.draw->state.depthTest != DEPTH_ALWAYS || d.draw->state.depthWrite;
    });
}

void composeDraws(Backend& backend, const DrawList& draws, const Camera& camera, uint32_t width,
                  uint32_t height, glm::vec4* color, const float* depth) {
    const auto sky = drawsOf(draws, DrawTarget::sky, camera, width, height);
    if (!sky.empty()) composeSky(backend, sky, width, height, color);
    const auto scene = drawsOf(draws, DrawTarget::scene, camera, width, height);
    if (scene.empty()) return;
    std::vector<float> held;
    if (usesDepth(scene)) {
        held.assign(depth, depth + size_t(width) * height);
        for (float& d : held) d *= 1 + tracedDepthBias;
    }
    backend.rasterize({width, height, color, nullptr, held.empty() ? nullptr : held.data()}, scene);
}

void drawOverlay(Backend& backend, const DrawList& draws, const Camera& camera,
                 FrameImages& images) {
    const auto overlay =
        drawsOf(draws, DrawTarget::overlay, camera, images.width, images.height);
    if (overlay.empty()) return;
    std::vector<float> depth(usesDepth(overlay) ? images.pixelCount() : 0,
                             std::numeric_limits<float>::infinity());
    backend.rasterize({images.width, images.height, nullptr, images.display.data(),
                       depth.empty() ? nullptr : depth.data()},
                      overlay);
}

TracedPicture tracedPicture(Backend& backend, const FramePlan& plan, FrameImages& images) {
    return {[&](FrameImage which, void* pixels) { readFrameImage(images, which, pixels); },
            [&](float ev) { backend.tonemap(ev, plan.tonemap, images); }};
}

void finishPicture(Backend& backend, const FramePlan& plan, float exposureEv,
                   const TracedPicture& traced, FrameImages& images) {
    images.drawn = {};
    static const DrawList none;
    const DrawList& draws = plan.draws ? *plan.draws : none;
    const bool intoColor = std::any_of(draws.begin(), draws.end(), [](const DrawCommand& d) {
        return d.target != DrawTarget::overlay;
    });
    if (intoColor) {
        std::vector<glm::vec4> color(images.pixelCount());
        std::vector<float> depth(images.pixelCount());
        traced.read(FrameImage::color, color.data());
        traced.read(FrameImage::depth, depth.data());
        composeDraws(backend, draws, plan.camera, images.width, images.height, color.data(),
                     depth.data());
        images.drawn.swap(color);
        backend.tonemap(exposureEv, plan.tonemap, images);
    } else {
        traced.tonemap(exposureEv);
    }
    drawOverlay(backend, draws, plan.camera, images);
}

}  // namespace gp
