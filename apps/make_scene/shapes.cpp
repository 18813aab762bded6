#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

glm::vec3 around(float radius, float height, int step, int segments)
{
    // The last column must be the first one to the bit, or the seam is open.
    const float angle = 2.0f * pi * static_cast<float>(step % segments) /
                        static_cast<float>(segments);
    return glm::vec3(radius * std::cos(angle), height, -radius * std::sin(angle));
}

glm::vec2 segmentNormal(const ProfilePoint& from, const ProfilePoint& to)
{
    const glm::vec2 d(to.radius - from.radius, to.height - from.height);
    const float length = glm::length(d);
    return length > 0.0f ? glm::vec2(d.y, -d.x) / length : glm::vec2(0.0f);
}

// The coordinates of the grid lines along one side of a rounded box: dense in the bevels.
std::vector<float> boxLines(float half, float radius, int steps)
{
    std::vector<float> lines;
    if (radius <= 0.0f)
        return {-half, half};
    for (int i = steps; i >= 0; --i)
        lines.push_back(-(half - radius) - radius * std::tan(pi / 4 * static_cast<float>(i) /
                                                             static_cast<float>(steps)));
    for (int i = 0; i <= steps; ++i)
        lines.push_back(-lines[static_cast<std::size_t>(steps - i)]);
    // To the bit where the neighbouring face lies, or the box is open along its edges.
    lines.front() = -half;
    lines.back() = half;
    return lines;
}

}  // namespace

Profile smoothProfile(const Profile& points, int stepsPerSpan)
{
    // [Catmull and Rom 1974, "A class of local interpolating splines"], tension 1/2
    Profile result;
    const auto value = [](const ProfilePoint& p) { return glm::vec2(p.radius, p.height); };
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::vec2 p1 = value(points[i]), p2 = value(points[i + 1]);
        const bool startsHere = i == 0 || points[i].sharp;
        const bool endsHere = i + 2 == points.size() || points[i + 1].sharp;
        const glm::vec2 m1 = startsHere ? p2 - p1 : 0.5f * (p2 - value(points[i - 1]));
        const glm::vec2 m2 = endsHere ? p2 - p1 : 0.5f * (value(points[i + 2]) - p1);
        for (int k = 0; k < stepsPerSpan; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(stepsPerSpan);
            const glm::vec2 p = (2 * t * t * t - 3 * t * t + 1) * p1 +
                                (t * t * t - 2 * t * t + t) * m1 +
                                (-2 * t * t * t + 3 * t * t) * p2 + (t * t * t - t * t) * m2;
            result.push_back({std::max(p.x, 0.0f), p.y, k == 0 && points[i].sharp});
        }
    }
    result.push_back(points.back());
    return result;
}

Mesh lathe(const Profile& profile, int segments)
{
    Mesh mesh;
    float total = 0.0f;
    std::vector<float> arc{0.0f};
    for (std::size_t i = 1; i < profile.size(); ++i) {
        total += glm::length(glm::vec2(profile[i].radius - profile[i - 1].radius,
                                       profile[i].height - profile[i - 1].height));
        arc.push_back(total);
    }
    const auto addRow = [&](std::size_t i, glm::vec2 n) {
        if (profile[i].radius <= 0.0f)
            n = glm::vec2(0.0f, n.y < 0.0f ? -1.0f : 1.0f);
        n = glm::normalize(n);
        for (int s = 0; s <= segments; ++s)
            mesh.addVertex(around(profile[i].radius, profile[i].height, s, segments),
                           around(n.x, n.y, s, segments),
                           glm::vec2(static_cast<float>(s) / static_cast<float>(segments),
                                     arc[i] / total));
    };
    int rows = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const glm::vec2 before = i > 0 ? segmentNormal(profile[i - 1], profile[i]) : glm::vec2(0);
        const glm::vec2 after = i + 1 < profile.size() ? segmentNormal(profile[i], profile[i + 1])
                                                       : glm::vec2(0);
        const bool inside = i > 0 && i + 1 < profile.size();
        if (profile[i].sharp && inside) {
            addRow(i, before);
            mesh.addGridQuads(segments + 1, rows + 1);
            addRow(i, after);
            rows = 1;
        } else {
            addRow(i, before + after);
            ++rows;
        }
    }
    mesh.addGridQuads(segments + 1, rows);
    mesh.removeUnusedVertices();
    return mesh;
}

Mesh sphere(float radius, int segments, int rings)
{
    Profile profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = pi * static_cast<float>(i) / static_cast<float>(rings);
        const bool pole = i == 0 || i == rings;
        profile.push_back({pole ? 0.0f : radius * std::sin(angle), -radius * std::cos(angle)});
    }
    Mesh mesh = lathe(profile, segments);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.normals[i] = glm::normalize(mesh.positions[i]);
    return mesh;
}

