// Choosing a cell of a large alias table and a point in it from one pair of random numbers.
#ifndef GP_SHADING_SAMPLING_ALIAS_GLSL
#define GP_SHADING_SAMPLING_ALIAS_GLSL
#include "shading/constants.glsl"

struct AliasPick {
    uint index;  // of the entry
    float rest;  // in [0, 1): below the entry's threshold the cell itself, else its alias
    float row;   // in (0, 1): across the cell
};

// The index uses up the leading bits of u.x: of 24, a table of 512 x 512 leaves 6 for the choice
// between a cell and its alias, too few for the density to be true. The trailing bits of u.y, which
// positions finer than 1 / 4096 of a cell have no use for, take their place.
AliasPick alias_pick(vec2 u, uint count) {
    float scaled = u.x * float(count);
    float fine = u.y * 4096.0f;
    AliasPick p;
    p.index = min(uint(scaled), count - 1u);
    p.rest = scaled - float(p.index) + (fine - floor(fine)) * float(count) * EXP2_MINUS_24;
    p.rest = clamp(p.rest, 0.0f, ONE_MINUS_EPSILON);
    p.row = (floor(fine) + 0.5f) / 4096.0f;
    return p;
}

#endif
