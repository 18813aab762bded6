#include "mesh.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <map>
#include <tuple>

namespace gp::make_scene {
namespace {

glm::vec3 perpendicular(glm::vec3 unit)
{
    const glm::vec3 other = std::abs(unit.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    return glm::normalize(glm::cross(other, unit));
}

}  // namespace

std::uint32_t Mesh::addVertex(glm::vec3 position, glm::vec3 normal, glm::vec2 uv)
{
    positions.push_back(position);
    normals.push_back(normal);
    uvs.push_back(uv);
    return static_cast<std::uint32_t>(positions.size() - 1);
}

void Mesh::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const glm::vec3 &pa = positions[a], &pb = positions[b], &pc = positions[c];
    if (pa == pb || pb == pc || pc == pa)
        return;
    indices.insert(indices.end(), {a, b, c});
}

void Mesh::addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    addTriangle(a, b, c);
    addTriangle(a, c, d);
}

void Mesh::addGridQuads(int columns, int rows)
{
    const auto first = static_cast<std::uint32_t>(positions.size()) -
                       static_cast<std::uint32_t>(columns * rows);
    const auto width = static_cast<std::uint32_t>(columns);
    for (std::uint32_t j = 0; j + 1 < static_cast<std::uint32_t>(rows); ++j)
        for (std::uint32_t i = 0; i + 1 < width; ++i) {
            const std::uint32_t corner = first + j * width + i;
            addQuad(corner, corner + 1, corner + 1 + width, corner + width);
        }
}

void Mesh::append(const Mesh& other)
{
    const auto base = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const std::uint32_t index : other.indices)
        indices.push_back(base + index);
}

Mesh& Mesh::transform(const glm::mat4& worldFromObject)
{
    const glm::mat3 linear(worldFromObject);
    const glm::mat3 normalMatrix = glm::transpose(glm::inverse(linear));
    for (glm::vec3& p : positions)
        p = glm::vec3(worldFromObject * glm::vec4(p, 1.0f));
    for (glm::vec3& n : normals)
        n = glm::normalize(normalMatrix * n);
    if (glm::determinant(linear) < 0.0f)  // a mirror image: keep the outside outside
        for (std::size_t i = 0; i < indices.size(); i += 3)
            std::swap(indices[i + 1], indices[i + 2]);
    return *this;
}

Mesh& Mesh::scaleUv(glm::vec2 factor, glm::vec2 offset)
{
    for (glm::vec2& uv : uvs)
        uv = uv * factor + offset;
    return *this;
}

void Mesh::flip()
{
    for (glm::vec3& n : normals)
        n = -n;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        std::swap(indices[i + 1], indices[i + 2]);
}

void Mesh::computeSmoothNormals()
{
    std::map<std::tuple<float, float, float>, glm::vec3> sums;
    const auto key = [](glm::vec3 p) { return std::make_tuple(p.x, p.y, p.z); };
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const glm::vec3 p[3] = {positions[indices[i]], positions[indices[i + 1]],
                                positions[indices[i + 2]]};
        const glm::vec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
        for (const glm::vec3& corner : p)
            sums[key(corner)] += area;
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3 sum = sums[key(positions[i])];
        const float length = glm::length(sum);
        normals[i] = length > 0.0f ? sum / length : glm::vec3(0, 1, 0);
    }
}

void Mesh::computeTangents()
{
    std::vector<glm::vec3> sums(positions.size(), glm::vec3(0.0f));
    std::vector<float> sides(positions.size(), 1.0f);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
        const glm::vec2 d1 = uvs[b] - uvs[a], d2 = uvs[c] - uvs[a];
        const float side = d1.x * d2.y - d1.y * d2.x < 0.0f ? -1.0f : 1.0f;
        const glm::vec3 along = (positions[b] - positions[a]) * d2.y -
                                (positions[c] - positions[a]) * d1.y;
        for (const std::uint32_t corner : {a, b, c}) {
            sums[corner] += along * side;
            sides[corner] = side;
        }
    }
    tangents.clear();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3 n = normals[i], t = sums[i] - n * glm::dot(n, sums[i]);
        const float length = glm::length(t);
        // Where nothing grows along u, any direction in the surface will do. In glTF the bitangent
        // points up, against v.
        tangents.emplace_back(length > 1e-12f ? t / length : perpendicular(n), -sides[i]);
    }
}

void Mesh::makeFlat()
{
    Mesh flat;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
        const glm::vec3 n = glm::normalize(
            glm::cross(positions[b] - positions[a], positions[c] - positions[a]));
        for (const std::uint32_t corner : {a, b, c})
            flat.indices.push_back(flat.addVertex(positions[corner], n, uvs[corner]));
    }
    *this = std::move(flat);
}

void Mesh::removeUnusedVertices()
{
    std::vector<std::uint32_t> newIndex(positions.size(), ~0u);
    Mesh packed;
    for (const std::uint32_t index : indices) {
        if (newIndex[index] == ~0u)
            newIndex[index] = packed.addVertex(positions[index], normals[index], uvs[index]);
        packed.indices.push_back(newIndex[index]);
    }
    *this = std::move(packed);
}

glm::mat4 translation(glm::vec3 offset) { return glm::translate(glm::mat4(1.0f), offset); }
glm::mat4 translation(float x, float y, float z) { return translation(glm::vec3(x, y, z)); }
glm::mat4 scaling(glm::vec3 factors) { return glm::scale(glm::mat4(1.0f), factors); }

glm::mat4 rotationX(float angle)
{
    return glm::rotate(glm::mat4(1.0f), angle, glm::vec3(1, 0, 0));
}
glm::mat4 rotationY(float angle)
{
    return glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0, 1, 0));
}
glm::mat4 rotationZ(float angle)
{
    return glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0, 0, 1));
}

glm::mat4 rotationFromY(glm::vec3 axis)
{
    const glm::vec3 y = glm::normalize(axis);
    const glm::vec3 z = perpendicular(y);
    const glm::vec3 x = glm::cross(y, z);
    return glm::mat4(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(0, 0, 0, 1));
}

}  // namespace gp::make_scene
