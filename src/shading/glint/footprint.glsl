// Which cells of a grid a pixel covers, and how much of each: an ellipse with Gaussian weights, at
// the two levels of a pyramid of cells around the one whose cells are as wide as it is narrow.
// Based on: Heckbert 1989, "Fundamentals of Texture Mapping and Image Warping" (EWA), section 3.5;
// the axes are those of the ellipse, not the two derivatives, which need not be orthogonal.
#ifndef GP_SHADING_GLINT_FOOTPRINT_GLSL
#define GP_SHADING_GLINT_FOOTPRINT_GLSL
#include "shading/slope/footprint.glsl"

// Longer ellipses are made wider: the number of cells stays below 100 and nothing is cut off.
#define GLINT_ANISOTROPY 4.0f
// What is taken of the area of the published ellipse (radii of a pixel and of a cell): less is
// nearer to a pixel's own box and has fewer cells. At 0.5 an ellipse may lie between all cells, and
// pictures flicker by a tenth and more.
#define GLINT_FILTER 0.7f

// The matrix of the ellipse, in the units of uv.
struct GlintFootprint {
    float xx;
    float xy;
    float yy;
    float minor2;  // the square of half of its shorter axis
};

GlintFootprint glint_footprint(vec2 d0, vec2 d1) {
    FootprintSpread s = footprint_spread(d0, d1);
    float major2 = s.half_sum + s.radius;
    float minor2 = major2 > 0.0f ? min(s.area * (s.area / major2), major2) : 0.0f;
    // Cosine and sine of twice the angle of the longer axis.
    float inv_radius = s.radius > 0.0f ? 1.0f / s.radius : 0.0f;
    float c = clamp(s.half_difference * inv_radius, -1.0f, 1.0f);
    GlintFootprint f;
    f.minor2 = max(minor2, major2 * (1.0f / (GLINT_ANISOTROPY * GLINT_ANISOTROPY)));
    float along = 0.5f * (major2 - f.minor2);
    f.xx = f.minor2 + along * (1.0f + c);
    f.xy = along * clamp(s.xy * inv_radius, -1.0f, 1.0f);
    f.yy = f.minor2 + along * (1.0f - c);
    return f;
}

// The ellipse over the cells of one level, in cells, whose centres lie on integers.
struct Ellipse {
    vec2 centre;
    float skew;     // x of the middle of its rows, by y
    float width2;   // the square of half of the row through the centre
    float inv_width2;
    float inv_height2;  // of half of its height
    int first;      // y of the first row
    int last;
};

// Of any number of cells; conversion rounds to zero.
IN_LOOPS int ellipse_floor(float x) {
    int i = int(x);
    return i - int(x < float(i));
}

// Filter and the cell's own reconstruction: both matrices are added. uv is limited to where floats
// still tell cells apart.
Ellipse ellipse_of(IN(GlintFootprint) f, vec2 uv, float cells, float filter_area) {
    Ellipse e;
    e.centre = vec2(clamp(uv.x * cells, -4.0e6f, 4.0e6f) - 0.5f,
                    clamp(uv.y * cells, -4.0e6f, 4.0e6f) - 0.5f);
    float area = filter_area * cells * cells;
    float xy = f.xy * area;
    float height2 = f.yy * area + filter_area;
    e.inv_height2 = 1.0f / height2;
    e.skew = xy * e.inv_height2;
    // The determinant over the height; never less than the filter's own, but for rounding.
    e.width2 = max(f.xx * area + filter_area - xy * e.skew, filter_area);
    e.inv_width2 = 1.0f / e.width2;
    float height = sqrt(height2);
    e.first = ellipse_floor(e.centre.y - height) + 1;
    e.last = ellipse_floor(e.centre.y + height);
    return e;
}

int ellipse_rows(IN(Ellipse) e) {
    return e.last - e.first + 1;
}

// The x of the first and the last cell of a row.
struct EllipseRow {
    int start;
    int end;
};

IN_LOOPS EllipseRow ellipse_row(IN(Ellipse) e, int y) {
    float ty = float(y) - e.centre.y;
    float half_width = sqrt(max(e.width2 - e.width2 * e.inv_height2 * ty * ty, 0.0f));
    float middle = e.centre.x + e.skew * ty;
    EllipseRow row;
    row.start = ellipse_floor(middle - half_width) + 1;
    row.end = ellipse_floor(middle + half_width);
    return row;
}

// One of two, in loops: all but the first and last rows.
IN_LOOPS Ellipse ellipse_either(IN(Ellipse) a, IN(Ellipse) b, bool second) {
    Ellipse e = a;
    e.centre.x = second ? b.centre.x : a.centre.x;
    e.centre.y = second ? b.centre.y : a.centre.y;
    e.skew = second ? b.skew : a.skew;
    e.width2 = second ? b.width2 : a.width2;
    e.inv_width2 = second ? b.inv_width2 : a.inv_width2;
    e.inv_height2 = second ? b.inv_height2 : a.inv_height2;
    return e;
}

// exp(-2 r^2) - exp(-2) inside, 0 outside, as a polynomial with an error of 8e-4, so that
// compilers make vectors of it. r^2 by the completed square: r is 1 on the edge.
IN_LOOPS float ellipse_weight(IN(Ellipse) e, int x, int y) {
    float ty = float(y) - e.centre.y;
    float tx = float(x) - e.centre.x - e.skew * ty;
    float r2 = e.inv_width2 * tx * tx + e.inv_height2 * ty * ty;
    float q = 0.726143578f - 0.210595288f * r2;
    return max(1.0f - r2, 0.0f) * (0.863861068f + r2 * (-1.109311026f + r2 * q));
}

#endif
