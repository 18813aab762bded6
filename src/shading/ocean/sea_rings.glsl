// The triangles of the sea around a viewer: a middle and rings of equal sectors whose radii grow by
// one factor. From a triangle to its place on the water at rest, and back, so that what is
// remembered of one point of the water is found again when the rings have gone on with the camera.
// They are a lattice (scene/lattice.h): row 0 is the middle, row i + 1 ring i, columns are sectors.
// Two triangles for each cell, (a, c, b) and (d, b, c): a and b are neighbours in its row, c and d
// those further out.
#ifndef GP_SHADING_OCEAN_SEA_RINGS_GLSL
#define GP_SHADING_OCEAN_SEA_RINGS_GLSL
#include "shading/trigonometry.glsl"

// In heights of the viewer. The outermost ring is seen 0.2 mrad below the horizontal, a tenth of a
// pixel or so; the innermost one lies at the viewer's feet.
#define SEA_INNERMOST_RING 0.1f
#define SEA_OUTERMOST_RING 5000.0f

struct SeaRings {
    uint sectors;
    uint rings;
    float growth;   // radius of a ring over that of the one inside of it
    float height;   // of the viewer, metres
};

// A point of the sea's mesh, as a ray meets it.
struct SeaTriangle {
    uint number;
    float u;
    float v;
    uint exists;    // 0: beyond the outermost ring
};

// Cells are as long as wide.
float sea_rings_growth(uint sectors) {
    return 1.0f + TWO_PI / float(sectors);
}

float sea_ring_radius(IN(SeaRings) g, uint ring) {
    return SEA_INNERMOST_RING * g.height * pow(g.growth, float(ring));
}

// Of a vertex, from the middle: (towards +X, towards -Z).
vec2 sea_ring_vertex(IN(SeaRings) g, uint row, uint sector) {
    if (row == 0u) { return vec2(0.0f); }
    SinCos phi = sincos_turns(float(sector) / float(g.sectors));
    return vec2(phi.c, phi.s) * sea_ring_radius(g, row - 1u);
}

// Where a point of a triangle is on the water at rest, metres from the middle.
vec2 sea_place_of_triangle(IN(SeaRings) g, uint number, float u, float v) {
    uint row = number / 2u / g.sectors;
    uint sector = number / 2u - row * g.sectors;
    vec2 b = sea_ring_vertex(g, row, sector + 1u);
    vec2 c = sea_ring_vertex(g, row + 1u, sector);
    if ((number & 1u) == 0u) {
        return sea_ring_vertex(g, row, sector) * (1.0f - u - v) + c * u + b * v;
    }
    return sea_ring_vertex(g, row + 1u, sector + 1u) * (1.0f - u - v) + b * u + c * v;
}

// Barycentric coordinates of p in the triangle 0, e1, e2.
vec2 sea_barycentrics(vec2 p, vec2 e1, vec2 e2) {
    float scale = 1.0f / (e1.x * e2.y - e1.y * e2.x);
    return vec2((p.x * e2.y - p.y * e2.x) * scale, (e1.x * p.y - e1.y * p.x) * scale);
}

// `at`: barycentric coordinates that rounding may have carried out of the triangle.
SeaTriangle sea_triangle(uint number, vec2 at, bool exists) {
    SeaTriangle t;
    t.number = number;
    t.u = clamp(at.x, 0.0f, 1.0f);
    t.v = clamp(at.y, 0.0f, 1.0f - t.u);
    t.exists = exists ? 1u : 0u;
    return t;
}

// The triangle over a place on the water at rest, metres from the middle.
SeaTriangle sea_triangle_at(IN(SeaRings) g, vec2 place) {
    uint n = g.sectors;
    float turns = turns_from_vector(place.y, place.x);
    turns = turns < 0.0f ? turns + 1.0f : turns;
    uint sector = min(uint(turns * float(n)), n - 1u);
    vec2 v0 = sea_ring_vertex(g, 1u, sector);
    vec2 v1 = sea_ring_vertex(g, 1u, sector + 1u);
    // Rings are polygons: this is how much larger than the innermost the one through the place is.
    float size = dot(place, v0 + v1) / (0.5f * dot(v0 + v1, v0 + v1));
    float ring = size >= 1.0f ? floor(log(size) / log(g.growth)) : -1.0f;
    bool exists = ring < float(g.rings - 1u);
    uint row = exists ? uint(ring + 1.0f) : g.rings - 1u;
    vec2 b = sea_ring_vertex(g, row, sector + 1u);
    vec2 c = sea_ring_vertex(g, row + 1u, sector);
    vec2 diagonal = c - b;
    vec2 p = place - b;
    uint number = 2u * (row * n + sector);
    // Of the cells of the middle the second triangle is all.
    if (row > 0u && diagonal.x * p.y - diagonal.y * p.x <= 0.0f) {
        vec2 a = sea_ring_vertex(g, row, sector);
        return sea_triangle(number, sea_barycentrics(place - a, c - a, b - a), exists);
    }
    vec2 d = sea_ring_vertex(g, row + 1u, sector + 1u);
    return sea_triangle(number + 1u, sea_barycentrics(place - d, b - d, c - d), exists);
}

#endif
