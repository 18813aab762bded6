#include "scene/polygon.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace gp {

namespace {

constexpr double tolerance = 1e-4;  // of the polygon's size: how far from flat and convex
constexpr double straight = 1e-6;   // a corner so near to the line between its neighbours is none

// Twice the vector area, relative to the first corner, so that far away no digits are lost.
glm::dvec3 doubleArea(const std::vector<glm::dvec3>& p) {
    glm::dvec3 sum(0);
    for (size_t i = 1; i + 1 < p.size(); ++i) sum += glm::cross(p[i] - p[0], p[i + 1] - p[0]);
    return sum;
}

double sizeOf(const std::vector<glm::dvec3>& p) {
    glm::dvec3 lo = p[0], hi = p[0];
    for (const glm::dvec3& c : p) lo = glm::min(lo, c), hi = glm::max(hi, c);
    return glm::length(hi - lo);
}

// How far a corner stands out of the line between its neighbours; negative: to the inside.
double height(glm::dvec3 before, glm::dvec3 at, glm::dvec3 after, glm::dvec3 normal) {
    const double base = glm::length(after - before);
    const double area = glm::dot(glm::cross(at - before, after - at), normal);
    return base > 0 ? area / base : 0;
}

// Whether the edges turn around once, and not several times as those of a star do.
bool turnsOnce(const std::vector<glm::dvec3>& p, glm::dvec3 normal) {
    double turn = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 a = p[(i + 1) % p.size()] - p[i];
        const glm::dvec3 b = p[(i + 2) % p.size()] - p[(i + 1) % p.size()];
        turn += std::atan2(glm::dot(glm::cross(a, b), normal), glm::dot(a, b));
    }
    return turn < 3 * std::numbers::pi;
}

}  // namespace

std::string makePolygon(const std::vector<glm::vec3>& corners, Polygon& polygon) {
    std::vector<glm::dvec3> p(corners.begin(), corners.end());
    std::vector<size_t> given(p.size());
    for (size_t i = 0; i < given.size(); ++i) given[i] = i;
    const double size = sizeOf(p);
    const glm::dvec3 doubled = doubleArea(p);
    const double area = glm::length(doubled) / 2;
    if (!(area > 1e-6 * size * size) || float(area) < 1e-30f) return "corners span no area";
    if (!std::isfinite(float(area))) return "corners are too far apart";
    const glm::dvec3 n = doubled / (2 * area);
    for (size_t i = 1; i < p.size(); ++i)
        if (const double off = glm::dot(p[i] - p[0], n); std::abs(off) > tolerance * size)
            return fmt::format("corners[{}] is {:.3g} m outside of the plane of the others", i,
                               std::abs(off));
    // Leaving one out may make a neighbour superfluous.
    for (size_t i = 0, unchanged = 0; unchanged < p.size();) {
        const size_t count = p.size();
        const double h = height(p[(i + count - 1) % count], p[i], p[(i + 1) % count], n);
        if (h < -tolerance * size)
            return fmt::format("corners[{}] makes the polygon concave: split it", given[i]);
        if (h > straight * size) {
            ++unchanged;
            i = (i + 1) % count;
            continue;
        }
        p.erase(p.begin() + ptrdiff_t(i)), given.erase(given.begin() + ptrdiff_t(i));
        if (p.size() < 3) return "corners span no area";
        i = (i + p.size() - 1) % p.size();
        unchanged = 0;
    }
    if (!turnsOnce(p, n)) return "the edges between the corners cross each other";
    polygon.normal = glm::vec3(n);
    polygon.area = area;
    polygon.corners.clear();
    for (const size_t i : given) polygon.corners.push_back(corners[i]);
    return "";
}

}  // namespace gp
