#include "shading/shading.h"

#include "scene/mesh.h"

#include <algorithm>
#include <cmath>

#include "scene/tangents.h"

namespace gp {

namespace {

glm::vec3 faceNormal(const std::vector<glm::vec3>& positions, glm::uvec3 t) {
    return glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]);
}

// Unit length, or zero where there is no direction.
glm::vec3 unit(glm::vec3 v) {
    // Scaled first: squares of very small or large components leave the range of float.
    // (A sum, unlike a maximum, does not lose a NaN.)
    const float most = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    if (!(most > 0) || !std::isfinite(most)) return glm::vec3(0);
    return glm::normalize(v / most);
}

// values[order[i]] for each i; an empty order leaves all in place.
template <typename T>
void gather(std::vector<T>& values, const std::vector<uint32_t>& order) {
    if (values.empty() || order.empty()) return;
    std::vector<T> out(order.size());
    for (size_t i = 0; i < order.size(); ++i) out[i] = values[order[i]];
    values = std::move(out);
}

void gatherAll(MeshData& data, const std::vector<uint32_t>& order) {
    gather(data.positions, order);
    gather(data.normals, order);
    gather(data.tangents, order);
    gather(data.uv[0], order);
    gather(data.uv[1], order);
    gather(data.colors, order);
    if (data.given.empty()) data.given = order;
    else gather(data.given, order);
}

std::vector<glm::uvec3> takeTriangles(MeshData& data) {
    std::vector<glm::uvec3> triangles;
    if (data.indices.empty()) {
        triangles.resize(data.positions.size() / 3);
        for (uint32_t i = 0; i < triangles.size(); ++i)
            triangles[i] = glm::uvec3(0, 1, 2) + i * 3;
        return triangles;
    }
    triangles.resize(data.indices.size() / 3);
    for (size_t i = 0; i < triangles.size(); ++i)
        triangles[i] = {data.indices[i * 3], data.indices[i * 3 + 1], data.indices[i * 3 + 2]};
    data.indices = {};
    return triangles;
}

// Flat shading: no two triangles share a vertex. (glTF 2.0, 3.7.2.1; given tangents are ignored.)
void makeFlat(MeshData& data, std::vector<glm::uvec3>& triangles) {
    data.tangents.clear();
    std::vector<uint32_t> order(triangles.size() * 3);
    for (size_t i = 0; i < order.size(); ++i) order[i] = triangles[i / 3][int(i % 3)];
    gatherAll(data, order);
    data.normals.resize(order.size());
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        triangles[i] = glm::uvec3(0, 1, 2) + i * 3;
        glm::vec3 n = unit(faceNormal(data.positions, triangles[i]));
        if (n == glm::vec3(0)) n = {0, 0, 1};  // a triangle without area is never seen
        for (int c = 0; c < 3; ++c) data.normals[triangles[i][c]] = n;
    }
}

// Files hold normals of any length; those of length zero are made from the triangles around.
void repairNormals(MeshData& data, const std::vector<glm::uvec3>& triangles) {
    bool missing = false;
    for (glm::vec3& n : data.normals) {
        n = unit(n);
        missing |= n == glm::vec3(0);
    }
    if (!missing) return;
    std::vector<glm::vec3> sums(data.normals.size(), glm::vec3(0));
    for (const glm::uvec3& t : triangles)
        for (int c = 0; c < 3; ++c) sums[t[c]] += faceNormal(data.positions, t);
    for (size_t v = 0; v < sums.size(); ++v) {
        if (data.normals[v] != glm::vec3(0)) continue;
        data.normals[v] = unit(sums[v]);
        if (data.normals[v] == glm::vec3(0)) data.normals[v] = {0, 0, 1};
    }
}

bool lacksTangents(const MeshData& data, const MeshOptions& options) {
    return options.needsTangents && data.tangents.empty() &&
           !data.uv[options.tangentUv & 1].empty();
}

