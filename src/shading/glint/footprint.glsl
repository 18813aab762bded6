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

// The quadric matrix of the ellipse, in the units of uv.
struct GlintFootprint {
    float xx;
    float xy;
    float yy;
    float minor;  // half of its shorter axis
};

GlintFootprint glint_footprint(vec2 d0, vec2 d1) {
    FootprintEllipse e = footprint_ellipse(d0, d1);
    GlintFootprint f;
    f.minor = max(e.minor, e.major * (1.0f / GLINT_ANISOTROPY));
    float minor2 = f.minor * f.minor;
    float along = e.major * e.major - minor2;
    f.xx = minor2 + along * e.axis.x * e.axis.x;
    f.xy = along * e.axis.x * e.axis.y;
    f.yy = minor2 + along * e.axis.y * e.axis.y;
    return f;
}

// The ellipse over the cells of one level, in cells, whose centres lie on integers.
struct Ellipse {
    vec2 centre;
    float a;       // r^2 = a x^2 + b x y + c y^2, 1 on its edge
    float b;
    float c;
    float skew;    // x of the middle of its rows, by y
    float width;   // half of the row through the centre
    float height;  // half
    int first;     // y of the first row
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
    float xx = f.xx * area + filter_area;
    float xy = f.xy * area;
    float yy = f.yy * area + filter_area;
    float det = xx * yy - xy * xy;
    e.a = yy / det;
    e.b = -2.0f * xy / det;
    e.c = xx / det;
    e.skew = xy / yy;
    e.width = sqrt(det / yy);
    e.height = sqrt(yy);
    e.first = ellipse_floor(e.centre.y - e.height) + 1;
    e.last = ellipse_floor(e.centre.y + e.height);
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
    float reach = ty / e.height;
    float half_width = e.width * sqrt(max(1.0f - reach * reach, 0.0f));
    float middle = e.centre.x + e.skew * ty;
    EllipseRow row;
    row.start = ellipse_floor(middle - half_width) + 1;
    row.end = ellipse_floor(middle + half_width);
    return row;
}

// exp(-2 r^2) - exp(-2) inside, 0 outside, as a polynomial with an error of 8e-4, so that
// compilers make vectors of it.
IN_LOOPS float ellipse_weight(IN(Ellipse) e, int x, int y) {
    float tx = float(x) - e.centre.x;
    float ty = float(y) - e.centre.y;
    float r2 = e.a * tx * tx + e.b * tx * ty + e.c * ty * ty;
    float q = 0.726143578f - 0.210595288f * r2;
    return max(1.0f - r2, 0.0f) * (0.863861068f + r2 * (-1.109311026f + r2 * q));
}

#endif
