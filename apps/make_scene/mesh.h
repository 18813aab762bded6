// A triangle mesh in the making. Counter-clockwise triangles seen from outside, unit normals.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gp::make_scene {

struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec4> tangents;  // as glTF has them; most meshes need none
    std::vector<std::uint32_t> indices;

    std::uint32_t addVertex(glm::vec3 position, glm::vec3 normal, glm::vec2 uv);
    // Left out when it has no area: poles and pinched rows of a grid need no special case then.
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    // Quads between the last `columns` * `rows` vertices, given row by row. The surface faces
    // the side from which "along the row" and then "to the next row" turns counter-clockwise.
    void addGridQuads(int columns, int rows);

    void append(const Mesh& other);
    Mesh& transform(const glm::mat4& worldFromObject);
    Mesh& scaleUv(glm::vec2 factor, glm::vec2 offset = glm::vec2(0.0f));
    void flip();  // inside out
    // Vertices at one place share the mean of the normals of all triangles that meet there.
    void computeSmoothNormals();
    // Along u, for everything that has a direction. To be called last: nothing else keeps them.
    void computeTangents();
    void makeFlat();  // three vertices of its own for every triangle, with its geometric normal
    // Drops what no triangle uses.
    void removeUnusedVertices();
};

glm::mat4 translation(glm::vec3 offset);
glm::mat4 translation(float x, float y, float z);
glm::mat4 scaling(glm::vec3 factors);
glm::mat4 rotationX(float angle);
glm::mat4 rotationY(float angle);
glm::mat4 rotationZ(float angle);
// Takes +Y to `axis`: lathe-turned things are made upright.
glm::mat4 rotationFromY(glm::vec3 axis);

}  // namespace gp::make_scene
