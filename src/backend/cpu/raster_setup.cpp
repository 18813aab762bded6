#include "backend/cpu/raster_setup.h"

#include <algorithm>
#include <cmath>

#include "backend/cpu/raster_clip.h"
#include "backend/cpu/texture_view.h"

namespace gp::cpu {
namespace {

// A corner on the screen.
struct Corner {
    int64_t x, y;      // in sub-pixels
    double px, py;     // in pixels
    double inverseW;
    const RasterVertex* vertex;
};

RasterVertex vertexOf(const PlacedDraw& placed, size_t corner) {
    const DrawCommand& d = *placed.draw;
    const DrawPlacement& p = placed.placement;
    const size_t i = d.indices.empty() ? corner : d.indices[corner];
    const glm::dvec4 position(d.positions[i]);
    RasterVertex r;
    r.x = glm::dot(p.x, position), r.y = glm::dot(p.y, position), r.w = glm::dot(p.w, position);
    r.depth = glm::dot(p.depth, position);
    r.near = glm::dot(p.near, position), r.far = glm::dot(p.far, position);
    const glm::vec2 uv = d.texCoords.empty() ? glm::vec2(0) : d.texCoords[i];
    r.u = uv.x, r.v = uv.y;
    r.color = d.colors.empty() ? glm::dvec4(1) : glm::dvec4(d.colors[i]);
    return r;
}

// False where clipping has left no digits: of vertices 10^16 times as large as what is seen.
bool placeCorner(const RasterVertex& v, Corner& c) {
    c.inverseW = 1 / v.w;
    c.px = v.x * c.inverseW, c.py = v.y * c.inverseW;
    const bool placed = v.w > 0 && std::abs(c.px) <= 2 * guardBand &&
                        std::abs(c.py) <= 2 * guardBand;  // NaN is not
    if (!placed) return false;
    c.x = std::llround(c.px * double(subPixels)), c.y = std::llround(c.py * double(subPixels));
    c.vertex = &v;
    return true;
}

// The plane through values at three points, over the centres of pixels.
struct PlaneMaker {
    double x[3], y[3], inverseArea;

