// From the views of GpDrawDesc to rows that take a vertex to its pixel and depth.
#include <algorithm>
#include <cmath>

#include "frame/camera_params.h"
#include "frame/draw.h"

namespace gp {
namespace {

// Rows over (x, y, z, 1) of the world, before pixels: x and y in -w..w, +y up.
struct ClipRows {
    glm::dvec4 x{0}, y{0}, w{0}, depth{0}, near{0}, far{0};
};

// The rows of film and depth of camera_film_from_world.
ClipRows rowsOfCamera(const shading::CameraParams& c) {
    const glm::dvec3 origin(c.position);
    const auto row = [&](glm::vec3 axis, float half) {
        const glm::dvec3 scaled = glm::dvec3(axis) / double(half);
        return glm::dvec4(scaled, -glm::dot(scaled, origin));
    };
    ClipRows rows;
    rows.x = row(c.right, c.half_x);
    rows.y = row(c.up, c.half_y);
    rows.depth = row(c.forward, 1);
    rows.w = c.kind == CAMERA_ORTHOGRAPHIC ? glm::dvec4(0, 0, 0, 1) : rows.depth;
    rows.near = rows.depth;
    return rows;
}

// Of OpenGL's clip volume; x and y are cut by the viewport's rectangle of pixels.
ClipRows rowsOfMatrix(const glm::mat4& m) {
    const auto row = [&](int i) { return glm::dvec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
    ClipRows rows;
    rows.x = row(0), rows.y = row(1), rows.w = row(3);
    const glm::dvec4 z = row(2);
    const bool parallel = rows.w.x == 0 && rows.w.y == 0 && rows.w.z == 0;
    rows.depth = parallel ? z : rows.w;
    rows.near = rows.w + z;
    rows.far = rows.w - z;
    return rows;
}

ClipRows rowsOfPixels(const glm::vec4& viewport) {
    ClipRows rows;
    rows.x = {2 / double(viewport.z), 0, 0, -1};
    rows.y = {0, -2 / double(viewport.w), 0, 1};
    rows.w = {0, 0, 0, 1};
    rows.depth = {0, 0, 1, 0};
    return rows;
}

ClipRows rowsOf(const DrawCommand& draw, const Camera& camera, const glm::vec4& viewport,
                uint32_t width, uint32_t height) {
    if (draw.view == DrawView::matrix) return rowsOfMatrix(draw.viewProjection);
    if (draw.view == DrawView::pixels) return rowsOfPixels(viewport);
    shading::CameraParams c = cameraParams(camera, width, height);
    if (draw.target == DrawTarget::sky) c.position = glm::vec3(0);
    return rowsOfCamera(c);
}

// The first pixel whose centre is not before `edge`.
uint32_t firstPixel(double edge, uint32_t size) {
    return uint32_t(std::clamp(std::ceil(edge - 0.5), 0.0, double(size)));
}

DrawPlacement placeInViewport(const DrawCommand& draw, const Camera& camera, const glm::vec4& v,
                              uint32_t width, uint32_t height) {
    const ClipRows rows = rowsOf(draw, camera, v, width, height);
    const glm::dmat4 world(draw.worldFromObject);
    DrawPlacement p;
    // [OpenGL 2.1 specification, section 2.11.1], with y downwards
    p.x = (rows.w * (v.x + 0.5 * v.z) + rows.x * (0.5 * v.z)) * world;
    p.y = (rows.w * (v.y + 0.5 * v.w) - rows.y * (0.5 * v.w)) * world;
    p.w = rows.w * world;
    p.depth = rows.depth * (1.0 - double(draw.depthBias)) * world;
    p.near = rows.near * world, p.far = rows.far * world;
    p.x0 = firstPixel(v.x, width), p.x1 = firstPixel(double(v.x) + v.z, width);
    p.y0 = firstPixel(v.y, height), p.y1 = firstPixel(double(v.y) + v.w, height);
    return p;
}

}  // namespace

DrawPlacement placeInWholeFrame(const DrawCommand& draw, const Camera& camera, uint32_t width,
                                uint32_t height) {
    return placeInViewport(draw, camera, {0, 0, float(width), float(height)}, width, height);
}

DrawPlacement placeDraw(const DrawCommand& draw, const Camera& camera, uint32_t width,
                        uint32_t height) {
    if (draw.viewport == glm::vec4(0)) return placeInWholeFrame(draw, camera, width, height);
    return placeInViewport(draw, camera, draw.viewport, width, height);
}

}  // namespace gp
