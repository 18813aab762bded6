// The triangles of the sea around a viewer: a middle vertex and rings of equal sectors whose radii
// grow by one factor. From a triangle to its place on the water at rest, and back, so that what is
// remembered of one point of the water is found again when the rings have gone on with the camera.
// Vertices: the middle, then ring after ring. Triangles: those of the middle, sector by sector,
// then two for each cell: (a, outer a, outer b), (a, outer b, b).
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
vec2 sea_ring_vertex(IN(SeaRings) g, uint ring, uint sector) {
    SinCos phi = sincos_turns(float(sector) / float(g.sectors));
    return vec2(phi.c, phi.s) * sea_ring_radius(g, ring);
}

// Where a point of a triangle is on the water at rest, metres from the middle.
vec2 sea_place_of_triangle(IN(SeaRings) g, uint number, float u, float v) {
    uint n = g.sectors;
    if (number < n) {
        return sea_ring_vertex(g, 0u, number) * u + sea_ring_vertex(g, 0u, number + 1u) * v;
    }
    uint cell = (number - n) / 2u;
    uint ring = cell / n;
    uint sector = cell - ring * n;
    vec2 outer_b = sea_ring_vertex(g, ring + 1u, sector + 1u);
    bool first = ((number - n) & 1u) == 0u;
    vec2 second = first ? sea_ring_vertex(g, ring + 1u, sector) : outer_b;
    vec2 third = first ? outer_b : sea_ring_vertex(g, ring, sector + 1u);
    return sea_ring_vertex(g, ring, sector) * (1.0f - u - v) + second * u + third * v;
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
    vec2 v0 = sea_ring_vertex(g, 0u, sector);
    vec2 v1 = sea_ring_vertex(g, 0u, sector + 1u);
    // Rings are polygons: this is how much larger than the innermost the one through the place is.
    float size = dot(place, v0 + v1) / (0.5f * dot(v0 + v1, v0 + v1));
    if (!(size >= 1.0f)) { return sea_triangle(sector, sea_barycentrics(place, v0, v1), true); }
    float ring = floor(log(size) / log(g.growth));
    bool exists = ring < float(g.rings - 1u);
    uint i = exists ? uint(ring) : g.rings - 2u;
    vec2 a = sea_ring_vertex(g, i, sector);
    vec2 diagonal = sea_ring_vertex(g, i + 1u, sector + 1u) - a;
    vec2 p = place - a;
    uint number = n + 2u * (i * n + sector);
    if (diagonal.x * p.y - diagonal.y * p.x <= 0.0f) {
        vec2 outer = sea_ring_vertex(g, i + 1u, sector) - a;
        return sea_triangle(number, sea_barycentrics(p, outer, diagonal), exists);
    }
    vec2 along = sea_ring_vertex(g, i, sector + 1u) - a;
    return sea_triangle(number + 1u, sea_barycentrics(p, diagonal, along), exists);
}

#endif