Mesh cylinder(float radius, float bottom, float top, int segments, float bevel)
{
    if (bevel <= 0.0f)
        return lathe({{0, bottom}, {radius, bottom, true}, {radius, top, true}, {0, top}},
                     segments);
    Profile profile{{0, bottom}};
    for (int i = 0; i <= 3; ++i) {
        const float a = pi / 6 * static_cast<float>(i);
        profile.push_back({radius - bevel * (1 - std::sin(a)), bottom + bevel * (1 - std::cos(a))});
    }
    for (int i = 0; i <= 3; ++i) {
        const float a = pi / 6 * static_cast<float>(i);
        profile.push_back({radius - bevel * (1 - std::cos(a)), top - bevel * (1 - std::sin(a))});
    }
    profile.push_back({0, top});
    return lathe(profile, segments);
}

Mesh cubeSphere(int n)
{
    // Equal angles rather than equal steps: the corner triangles come out nearly as large.
    std::vector<float> lines;
    for (int i = 0; i <= n; ++i)
        lines.push_back(std::tan(pi / 4 * (2.0f * static_cast<float>(i) / static_cast<float>(n) -
                                           1.0f)));
    lines.front() = -1.0f;
    lines.back() = 1.0f;
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            Mesh face;
            for (const float b : lines)
                for (const float a : lines) {
                    glm::vec3 p;
                    p[axis] = side;
                    p[(axis + 1) % 3] = a;
                    p[(axis + 2) % 3] = b;
                    p = glm::normalize(p);
                    face.addVertex(p, p, glm::vec2(a, b) * 0.5f + 0.5f);
                }
            face.addGridQuads(n + 1, n + 1);
            if (side < 0.0f)
                for (std::size_t i = 0; i < face.indices.size(); i += 3)
                    std::swap(face.indices[i + 1], face.indices[i + 2]);
            mesh.append(face);
        }
    return mesh;
}

Mesh box(glm::vec3 size, float radius, int bevelSteps)
{
    const glm::vec3 half = size * 0.5f;
    std::array<std::vector<float>, 3> lines;
    for (int axis = 0; axis < 3; ++axis)
        lines[static_cast<std::size_t>(axis)] = boxLines(half[axis], radius, bevelSteps);
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const int ua = (axis + 1) % 3, va = (axis + 2) % 3;
            const auto& us = lines[static_cast<std::size_t>(ua)];
            const auto& vs = lines[static_cast<std::size_t>(va)];
            const bool swapUv = size[va] > size[ua];
            Mesh face;
            for (const float b : vs)
                for (const float a : us) {
                    glm::vec3 p;
                    p[axis] = side * half[axis];
                    p[ua] = a;
                    p[va] = b;
                    const glm::vec3 core = glm::clamp(p, radius - half, half - radius);
                    glm::vec3 n(0.0f);
                    n[axis] = side;
                    if (radius > 0.0f)
                        n = glm::normalize(p - core);
                    face.addVertex(core + n * radius, n,
                                   swapUv ? glm::vec2(b, a) : glm::vec2(a, b));
                }
            face.addGridQuads(static_cast<int>(us.size()), static_cast<int>(vs.size()));
            if (side < 0.0f)
                for (std::size_t i = 0; i < face.indices.size(); i += 3)
                    std::swap(face.indices[i + 1], face.indices[i + 2]);
            mesh.append(face);
        }
    return mesh;
}

Mesh surface(int columns, int rows, const std::function<glm::vec3(glm::vec2)>& position)
{
    Mesh mesh;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const glm::vec2 uv(static_cast<float>(i) / static_cast<float>(columns - 1),
                               static_cast<float>(j) / static_cast<float>(rows - 1));
            mesh.addVertex(position(uv), glm::vec3(0, 1, 0), uv);
        }
    mesh.addGridQuads(columns, rows);
    mesh.computeSmoothNormals();
    return mesh;
}

Mesh quad(glm::vec3 centre, glm::vec3 halfU, glm::vec3 halfV, glm::vec2 uvSize)
{
    Mesh mesh;
    const glm::vec3 n = glm::normalize(glm::cross(halfU, halfV));
    mesh.addVertex(centre - halfU - halfV, n, glm::vec2(0, uvSize.y));
    mesh.addVertex(centre + halfU - halfV, n, uvSize);
    mesh.addVertex(centre + halfU + halfV, n, glm::vec2(uvSize.x, 0));
    mesh.addVertex(centre - halfU + halfV, n, glm::vec2(0, 0));
    mesh.addQuad(0, 1, 2, 3);
    return mesh;
}

}  // namespace gp::make_scene
