// Bars, bent tubes and rings.
#include "shapes.h"

#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

void addCap(Mesh& mesh, glm::vec3 centre, glm::vec3 outward,
            const std::vector<glm::vec3>& ring, bool reversed)
{
    const std::uint32_t middle = mesh.addVertex(centre, outward, glm::vec2(0.5f));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : ring)
        mesh.addVertex(p, outward, glm::vec2(0.5f));
    for (std::uint32_t i = 0; i + 1 < ring.size(); ++i) {
        const std::uint32_t a = first + i, b = first + i + 1;
        mesh.addTriangle(middle, reversed ? b : a, reversed ? a : b);
    }
}

}  // namespace

Mesh tube(const std::vector<glm::vec3>& path, const std::vector<float>& radii, int segments)
{
    Mesh mesh;
    const std::size_t count = path.size();
    glm::vec3 across(0.0f);
    float length = 0.0f;
    std::vector<glm::vec3> firstRing, lastRing;
    glm::vec3 firstAxis(0.0f), lastAxis(0.0f);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 axis = glm::normalize(path[std::min(i + 1, count - 1)] -
                                              path[i > 0 ? i - 1 : 0]);
        // Carrying the frame along, rather than taking a new one each time, keeps it untwisted.
        across = i == 0 ? glm::vec3(rotationFromY(axis)[0])
                        : glm::normalize(across - axis * glm::dot(across, axis));
        const glm::vec3 third = glm::cross(axis, across);
        const float radius = radii.size() == 1 ? radii[0] : radii[i];
        if (i > 0)
            length += glm::length(path[i] - path[i - 1]);
        std::vector<glm::vec3> ring;
        for (int s = 0; s <= segments; ++s) {
            const float angle = 2.0f * pi * static_cast<float>(s % segments) /
                                static_cast<float>(segments);
            const glm::vec3 n = across * std::cos(angle) + third * std::sin(angle);
            ring.push_back(path[i] + n * radius);
            mesh.addVertex(ring.back(), n,
                           glm::vec2(length, static_cast<float>(s) /
                                                 static_cast<float>(segments) * 2 * pi * radius));
        }
        if (i == 0) {
            firstRing = ring;
            firstAxis = axis;
        }
        lastRing = ring;
        lastAxis = axis;
    }
    mesh.addGridQuads(segments + 1, static_cast<int>(count));
    addCap(mesh, path.front(), -firstAxis, firstRing, true);
    addCap(mesh, path.back(), lastAxis, lastRing, false);
    return mesh;
}

Mesh bar(glm::vec3 from, glm::vec3 to, float radius, int segments)
{
    return tube({from, to}, {radius}, segments);
}

Mesh torus(float ringRadius, float tubeRadius, int segments, int tubeSegments)
{
    Mesh mesh;
    for (int j = 0; j <= tubeSegments; ++j)
        for (int i = 0; i <= segments; ++i) {
            const float a = 2 * pi * static_cast<float>(i % segments) /
                            static_cast<float>(segments);
            const float b = 2 * pi * static_cast<float>(j % tubeSegments) /
                            static_cast<float>(tubeSegments);
            const glm::vec3 out(std::cos(a), 0.0f, -std::sin(a));
            const glm::vec3 n = out * std::cos(b) + glm::vec3(0, std::sin(b), 0);
            mesh.addVertex(out * ringRadius + n * tubeRadius, n,
                           glm::vec2(static_cast<float>(i) / static_cast<float>(segments),
                                     static_cast<float>(j) / static_cast<float>(tubeSegments)));
        }
    mesh.addGridQuads(segments + 1, tubeSegments + 1);
    return mesh;
}

}  // namespace gp::make_scene
