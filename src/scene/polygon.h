// Flat convex polygons, the shapes of polygonal lights.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

struct Polygon {
    std::vector<glm::vec3> corners;  // none on the line between its neighbours
    glm::vec3 normal{0, 0, 1};       // of the side that sees them counter-clockwise
    double area = 0;
};

// Reads corners that lie in one plane and make a convex shape, both within 1e-4 of its size; leaves
// out those that add nothing to it. Returns "", or why they make no such polygon.
std::string makePolygon(const std::vector<glm::vec3>& corners, Polygon& polygon);

}  // namespace gp
