// Tangents for normal maps and anisotropy.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

struct TangentInput {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;  // unit length
    std::span<const glm::vec2> uv;
    std::span<const glm::uvec3> triangles;
};

// One tangent for each corner, three a triangle: xyz is unit length and orthogonal to the normal,
// w the sign in bitangent = w * cross(normal, tangent), which is the direction in which v falls
// (up in a picture). Corners with equal position, normal and uv get the same tangent as long as
// their triangles have the same handedness; where texture space is mirrored they get two.
std::vector<glm::vec4> generateTangents(const TangentInput& in);

}  // namespace gp
