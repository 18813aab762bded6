// Pictures side by side with titles, axes and a scale of colours: one sheet, drawn by gnuplot.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gp::tool {

using Rgb8 = std::array<unsigned char, 3>;

// sRGB-encoded, 0 to 1; clipped there.
Rgb8 rgb8FromSrgb(const glm::vec3& srgb);

struct GridPicture {
    std::string title;         // above it; broken into lines where it is too long
    unsigned width = 0, height = 0;
    std::vector<Rgb8> pixels;  // top row first, as they are to be seen (sRGB)
};

// What the edges of the pictures stand for; the same for all of them. The maxima are right and up.
// In labels of axes and bars, _ makes a subscript.
struct PictureAxes {
    std::string xLabel, yLabel;
    double xMinimum = 0, xMaximum = 1, yMinimum = 0, yMaximum = 1;
    double step = 0;           // between two marks; 0: gnuplot chooses
};

struct ColorBar {
    std::string label;
    double minimum = 0, maximum = 1;
    std::vector<Rgb8> colors;  // from minimum to maximum
};

struct PictureGrid {
    std::string title;                   // of the sheet; may be empty
    unsigned columns = 1;
    std::vector<GridPicture> pictures;   // row after row; a picture without pixels is a gap
    std::vector<std::string> rowTitles;  // left of the rows; none, or one a row
    std::optional<PictureAxes> axes;
    std::optional<ColorBar> bar;
};

// A pixel of a picture is a pixel of the sheet; gnuplot softens those of its edge. .png or .svg;
// throws as drawWithGnuplot does.
void drawPictureGrid(const PictureGrid& grid, const std::string& path);

}  // namespace gp::tool
