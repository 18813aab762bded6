// Meshes whose vertices are a lattice: rows of columns, one after another. What traces rays can
// hold them as such (backend/cpu/lattice_hit.h), which is built in an eighth of the time.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

struct Lattice {
    uint32_t columns = 0;  // of vertices; 0: not a lattice
    uint32_t rows = 0;
};

// Two triangles for each cell, cell by cell along the rows. Of its corners a, b (the next column),
// c and d (a's and b's in the next row): (a, c, b) and (d, b, c).
inline std::vector<glm::uvec3> latticeTriangles(const Lattice& lattice) {
    std::vector<glm::uvec3> triangles;
    const uint32_t n = lattice.columns;
    triangles.reserve(size_t(2) * (n - 1) * (lattice.rows - 1));
    for (uint32_t row = 0; row + 1 < lattice.rows; ++row)
        for (uint32_t column = 0; column + 1 < n; ++column) {
            const uint32_t a = row * n + column, b = a + 1, c = a + n, d = b + n;
            triangles.emplace_back(a, c, b);
            triangles.emplace_back(d, b, c);
        }
    return triangles;
}

}  // namespace gp
