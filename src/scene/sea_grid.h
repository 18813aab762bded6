// The triangles of a sea around a viewer: rings of equal sectors whose radii grow by one factor, so
// that cells have one shape and one angular size from the viewer's feet to the horizon. There is
// one topology for ever, and no ring meets a finer one: nothing can crack. Which triangle is where
// says shading/ocean/sea_rings.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

struct SeaGrid {
    uint32_t sectors = 0;       // cells around
    uint32_t rings = 0;
    float growth = 1;           // radius of a ring over that of the one inside of it

    size_t vertexCount() const { return 1 + size_t(rings) * sectors; }
    size_t triangleCount() const { return size_t(sectors) * (2 * rings - 1); }
    // For a viewer `height` metres above the sea (seaGridHeight has limited it).
    float radius(uint32_t ring, float height) const;
    // The side of a cell at that ring, metres.
    float cell(uint32_t ring, float height) const { return radius(ring, height) * (growth - 1); }
};

inline constexpr uint32_t seaSectorsLeast = 16, seaSectorsMost = 2048;

// About ln(50,000) / (2 pi) sectors^2 vertices: 256,000 of 384 sectors.
SeaGrid seaGrid(uint32_t sectors);

// The height that the grid is made for: at least a metre, at most 100 km.
float seaGridHeight(float height);

// Vertices: the middle, then ring after ring, each from +X towards -Z. Seen from above, triangles
// run counter-clockwise.
std::vector<glm::uvec3> seaGridTriangles(const SeaGrid& grid);
// Where the vertices are around the viewer's feet: (towards +X, towards -Z) in metres.
std::vector<glm::vec2> seaGridPoints(const SeaGrid& grid, float height);

}  // namespace gp
