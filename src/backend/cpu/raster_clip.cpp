#include "backend/cpu/raster_clip.h"

#include <cmath>

namespace gp::cpu {
namespace {

// The signed distance of a vertex from a plane, in the plane's own units.
double distanceFrom(size_t plane, const RasterVertex& p) {
    switch (plane) {
        case 0: return p.near;
        case 1: return p.far;
        case 2: return p.w - leastW;
        case 3: return guardBand * p.w + p.x;
        case 4: return guardBand * p.w - p.x;
        case 5: return guardBand * p.w + p.y;
        default: return guardBand * p.w - p.y;
    }
}

RasterVertex between(const RasterVertex& a, const RasterVertex& b, double t) {
    const auto mix = [t](const auto& from, const auto& to) { return from + (to - from) * t; };
    RasterVertex r;
    r.x = mix(a.x, b.x), r.y = mix(a.y, b.y), r.w = mix(a.w, b.w);
    r.depth = mix(a.depth, b.depth);
    r.near = mix(a.near, b.near), r.far = mix(a.far, b.far);
    r.u = mix(a.u, b.u), r.v = mix(a.v, b.v);
    r.color = mix(a.color, b.color);
    return r;
}

// One plane. New corners are always counted from the side that stays, so that two triangles with a
// common edge get the same one, bit by bit: no gap opens between them.
// [Sutherland and Hodgman 1974, "Reentrant Polygon Clipping"]
ClippedPolygon clipBy(size_t plane, const ClippedPolygon& polygon) {
    ClippedPolygon result;
    for (size_t i = 0; i < polygon.count; ++i) {
        const RasterVertex& a = polygon.corners[i];
        const RasterVertex& b = polygon.corners[(i + 1) % polygon.count];
        const double da = distanceFrom(plane, a), db = distanceFrom(plane, b);
        if (da >= 0) result.corners[result.count++] = a;
        if (da >= 0 && db < 0)
            result.corners[result.count++] = between(a, b, da / (da - db));
        else if (da < 0 && db >= 0)
            result.corners[result.count++] = between(b, a, db / (db - da));
    }
    return result;
}

}  // namespace

ClippedPolygon clipTriangle(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
    ClippedPolygon polygon;
    polygon.corners[0] = a, polygon.corners[1] = b, polygon.corners[2] = c;
    polygon.count = 3;
    for (size_t plane = 0; plane < clipPlanes; ++plane) {
        size_t inside = 0;
        for (size_t i = 0; i < polygon.count; ++i)
            inside += distanceFrom(plane, polygon.corners[i]) >= 0;
        if (inside == polygon.count) continue;
        if (inside == 0) return {};
        polygon = clipBy(plane, polygon);
    }
    return polygon;
}

}  // namespace gp::cpu