// Where the corners that share a vertex disagree about its tangent, it is copied. Returns, for each
// vertex, the one that it was.
std::vector<uint32_t> addTangents(MeshData& data, std::vector<glm::uvec3>& triangles,
                                  const MeshOptions& options) {
    std::vector<glm::vec2> uv = data.uv[options.tangentUv & 1];
    for (glm::vec2& p : uv) p = options.uvTransform * glm::vec3(p, 1);
    const std::vector<glm::vec4> corners =
        generateTangents({data.positions, data.normals, uv, triangles});

    const size_t count = data.positions.size();
    constexpr uint32_t none = ~0u;
    std::vector<uint32_t> order(count), next(count, none);  // next: chain of a vertex's copies
    std::vector<glm::vec4> tangents(count, glm::vec4(0));
    for (uint32_t v = 0; v < count; ++v) order[v] = v;
    for (size_t i = 0; i < corners.size(); ++i) {
        uint32_t& vertex = triangles[i / 3][int(i % 3)];
        uint32_t v = vertex;
        while (tangents[v].w != 0 && tangents[v] != corners[i] && next[v] != none) v = next[v];
        if (tangents[v].w != 0 && tangents[v] != corners[i]) {
            next[v] = static_cast<uint32_t>(order.size());
            v = next[v];
            order.push_back(vertex);
            next.push_back(none);
            tangents.emplace_back(0);
        }
        tangents[v] = corners[i];
        vertex = v;
    }
    data.tangents.clear();
    if (order.size() != count) gatherAll(data, order);
    data.tangents = std::move(tangents);
    return order;
}

uint32_t packTangent(glm::vec3 normal, glm::vec4 tangent) {
    const float sign = tangent.w < 0 ? -1.0f : 1.0f;
    const glm::vec3 t = unit(glm::vec3(tangent));
    return shading::tangent_encode(shading::frame_from_normal_tangent(normal, t, sign).t, sign);
}

// Packed tangents for other coordinates on the vertices as they are; zeros where some vertex would
// need two.
std::vector<uint32_t> tangentsOf(const Mesh& mesh, std::vector<glm::vec2> uv) {
    const size_t count = mesh.vertexCount();
    std::vector<uint32_t> packed(count, 0);
    if (uv.empty()) return packed;
    for (glm::vec2& p : uv) p = mesh.options.uvTransform * glm::vec3(p, 1);
    std::vector<glm::vec3> normals(count);
    for (size_t v = 0; v < count; ++v)
        normals[v] = shading::octahedral_decode(mesh.vertices[v].normalOct);
    const std::vector<glm::vec4> corners = generateTangents(
        {{mesh.positions.data(), count}, normals, uv, mesh.triangles});
    std::vector<glm::vec4> tangents(count, glm::vec4(0));
    for (size_t i = 0; i < corners.size(); ++i) {
        const uint32_t v = mesh.triangles[i / 3][int(i % 3)];
        if (tangents[v].w != 0 && tangents[v] != corners[i]) return packed;
        tangents[v] = corners[i];
    }
    for (size_t v = 0; v < count; ++v) packed[v] = packTangent(normals[v], tangents[v]);
    return packed;
}

// Whether coordinates are the old ones moved as a whole, but for rounding, as those of a texture
// that scrolls are: tangents then stay. Finding them anew costs a hundred times as much.
bool onlyMoved(const Mesh& mesh, uint32_t set, const std::vector<glm::vec2>& uv) {
    if (uv.empty() || (set == 1 && mesh.uv1.empty())) return false;
    const auto old = [&](size_t v) { return set == 0 ? mesh.vertices[v].uv : mesh.uv1[v]; };
    constexpr float rounding = 2.4e-7f;  // two steps of a float
    const glm::vec2 move = uv[0] - old(0);
    for (size_t v = 1; v < uv.size(); ++v) {
        const glm::vec2 size = glm::max(glm::abs(uv[v]), glm::abs(old(v))) + glm::abs(move);
        const glm::vec2 off = glm::abs(uv[v] - old(v) - move);
        if (off.x > rounding * size.x || off.y > rounding * size.y) return false;
    }
    return true;
}

