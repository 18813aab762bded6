// Lattices as Embree's grids: part of the hot code, included inside an unnamed namespace by
// isa/kernels.h only. Each of Embree's primitives is a block of 2 x 2 cells (fewer at the edges),
// which its u and v span; blocks stand in rows (CpuScene::buildMesh makes them).

// A cell of corners a, b, c, d (scene/lattice.h) is traced as the triangles (a, b, c) and
// (d, c, b); which of them a ray met follows from where. [Embree 3.13, RTC_GEOMETRY_TYPE_GRID and
// RTC_GEOMETRY_TYPE_QUAD]
inline void latticeHit(const GeometryView& g, Hit& h) {
    const uint32_t cells = g.latticeColumns - 1, blocks = (cells + 1) / 2;
    const uint32_t row = 2 * (h.primitive / blocks), column = 2 * (h.primitive % blocks);
    const uint32_t wide = std::min(2u, cells - column);
    const uint32_t high = std::min(2u, g.latticeRows - 1 - row);
    const float x = h.u * float(wide), y = h.v * float(high);
    const uint32_t right = std::min(uint32_t(x), wide - 1), down = std::min(uint32_t(y), high - 1);
    const float u = x - float(right), v = y - float(down);
    const bool second = u + v > 1.0f;
    h.primitive = 2 * ((row + down) * cells + column + right) + (second ? 1u : 0u);
    // Our triangles run the other way around: (a, c, b) and (d, b, c).
    h.u = second ? 1.0f - v : v;
    h.v = second ? 1.0f - u : u;
}
