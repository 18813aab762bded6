// Triangles of one material, ready for tracing and shading.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene/lattice.h"
#include "scene/material.h"

namespace gp {

// What may change from frame to frame; decides how acceleration structures are built.
enum class MeshKind : uint8_t {
    staticMesh,  // nothing
    movable,     // the transforms of its instances
    dynamic,     // its vertices too
};

// What a vertex gives to shading beside its position: 16 bytes.
struct ShadingVertex {
    uint32_t normalOct;   // octahedral, 2 x 16 bit (shading/frame.glsl)
    uint32_t tangentOct;  // octahedral and the sign of the bitangent (tangent_encode)
    glm::vec2 uv;
};

// Plain arrays, as files and applications give them. Empty: absent.
struct MeshData {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   // absent: flat normals are generated (glTF 2.0, 3.7.2.1)
    std::vector<glm::vec4> tangents;  // w: sign of the bitangent; absent: generated (MeshOptions)
    std::vector<glm::vec2> uv[2];
    std::vector<glm::vec4> colors;    // linear RGBA
    std::vector<uint32_t> indices;    // three a triangle; absent: vertices in order
    std::vector<uint32_t> given;      // by fillMesh: what each vertex is a copy of; empty: itself
};

// What makeMesh must know of the material to generate tangents.
struct MeshOptions {
    bool needsTangents = false;  // a normal map or anisotropy is there
    uint32_t tangentUv = 0;      // which uv set they follow
    glm::mat3x2 uvTransform{1, 0, 0,
                            1, 0, 0};  // the normal map's; turns generated tangents with it
    bool updatable = false;      // keeps what updateTexCoords needs
};

struct Mesh {
    uint64_t id = 0;
    std::string name;
    MeshKind kind = MeshKind::staticMesh;
    std::shared_ptr<const Material> material;

    std::vector<glm::vec3> positions;  // one element more than vertices: Embree reads 16 bytes
    std::vector<glm::uvec3> triangles;
    Lattice lattice;                   // where the vertices are one, the triangles are its cells'
    std::vector<ShadingVertex> vertices;
    std::vector<glm::vec2> uv1;        // empty: none
    std::vector<glm::u8vec4> colors;   // linear RGBA, unorm; empty: none
    uint64_t revision = 0;             // grows each time the vertices change,
    uint64_t topologyRevision = 0;     // this one when the triangles join other vertices too

    // Of the sea, which goes with the viewer: a vertex is another point of it at each revision.
    // `before` is where the points of now were at `beforeRevision`; empty: nobody asked.
    bool wanders = false;
    std::vector<glm::vec3> before;
    uint64_t beforeRevision = 0;

    // Of updatable meshes: the vertex that was given of which each is a copy (empty: itself), how
    // many were given, and how tangents were made of the coordinates.
    std::vector<uint32_t> givenVertex;
    size_t givenCount = 0;
    MeshOptions options;
    bool tangentsGenerated = false;

    size_t vertexCount() const { return vertices.size(); }
};

// Gives `mesh` the vertices and triangles of `fresh`, which gets the old ones. Whatever a mesh has
// beside them stays.
void exchangeVertices(Mesh& mesh, Mesh& fresh) noexcept;

// Checks nothing (callers have: finite positions, indices in range), generates what is missing,
// drops no triangle. Generation may split vertices.
void fillMesh(Mesh& mesh, MeshData&& data, const MeshOptions& options);

// New coordinates of set 0 or 1 for an updatable mesh, one for each given vertex, or none: zeros.
// Triangles and positions stay where they are, because acceleration structures read them in place;
// so vertices cannot be split anew, and where generated tangents would need that, all are left to
// the kernels, which then take them from each triangle.
void updateTexCoords(Mesh& mesh, uint32_t set, const std::vector<glm::vec2>& given);

// Generates the tangents that fillMesh would, for what is deformed afterwards: its triangles then
// keep their vertices over time. Returns, for each vertex that there is now, the one that it was,
// since generation may split vertices; empty where nothing was to be done.
std::vector<uint32_t> giveTangents(MeshData& data, const MeshOptions& options);

}  // namespace gp