glm::u8vec4 packColor(glm::vec4 c) {
    return glm::u8vec4(glm::clamp(c, 0.0f, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

std::vector<uint32_t> giveTangents(MeshData& data, const MeshOptions& options) {
    // Flat normals come with vertices that no triangles share: those need no copies.
    if (!lacksTangents(data, options) || data.normals.empty()) return {};
    std::vector<glm::uvec3> triangles = takeTriangles(data);
    repairNormals(data, triangles);
    std::vector<uint32_t> order = addTangents(data, triangles, options);
    for (const glm::uvec3& t : triangles)
        data.indices.insert(data.indices.end(), {t.x, t.y, t.z});
    return order;
}

void fillMesh(Mesh& mesh, MeshData&& data, const MeshOptions& options) {
    mesh.options = options;
    mesh.givenCount = data.positions.size();
    mesh.tangentsGenerated = options.needsTangents && (data.tangents.empty() ||
                                                       data.normals.empty());
    mesh.triangles = takeTriangles(data);
    if (data.normals.empty()) makeFlat(data, mesh.triangles);
    else repairNormals(data, mesh.triangles);
    if (lacksTangents(data, options)) addTangents(data, mesh.triangles, options);

    const size_t count = data.positions.size();
    mesh.vertices.resize(count);
    for (size_t v = 0; v < count; ++v) {
        ShadingVertex& out = mesh.vertices[v];
        out.normalOct = shading::octahedral_encode(data.normals[v]);
        // 0: none; kernels/surface.glsl then takes one from the texture coordinates.
        out.tangentOct =
            data.tangents.empty() ? 0 : packTangent(data.normals[v], data.tangents[v]);
        out.uv = data.uv[0].empty() ? glm::vec2(0) : data.uv[0][v];
    }
    mesh.uv1 = std::move(data.uv[1]);
    mesh.colors.resize(data.colors.size());
    for (size_t v = 0; v < data.colors.size(); ++v) mesh.colors[v] = packColor(data.colors[v]);
    mesh.positions = std::move(data.positions);
    mesh.positions.emplace_back(0.0f);
    mesh.givenVertex.clear();
    if (options.updatable) mesh.givenVertex = std::move(data.given);
    ++mesh.revision;
}

void updateTexCoords(Mesh& mesh, uint32_t set, const std::vector<glm::vec2>& given) {
    std::vector<glm::vec2> uv = given;
    if (!given.empty()) gather(uv, mesh.givenVertex);
    const bool turns = mesh.tangentsGenerated && mesh.options.tangentUv == set &&
                       !onlyMoved(mesh, set, uv);
    std::vector<uint32_t> tangents;
    if (turns) tangents = tangentsOf(mesh, uv);  // all that may fail comes before the first change
    if (turns)
        for (size_t v = 0; v < tangents.size(); ++v) mesh.vertices[v].tangentOct = tangents[v];
    if (set == 1) {
        mesh.uv1 = std::move(uv);
        return;
    }
    for (size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v].uv = uv.empty() ? glm::vec2(0) : uv[v];
}

void exchangeVertices(Mesh& mesh, Mesh& fresh) noexcept {
    const bool joined = mesh.triangles == fresh.triangles &&
                        mesh.positions.size() == fresh.positions.size();
    if (!joined) ++mesh.topologyRevision;
    mesh.positions.swap(fresh.positions);
    mesh.triangles.swap(fresh.triangles);
    mesh.vertices.swap(fresh.vertices);
    mesh.uv1.swap(fresh.uv1);
    mesh.colors.swap(fresh.colors);
    mesh.givenVertex.swap(fresh.givenVertex);
    mesh.givenCount = fresh.givenCount;
    mesh.options = fresh.options;
    mesh.tangentsGenerated = fresh.tangentsGenerated;
    ++mesh.revision;
}

}  // namespace gp
