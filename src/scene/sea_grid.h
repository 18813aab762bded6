// The triangles of a sea around a viewer: rings of equal sectors whose radii grow by one factor, so
// that cells have one shape and one angular size from the viewer's feet to the horizon. There is
// one topology for ever, and no ring meets a finer one: nothing can crack. Which triangle is where
// says shading/ocean/sea_rings.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/lattice.h"

namespace gp {

struct SeaGrid {
    uint32_t sectors = 0;       // cells around
    uint32_t rings = 0;
    float growth = 1;           // radius of a ring over that of the one inside of it

    // A row for the viewer's feet and one for each ring; the first column again as the last.
    Lattice lattice() const { return {sectors + 1, rings + 1}; }
    size_t vertexCount() const { return size_t(sectors + 1) * (rings + 1); }
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

// Where the vertices are around the viewer's feet: (towards +X, towards -Z) in metres. The middle,
// then ring after ring, each from +X towards -Z; seen from above, triangles (latticeTriangles) run
// counter-clockwise. All of the middle are one point, so that half of the triangles there are none.
std::vector<glm::vec2> seaGridPoints(const SeaGrid& grid, float height);

}  // namespace gp