    RasterPlane operator()(double a, double b, double c) const {
        RasterPlane p;
        p.dx = ((b - a) * (y[2] - y[0]) - (c - a) * (y[1] - y[0])) * inverseArea;
        p.dy = ((c - a) * (x[1] - x[0]) - (b - a) * (x[2] - x[0])) * inverseArea;
        p.at = a + p.dx * (0.5 - x[0]) + p.dy * (0.5 - y[0]);
        return p;
    }
};

// Values belong to where the vertices really are; but the pixels that a thin triangle covers on the
// grid may lie far outside of where it really is, beside how thin it is. Those use the grid.
PlaneMaker planeMaker(const Corner* c, int64_t area) {
    constexpr double subPixel = 1 / double(subPixels);
    PlaneMaker m;
    double longestSquared = 0;
    for (int i = 0; i < 3; ++i) {
        const Corner& next = c[(i + 1) % 3];
        const double dx = double(next.x - c[i].x), dy = double(next.y - c[i].y);
        longestSquared = std::max(longestSquared, dx * dx + dy * dy);
    }
    // Less than a pixel high over its longest side.
    const bool thin =
        double(area) * double(area) < longestSquared * double(subPixels * subPixels);
    for (int i = 0; i < 3; ++i) {
        m.x[i] = thin ? double(c[i].x) * subPixel : c[i].px;
        m.y[i] = thin ? double(c[i].y) * subPixel : c[i].py;
    }
    m.inverseArea = 1 / ((m.x[1] - m.x[0]) * (m.y[2] - m.y[0]) -
                         (m.x[2] - m.x[0]) * (m.y[1] - m.y[0]));
    return m;
}

// Edges that are no left or top edge leave out the pixels that they hit exactly.
// [Direct3D 11.3 functional specification, "Top-Left Rule"]
void setUpEdges(RasterTriangle& t, const Corner* c) {
    constexpr int64_t centre = subPixels / 2;
    for (int i = 0; i < 3; ++i) {
        const Corner &a = c[i], &b = c[(i + 1) % 3];
        const int64_t dx = b.x - a.x, dy = b.y - a.y;
        const bool topLeft = dy < 0 || (dy == 0 && dx > 0);
        t.edge[i] = dx * (centre - a.y) - dy * (centre - a.x) - (topLeft ? 0 : 1);
        t.edgeX[i] = -dy * subPixels;
        t.edgeY[i] = dx * subPixels;
    }
}

void setUpPlanes(RasterTriangle& t, const Corner* c, const PlaneMaker& plane) {
    const RasterVertex &a = *c[0].vertex, &b = *c[1].vertex, &d = *c[2].vertex;
    t.parallel = a.w == 1 && b.w == 1 && d.w == 1;
    const double wa = c[0].inverseW, wb = c[1].inverseW, wd = c[2].inverseW;
    const auto overW = [&](double va, double vb, double vd) {
        return plane(va * wa, vb * wb, vd * wd);
    };
    t.inverseW = plane(wa, wb, wd);
    t.depth = overW(a.depth, b.depth, d.depth);
    t.u = overW(a.u, b.u, d.u), t.v = overW(a.v, b.v, d.v);
    t.oneColor = a.color == b.color && b.color == d.color;
    for (int i = 0; i < 4; ++i)
        t.color[i] = t.oneColor ? RasterPlane{a.color[i], 0, 0}
                                : overW(a.color[i], b.color[i], d.color[i]);
}

// The rows whose centres lie between the corners, within [lo, hi).
void setUpRows(RasterTriangle& t, const Corner* c, uint32_t lo, uint32_t hi) {
    constexpr int64_t centre = subPixels / 2;
    const auto [least, most] = std::minmax({c[0].y, c[1].y, c[2].y});
    const auto rowAfter = [](int64_t y) { return (y - centre + subPixels - 1) >> 8; };
    static_assert(subPixels == 1 << 8);
    t.y0 = uint32_t(std::clamp<int64_t>(rowAfter(least), lo, hi));
    t.y1 = uint32_t(std::clamp<int64_t>(rowAfter(most + 1), lo, hi));
}

// Twice the area in square sub-pixels; y runs downwards: counter-clockwise is negative.
int64_t signedArea(const Corner& a, const Corner& b, const Corner& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

// A part of a polygon that faces as the whole does; the grid may have turned tiny ones over, which
// would be drawn over their neighbours.
void setUpTriangle(const PlacedDraw& placed, uint32_t draw, bool front, const Corner& a,
                   const Corner& b, const Corner& c, std::vector<RasterTriangle>& triangles) {
    const int64_t area = front ? -signedArea(a, b, c) : signedArea(a, b, c);
    if (area <= 0) return;
    const Corner corners[3] = {a, front ? c : b, front ? b : c};
    RasterTriangle t;
    t.draw = draw;
    setUpRows(t, corners, placed.placement.y0, placed.placement.y1);
    if (t.y0 >= t.y1) return;
    setUpEdges(t, corners);
    setUpPlanes(t, corners, planeMaker(corners, area));
    triangles.push_back(t);
}

}  // namespace

void setUpTriangles(const PlacedDraw& placed, uint32_t draw, size_t first, size_t count,
                    std::vector<RasterTriangle>& triangles) {
    const DrawPlacement& p = placed.placement;
    if (p.x0 >= p.x1 || p.y0 >= p.y1) return;
    for (size_t i = first; i < first + count; ++i) {
        const ClippedPolygon polygon =
            clipTriangle(vertexOf(placed, 3 * i), vertexOf(placed, 3 * i + 1),
                         vertexOf(placed, 3 * i + 2));
        if (polygon.count < 3) continue;
        Corner corners[mostCorners];
        size_t placedCorners = 0;
        for (size_t k = 0; k < polygon.count; ++k)
            placedCorners += placeCorner(polygon.corners[k], corners[k]);
        if (placedCorners < polygon.count) continue;
        int64_t area = 0;
        for (size_t k = 2; k < polygon.count; ++k)
            area += signedArea(corners[0], corners[k - 1], corners[k]);
        const bool front = area < 0;
        const Cull cull = placed.draw->cull;
        if ((cull == Cull::back && !front) || (cull == Cull::front && front)) continue;
        for (size_t k = 2; k < polygon.count; ++k)
            setUpTriangle(placed, draw, front, corners[0], corners[k - 1], corners[k], triangles);
    }
}

RasterDraw rasterDraw(const PlacedDraw& placed, bool display) {
    const DrawCommand& d = *placed.draw;
    RasterDraw r{};
    if (d.texture) {
        r.texture = textureView(*d.texture);
        r.textured = 1;
        // A display takes bytes as they stand.
        r.encodeTexels = display && r.texture.isFloat;
        if (display) r.texture.isSrgb = 0;
    }
    const DrawState& s = d.state;
    r.blend = s.blend, r.depthWrite = s.depthWrite;
    r.blendSource = s.blendSource, r.blendDestination = s.blendDestination;
    r.blendSourceAlpha = s.blendSourceAlpha, r.blendDestinationAlpha = s.blendDestinationAlpha;
    r.depthTest = s.depthTest;
    r.alphaThreshold = s.alphaThreshold;
    for (int i = 0; i < 4; ++i) r.color[i] = d.color[i];
    r.x0 = placed.placement.x0, r.x1 = placed.placement.x1;
    return r;
}

}  // namespace gp::cpu
